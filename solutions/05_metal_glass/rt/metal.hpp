#pragma once
#include <optional>
#include <rt/above_horizon.hpp>
#include <rt/directions.hpp>
#include <rt/hit.hpp>
#include <rt/reflect.hpp>
#include <rt/scatter.hpp>
#include <rt/uniform_direction.hpp>

namespace rt {

// A metal: from a mirror (fuzz 0) to a rough, dull shine (fuzz 1).
struct Metal {
    Color albedo;   // the fraction of light that comes back, each channel in [0, 1]
    Real fuzz = 0;  // how far reflected light strays, in [0, 1]
};

// Where metal sends light that arrives along `incoming`, of length 1, on the side of `normal`: the
// mirror direction plus `fuzz` times the uniform direction for `place`, a sample point of the unit
// square. If this sum points below the surface, it is folded to the upper side. The result has
// length 1.
inline Vec3 metal_direction(Vec3 incoming, Vec3 normal, Real fuzz, Vec2 place) {
    const Vec3 mirrored = reflect(incoming, normal);
    return above_horizon(mirrored + fuzz * uniform_direction(place), normal);
}

// No path ends at metal, and all paths are dimmed alike: the light of each is multiplied by the
// albedo.
template <class Random>
std::optional<Scatter> scatter(const Metal& material, Vec3 incoming, const Hit& hit,
                               Random& random) {
    return Scatter{material.albedo, metal_direction(incoming, facing_normal(hit), material.fuzz,
                                                    random_place(random))};
}

}  // namespace rt
