#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <rt/dot.hpp>
#include <rt/hit.hpp>
#include <rt/microfacets.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/scatter.hpp>

namespace rt {

// A rough metal of facets (given): see microfacets.hpp.
struct RoughMetal {
    Color color;     // what it reflects head-on, each channel in [0, 1]
    Real alpha = 1;  // how rough it is, from 0.0001 to 1
    // The share of light that a white metal keeps in a single bounce, for cosines from 0 to 1.
    std::array<Real, 33> kept{};
};

// How light from `in` goes on along `out`, on white metal without Fresnel's reflectance, divided by
// the density of `in`; `facet` lies halfway between them. 0 if `in` is not above the surface.
inline Real kept_from(Vec3 out, Vec3 in, Real alpha) {
    return in.z > 0 ? unshadowed(out, in, alpha) : Real(0);
}

inline Vec3 mirrored_at(Vec3 out, Vec3 facet) {
    return 2 * dot(out, facet) * facet - out;
}

// The metal of this color; its roughness, from 0.01 to 1, is the square root of alpha, so that
// equal steps of it look equal.
inline RoughMetal make_rough_metal(Color color, Real roughness) {
    RoughMetal metal{color, roughness * roughness, {}};
    constexpr int side = 64;  // of the grid of sample points for each cosine
    for (std::size_t i = 0; i < metal.kept.size(); ++i) {
        const Real cosine = static_cast<Real>(i) / static_cast<Real>(metal.kept.size() - 1);
        const Vec3 out{std::sqrt((1 - cosine) * (1 + cosine)), 0, cosine};
        Real sum = 0;
        for (int x = 0; x < side; ++x)
            for (int y = 0; y < side; ++y) {
                const Vec2 place{(static_cast<Real>(x) + Real(0.5)) / side,
                                 (static_cast<Real>(y) + Real(0.5)) / side};
                const Vec3 facet = visible_facet(out, metal.alpha, place);
                sum += kept_from(out, mirrored_at(out, facet), metal.alpha);
            }
        metal.kept[i] = sum / (side * side);
    }
    return metal;
}

// The share that is kept at this cosine, between two entries of the table.
inline Real kept_at(const RoughMetal& metal, Real cosine) {
    const Real place =
        std::clamp(cosine, Real(0), Real(1)) * static_cast<Real>(metal.kept.size() - 1);
    const auto before = std::min(static_cast<std::size_t>(place), metal.kept.size() - 2);
    const Real share = place - static_cast<Real>(before);
    return (1 - share) * metal.kept[before] + share * metal.kept[before + 1];
}

// The metal at a hit, as the functions of microfacets.hpp see it.
class RoughPoint {
  public:
    // `incoming` is the direction of the ray that made the hit.
    RoughPoint(const RoughMetal& metal, Vec3 incoming, const Hit& hit)
        : metal_{metal}, basis_{orthonormal_basis(facing_normal(hit))}, out_{local(-incoming)} {
        out_.z = std::max(out_.z, Real(0));  // rounded, or bent by a mesh's normal
    }

    Vec3 sample(Vec2 place) const {
        return basis_.to_world(mirrored_at(out_, visible_facet(out_, metal_.alpha, place)));
    }
    Real density(Vec3 direction) const {
        return reflection_density(out_, local(direction), metal_.alpha);
    }
    // The light that goes on from this direction, divided by its density.
    Color color(Vec3 direction) const {
        const Vec3 in = local(direction);
        const Real kept = kept_from(out_, in, metal_.alpha);
        if (!(kept > 0)) return {};
        const Color reflected = metal_reflectance(metal_.color, dot(normalize(out_ + in), out_));
        return kept * reflected * compensation(metal_.color, kept_at(metal_, out_.z));
    }

  private:
    Vec3 local(Vec3 v) const { return {dot(v, basis_.u), dot(v, basis_.v), dot(v, basis_.w)}; }

    const RoughMetal& metal_;
    Basis basis_;
    Vec3 out_;
};

// A direction below the surface has the attenuation 0; the path loop ends there, but only after it
// has sampled a lamp.
template <class Random>
std::optional<Scatter> scatter(const RoughMetal& metal, Vec3 incoming, const Hit& hit,
                               Random& random) {
    const RoughPoint point{metal, incoming, hit};
    const Vec3 direction = point.sample(random_place(random));
    if (!(dot(direction, facing_normal(hit)) > 0)) return Scatter{{}, facing_normal(hit)};
    return Scatter{point.color(direction), direction};
}
inline Real scatter_density(const RoughMetal& metal, Vec3 incoming, const Hit& hit,
                            Vec3 direction) {
    if (!(dot(direction, facing_normal(hit)) > 0)) return 0;
    return RoughPoint{metal, incoming, hit}.density(direction);
}
inline Real scatter_density(const RoughMetal&, const Hit&, Vec3) {
    return 0;  // without `incoming`, it is unknown
}

}  // namespace rt
