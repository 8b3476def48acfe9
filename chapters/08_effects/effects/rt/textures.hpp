#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <rt/directions.hpp>
#include <rt/hit.hpp>
#include <rt/image.hpp>
#include <rt/length.hpp>
#include <rt/portable.hpp>
#include <rt/scatter.hpp>
#include <rt/transform.hpp>

namespace rt {

// A matte material with two colors that alternate in cubes that fill space (given). The origin is
// the middle of an even cube.
struct CheckeredMatte {
    Color even, odd;  // albedos, each channel in [0, 1]
    Real size = 1;    // the side of a cube, greater than 0
};

// A matte material with an image around the sphere, like a map of the world around a globe: its
// upper edge is at the north pole (y up), its middle is at +z, and its left and right edges
// meet at -z. On an instance, which a map takes from the unit sphere to the world, the image moves
// with the sphere.
struct PictureMatte {
    int image = 0;  // an index into the scene's images, whose colors are albedos, in [0, 1]
    int map = -1;   // the instance's, an index into the scene's maps; -1 for a plain sphere
};

// The same, as renderers keep it: with the image and the map themselves instead of their indices.
struct ImageMatte {
    const Image* image = nullptr;
    const Mat4* map = nullptr;
};

// The color of the cube that a point lies in.
inline Color checker_color(const CheckeredMatte& checker, Vec3 point) {
    // 0 or 1. Beyond 2^53 cubes (2^24 in float) every number is even.
    const auto parity = [&](Real x) {
        const Real n = std::floor(x / checker.size + Real(0.5));
        return n - 2 * std::floor(n / 2);
    };
    const Real sum = parity(point.x) + parity(point.y) + parity(point.z);
    return sum == 1 || sum == 3 ? checker.odd : checker.even;
}

// The color of a latitude-longitude image in a direction, of length 1, from the sphere's center.
// Source: the equirectangular projection, about 100 AD, by Marinus of Tyre.
inline Color image_color(const Image& image, Vec3 direction) {
    const Real around = portable::atan2(direction.x, direction.z) / (2 * pi) + Real(0.5);
    const Real down = portable::acos(std::clamp(direction.y, Real(-1), Real(1))) / pi;
    const auto pixel = [](Real share, int pixels) {
        return std::min(static_cast<int>(share * static_cast<Real>(pixels)), pixels - 1);
    };
    return image.at(pixel(around, image.width()), pixel(down, image.height()));
}

inline Color albedo_at(const CheckeredMatte& material, const Hit& hit) {
    return checker_color(material, hit.point);
}
inline Color albedo_at(const ImageMatte& material, const Hit& hit) {
    // A normal goes back to the unit sphere by the inverse of the inverse: the map itself.
    const Vec3 direction =
        material.map ? normalize(transform_normal(*material.map, hit.normal)) : hit.normal;
    return image_color(*material.image, direction);
}

template <class Random>
std::optional<Scatter> scatter(const CheckeredMatte& material, Vec3 /*incoming*/, const Hit& hit,
                               Random& random) {
    return Scatter{albedo_at(material, hit),
                   cosine_direction(facing_normal(hit), random_place(random))};
}
template <class Random>
std::optional<Scatter> scatter(const ImageMatte& material, Vec3 /*incoming*/, const Hit& hit,
                               Random& random) {
    return Scatter{albedo_at(material, hit),
                   cosine_direction(facing_normal(hit), random_place(random))};
}

}  // namespace rt
