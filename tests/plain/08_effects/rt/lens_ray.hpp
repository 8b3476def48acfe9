#pragma once
#include <cmath>
#include <rt/length.hpp>
#include <rt/lens_and_haze.hpp>
#include <rt/pixel.hpp>
#include <rt/ray.hpp>

namespace rt {
inline Ray lens_ray(const Camera& camera, const Lens& lens, int column, int row, Vec2 offset,
                    Vec2 place) {
    const Vec2 p = pixel_to_viewport(camera, column, row, offset);
    const Real radius = lens.aperture / 2 * std::sqrt(place.x), angle = 2 * pi * place.y;
    const Real a = radius * std::cos(angle), b = radius * std::sin(angle);
    const Real f = lens.focus_distance;
    const Vec3 direction = normalize(camera.basis.to_world({f * p.x - a, f * p.y - b, -f}));
    return {camera.eye + a * camera.basis.u + b * camera.basis.v, direction};
}
}  // namespace rt
