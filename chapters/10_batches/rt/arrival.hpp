#pragma once
#include <rt/leave_surface.hpp>
#include <rt/path_record.hpp>
#include <rt/vector_registers.hpp>

namespace rt {

// A sphere of the scene, with the data that its material's kernel needs (given).
struct alignas(std::max(32, RT_REGISTER_BYTES)) Surface {
    Vec3 center;
    Real radius = 0;
    Real parameter = 0;  // of its material: fuzz, or the index of refraction
    Color color;         // its albedo
};

// What is known of a pack of paths that have arrived at spheres (given): for each path, the results
// of surface_hit (04.1), its direction and the parameter of the material.
struct Arrivals {
    Vec3Pack direction, normal, facing_normal, point;
    Pack point_error, parameter;
    PackMask front;
};

inline Arrivals arrive(const PathRecord* paths, const Surface* surfaces, const PathPack& pack) {
    const RayPack rays = load_rays(paths, pack);
    const auto [cx, cy, cz, radius, parameter, r, g, b] = load_eight(
        [&](std::size_t i) { return &surfaces[static_cast<std::size_t>(rays.sphere[i])]; });
    const Vec3Pack center{cx, cy, cz};
    Arrivals all;
    all.direction = rays.direction;
    all.parameter = parameter;
    const Vec3Pack outward = (rays.origin - center) + rays.t * rays.direction;
    const PackMask nowhere = is_zero(outward);
    all.normal = normalize(pick(nowhere, -rays.direction, outward), pack.active);
    all.front = dot(rays.direction, all.normal) <= 0;
    all.facing_normal = pick(all.front, all.normal, -all.normal);
    all.point = center + radius * all.normal;
    all.point_error =
        rounding_bound(1) * dot(abs(all.point), abs(all.normal)) + rounding_bound(16) * radius;
    return all;
}

// random_place of 04.3, for a pack: two random numbers for each of its first `size` paths.
// random(i) is the generator of path i.
struct PlacePack {
    Pack x{}, y{};
};
template <class RandomOf>
PlacePack random_places(std::size_t size, const RandomOf& random) {
    PlacePack places;
    for (std::size_t i = 0; i < size; ++i) {
        auto& own = random(i);
        places.x[i] = own.uniform();
        places.y[i] = own.uniform();
    }
    return places;
}

// leave_surface of 04.6, for a pack.
inline Vec3Pack leave_surface(const Arrivals& from, Vec3Pack direction) {
    const PackMask goes_in = dot(direction, from.normal) < 0;
    const Vec3Pack side = pick(goes_in, -from.normal, from.normal);
    const Pack distance = from.point_error + rounding_bound(1) * dot(abs(from.point), abs(side));
    return from.point + distance * side;
}

}  // namespace rt
