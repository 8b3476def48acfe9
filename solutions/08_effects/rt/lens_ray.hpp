#pragma once
#include <cmath>
#include <rt/length.hpp>
#include <rt/lens_and_haze.hpp>
#include <rt/pixel.hpp>
#include <rt/ray.hpp>
#include <rt/sine_cosine.hpp>

namespace rt {

// The ray through a point of a pixel (see primary_ray) from a point of the lens. `place`, a sample
// point of the unit square, 0 <= x, y < 1, chooses the point of the lens: sample points spread
// evenly over the square give points spread evenly over the lens. All rays through one point of the
// picture meet in the plane of focus, at focus_distance in front of the eye. The direction has
// length 1. The ray from the lens's middle, place.x = 0, is the pinhole's, bit for bit.
// Source: the thin lens; Cook, Porter and Carpenter, "Distributed ray tracing", SIGGRAPH 1984.
inline Ray lens_ray(const Camera& camera, const Lens& lens, int column, int row, Vec2 offset,
                    Vec2 place) {
    const Vec2 p = pixel_to_viewport(camera, column, row, offset);
    // The square root spreads the points evenly over the disk.
    const Real radius = lens.aperture / 2 * std::sqrt(place.x);
    const auto [sine, cosine] = sine_cosine_of_turn(place.y);
    const Real right = radius * cosine, up = radius * sine;
    // From the point on the lens to the point in the plane of focus, divided by focus_distance.
    const Vec3 direction = camera.basis.to_world(
        {p.x - right / lens.focus_distance, p.y - up / lens.focus_distance, -1});
    return {camera.eye + right * camera.basis.u + up * camera.basis.v, normalize(direction)};
}

}  // namespace rt
