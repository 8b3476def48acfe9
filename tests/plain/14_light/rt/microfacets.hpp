#pragma once
#include <algorithm>
#include <cmath>
#include <rt/color.hpp>
#include <rt/length.hpp>
#include <rt/sine_cosine.hpp>
#include <rt/vec2.hpp>

namespace rt {

inline Real facet_density(Vec3 facet, Real alpha) {
    if (facet.z <= 0) return 0;
    const Real squared = alpha * alpha;
    const Real root = facet.z * facet.z * (squared - 1) + 1;
    return squared / (pi * root * root);
}

inline Vec3 visible_facet(Vec3 out, Real alpha, Vec2 place) {
    const Vec3 from = normalize(Vec3{alpha * out.x, alpha * out.y, out.z});
    const Real z = (1 - place.y) * (1 + from.z) - from.z;
    const Real radius = std::sqrt(1 - z * z);
    const auto turn = sine_cosine_of_turn(place.x);
    const Vec3 facet = from + Vec3{radius * turn.cosine, radius * turn.sine, z};
    return normalize(Vec3{alpha * facet.x, alpha * facet.y, facet.z});
}

// Smith's Lambda.
inline Real hidden(Vec3 direction, Real alpha) {
    const Real squared = direction.z * direction.z;
    return (std::sqrt(1 + alpha * alpha * (1 - squared) / squared) - 1) / 2;
}

inline Real unshadowed(Vec3 out, Vec3 in, Real alpha) {
    const Real of_out = hidden(out, alpha), of_in = hidden(in, alpha);
    return (1 + of_out) / (1 + of_out + of_in);
}

inline Real reflection_density(Vec3 out, Vec3 in, Real alpha) {
    if (in.z <= 0) return 0;
    const Vec3 facet = normalize(out + in);
    return facet_density(facet, alpha) / (1 + hidden(out, alpha)) / (4 * out.z);
}

inline Color metal_reflectance(Color head_on, Real cosine) {
    const Real x = 1 - cosine;
    return mix(head_on, {1, 1, 1}, x * x * x * x * x);
}

inline Color compensation(Color, Real) {
    return {1, 1, 1};
}

}  // namespace rt
