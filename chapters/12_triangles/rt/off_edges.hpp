#pragma once
#include <algorithm>
#include <array>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/hit.hpp>
#include <rt/length.hpp>
#include <rt/triangle.hpp>

namespace rt {

// A hit of a triangle, moved away from the triangle's edges (given). Where two walls meet, a hit on
// one wall is near the other, and rounding may put it beyond that wall: a ray that starts there
// would leave the room. The result is at least four error bounds away from each edge, or in the
// middle of a triangle that is too small for that. This is enough if the angle between the walls is
// at least 2 atan(1/4), 28 degrees. A hit that is not near an edge stays as it is.
inline Hit off_edges(const Triangle& triangle, const Hit& hit) {
    const std::array<Vec3, 3> corner{triangle.a, triangle.b, triangle.c};
    const std::array<Vec3, 3> edge{corner[1] - corner[0], corner[2] - corner[1],
                                   corner[0] - corner[2]};
    const std::array<Real, 3> size{max_component(edge[0]), max_component(edge[1]),
                                   max_component(edge[2])};
    // The point is rounded in all directions, not only along the normal, and so is the origin of
    // the next ray; the second term is that of 12.4.
    const Real error = rounding_bound(4) * max_component(hit.point) +
                       rounding_bound(40) * std::max({size[0], size[1], size[2]});
    const Real room = 4 * error;
    // The distances from the edges, multiplied by the lengths of the edges. No edge is longer than
    // sqrt(3) < 2 times its largest coordinate.
    std::array<Real, 3> inside;
    bool is_near = false;
    for (std::size_t k = 0; k < 3; ++k) {
        inside[k] = dot(cross(hit.normal, edge[k]), hit.point - corner[k]);
        is_near = is_near || inside[k] < 2 * room * size[k];
    }
    if (!is_near) return hit;

    // Toward the middle of the circle that touches all three edges, where no edge comes nearer.
    const std::array<Real, 3> lengths{length(edge[0]), length(edge[1]), length(edge[2])};
    const Real around = lengths[0] + lengths[1] + lengths[2];
    const Real radius = length(cross(edge[0], edge[1])) / around;
    Real share = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Real distance = inside[k] / lengths[k];
        if (distance < room)
            share = radius > room ? std::max(share, (room - distance) / (radius - distance)) : 1;
    }
    if (share == 0) return hit;
    const Vec3 from = hit.point - corner[0];
    const Vec3 middle = (lengths[2] * edge[0] - lengths[0] * edge[2]) / around;
    Hit moved = hit;
    moved.point += share * (middle - from);
    moved.point_error = std::max(hit.point_error, error);
    return moved;
}

}  // namespace rt
