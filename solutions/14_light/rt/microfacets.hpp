#pragma once
#include <algorithm>
#include <cmath>
#include <rt/color.hpp>
#include <rt/length.hpp>
#include <rt/sine_cosine.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Facets: the tiny mirrors that a rough surface is made of. All directions have length 1 and are
// given in the surface's own coordinates, with its normal along z. `out` leads to the eye, and `in`
// to the light. The roughness alpha, from 0.0001 to 1, is the slope of a typical facet.

// How far a direction reaches into a surface that is pressed flat by alpha: sqrt(z^2 + alpha^2 (x^2
// + y^2)).
inline Real pressed_length(Vec3 direction, Real alpha) {
    const Real x = alpha * direction.x, y = alpha * direction.y;
    return std::sqrt(x * x + y * y + direction.z * direction.z);
}

// The area of the facets that face in this direction, per solid angle and per area of the surface.
// It is 0 for a direction that is not above the surface.
// Source: Trowbridge and Reitz, "Average irregularity representation of a rough surface for ray
// reflection", 1975; known as GGX. Here z^2 (alpha^2 - 1) + 1 is written as x^2 + y^2 + alpha^2
// z^2, which does not cancel.
inline Real facet_density(Vec3 facet, Real alpha) {
    if (!(facet.z > 0)) return 0;
    const Real x = facet.x / alpha, y = facet.y / alpha;
    const Real root = alpha * (x * x + y * y + facet.z * facet.z);
    return 1 / (pi * root * root);
}

// The normal of a facet that is seen from `out`: the larger a facet appears from there, the more
// likely it is drawn. `place` is a sample point of the unit square, 0 <= x, y < 1.
// Source: Dupuy and Benyoub, "Sampling visible GGX normals with spherical caps", 2023.
inline Vec3 visible_facet(Vec3 out, Real alpha, Vec2 place) {
    // Stretched until its roughness is 1, the surface has the facets of a ball's upper half. A
    // whole ball reflects the view evenly in all directions, and its upper half in those above
    // -from.z.
    const Vec3 from = normalize(Vec3{alpha * out.x, alpha * out.y, out.z});
    const Real z = (1 - place.y) * (1 + from.z) - from.z;
    const Real radius = std::sqrt(std::max(Real(0), (1 - z) * (1 + z)));
    const auto turn = sine_cosine_of_turn(place.x);
    const Vec3 facet = from + Vec3{radius * turn.cosine, radius * turn.sine, z};
    return normalize(Vec3{alpha * facet.x, alpha * facet.y, std::max(Real(0), facet.z)});
}

// Of the facets that are seen from `out`, the share that `in`, above the surface, reaches as well:
// G2 / G1 by Smith's masking, where a facet that is high up is both easier to see and to reach.
// Source: Heitz, "Understanding the masking-shadowing function in microfacet-based BRDFs", JCGT
// 3(2), 2014; here with the fractions multiplied out.
inline Real unshadowed(Vec3 out, Vec3 in, Real alpha) {
    const Real from = pressed_length(out, alpha), to = pressed_length(in, alpha);
    return in.z * (out.z + from) / (out.z * to + in.z * from);
}

// The probability density of `in`, per solid angle, when light leaves along `out` by a facet from
// visible_facet. It is 0 below the surface.
inline Real reflection_density(Vec3 out, Vec3 in, Real alpha) {
    if (!(in.z > 0)) return 0;
    // G1 D / (4 out.z), where G1 = 2 out.z / (out.z + pressed_length): the cosine cancels.
    return facet_density(normalize(out + in), alpha) / (2 * (out.z + pressed_length(out, alpha)));
}

// The fraction of light that metal reflects, for each channel: `head_on` at a cosine of 1, all of
// it at a cosine of 0. The cosine is that of the angle between a facet's normal and `out`.
// Source: Schlick, "An inexpensive BRDF model for physically-based rendering", 1994.
inline Color metal_reflectance(Color head_on, Real cosine) {
    const Real x = 1 - std::clamp(cosine, Real(0), Real(1));
    return mix(head_on, {1, 1, 1}, x * x * (x * x) * x);
}

// A factor, 1 or more, for the light that comes back only after several bounces among the facets.
// `kept`, in (0, 1], is the share of the light that a single bounce keeps on a white metal.
// Source: Turquin, "Practical multiple scattering compensation for microfacet models", 2019.
inline Color compensation(Color head_on, Real kept) {
    return Color{1, 1, 1} + (1 - kept) / kept * head_on;
}

}  // namespace rt
