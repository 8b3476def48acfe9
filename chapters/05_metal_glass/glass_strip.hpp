#pragma once
// The strip below the picture: three balls of glass, drawn with two formulas for how much glass
// reflects.

#include <array>
#include <rt/camera.hpp>
#include <rt/counting_world.hpp>
#include <rt/fresnel.hpp>
#include <rt/leave_surface.hpp>
#include <rt/refract.hpp>

#include "scene.hpp"

namespace scene {

// The evening sky and the tiled floor around the strip's glass balls. Both count as infinitely far
// away: what a ray shows depends on its direction alone.
struct TiledEvening {
    EveningSky sky;

    Color operator()(Vec3 d) const {
        if (d.y >= Real(-0.06)) return sky(d);
        const Real x = d.x / -d.y, z = d.z / -d.y;  // where d meets a floor at y = -1
        return even_tile(x, z) ? from_hex(0xe9dfd2) : from_hex(0x4b5568);
    }
};

// The light along a ray among glass balls, without randomness: at each surface, both the reflected
// and the refracted ray are followed, each weighted by its share of the light.
template <class Reflectance>
Color light_through_glass(const Ray& ray, const SphereList& balls,
                          const std::array<Real, 3>& indices, Reflectance reflectance, int depth,
                          std::uint64_t& rays) {
    const TiledEvening surroundings;
    const auto hit = CountingWorld<SphereList>{balls, rays}.hit(ray, Interval{0, infinity});
    if (!hit || depth == 0) return surroundings(ray.direction);
    const Real index = indices[static_cast<std::size_t>(hit->material)];
    const Real eta = hit->front ? 1 / index : index;
    const Vec3 normal = facing_normal(*hit);
    const auto along = [&](Vec3 direction) {
        return light_through_glass({leave_surface(*hit, direction), direction}, balls, indices,
                                   reflectance, depth - 1, rays);
    };
    const Real reflected = reflectance(-dot(ray.direction, normal), eta);
    const Color mirror = reflected * along(reflect(ray.direction, normal));
    const auto refracted = refract(ray.direction, normal, eta);
    return refracted ? mirror + (1 - reflected) * along(*refracted) : mirror;
}

// A panel of the strip: 0 shows Schlick's formula, 1 the exact one, and 2 the difference times 20.
// The difference is gold where Schlick's formula gives too much light, and blue where it gives too
// little.
inline Color panel_color(int panel, const Ray& ray, std::uint64_t& rays) {
    const std::array<Real, 3> indices{Real(1.1), Real(1.5), Real(2.4)};
    SphereList balls;
    for (int i = 0; i < 3; ++i)
        balls.spheres.push_back({{{Real(2.3) * static_cast<Real>(i - 1), 0, 0}, 1}, i});
    const auto with = [&](auto reflectance) {
        return light_through_glass(ray, balls, indices, reflectance, 6, rays);
    };
    if (panel == 0) return with(schlick_reflectance);
    if (panel == 1) return with(fresnel_reflectance);
    const Color difference = with(schlick_reflectance) - with(fresnel_reflectance);
    const Real amplified = 20 * (difference.r + difference.g + difference.b) / 3;
    return amplified > 0 ? amplified * from_hex(0xf2b84b) : -amplified * from_hex(0x5b8ff0);
}

}  // namespace scene
