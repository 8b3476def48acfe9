#pragma once
// A planet with rings of small moons, under a sky that is itself a sphere seen from inside.

#include <cstddef>
#include <rt/camera.hpp>
#include <rt/color.hpp>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/portable.hpp>
#include <rt/ray.hpp>
#include <rt/rng.hpp>
#include <rt/scene_sphere.hpp>
#include <vector>

namespace scene {

using rt::Color, rt::Real, rt::SceneSphere, rt::Sphere, rt::Vec3;

// The spheres in their order: the sky, seen from inside, then the planet, then its moons.
inline constexpr std::size_t sky_number = 0, planet_number = 1;

// The materials are the colors of the moons.
inline Color moon_color(int material) {
    static const Color colors[] = {rt::from_hex(0xffd9a0), rt::from_hex(0x7fd4e6),
                                   rt::from_hex(0xb9a2f2), rt::from_hex(0x9be7a0)};
    return colors[material];
}

// The color of a point at this distance from the lamp, from 0 to 1, as lamp_distance returns it.
// Shading uses no angles and no normals yet: this distance is all that it needs.
inline Color ramp(Real distance) {
    static const Color stops[] = {rt::from_hex(0xfff3d6), rt::from_hex(0xffc27a),
                                  rt::from_hex(0xe8735a), rt::from_hex(0x8f3b76),
                                  rt::from_hex(0x3a2468), rt::from_hex(0x150f38),
                                  rt::from_hex(0x0b0924)};
    constexpr int last = 6;
    const Real x = std::clamp(distance, Real(0), Real(1)) * last;
    const int i = std::min(static_cast<int>(x), last - 1);
    return rt::mix(stops[i], stops[i + 1], x - static_cast<Real>(i));
}

// How far a point of a sphere is from the lamp: 0 at the nearest point of the sphere, 1 at the
// farthest. The lamp is 4 radii away from the center, in the direction `to_lamp`.
inline Real lamp_distance(const Sphere& sphere, Vec3 point, Vec3 to_lamp) {
    const Vec3 from_center = (point - sphere.center) / sphere.radius;
    return (rt::length(Real(4) * to_lamp - from_center) - 3) / 2;
}

// Bands of equal distance, like the contour lines of a map.
inline Real bands(Real distance, int count) {
    const Real n = static_cast<Real>(count);
    return (std::floor(distance * n) + Real(0.5)) / n;
}

// The sky in a direction: a soft glow, and stars. Each cell of a grid of
// directions has one star or none.
inline Color sky(Vec3 direction) {
    const Vec3 unit = rt::normalize(direction);
    const Real glow = rt::portable::exp(-6 * (unit.y + Real(0.25)) * (unit.y + Real(0.25)));
    Color color = rt::mix(rt::from_hex(0x05060f), rt::from_hex(0x141a38), glow);
    constexpr Real cells = 48;
    const auto cell = [](Real x) { return std::floor(x * cells); };
    const Vec3 corner{cell(unit.x), cell(unit.y), cell(unit.z)};
    const auto index = [](Real x) { return static_cast<std::uint64_t>(x + 128); };
    rt::Rng rng{rt::mix_bits(index(corner.x) << 32 | index(corner.y) << 16 | index(corner.z)), 3};
    const Vec3 star =
        rt::normalize(corner / cells + Vec3{rng.uniform(), rng.uniform(), rng.uniform()} / cells);
    const Real margin = Real(0.006);  // a star that a cell's wall would cut is left out
    for (const Vec3 edge : {Vec3{margin, 0, 0}, Vec3{0, margin, 0}, Vec3{0, 0, margin}})
        for (const Vec3 near : {star + edge, star - edge})
            if (Vec3{cell(near.x), cell(near.y), cell(near.z)} != corner) return color;
    const Real brightness = rt::portable::pow(rng.uniform(), Real(6));
    const Real away = rt::length(unit - star) / Real(0.0016);
    return color + brightness * rt::portable::exp(-away * away) * rt::from_hex(0xdfe8ff);
}

// Light on a moon of this color: full at the point nearest to the lamp,
// almost none on the far side.
inline Color lit(Color color, Real distance) {
    const Real near = 1 - std::clamp(distance, Real(0), Real(1));
    return (Real(0.02) + near * near) * color;
}

inline std::vector<SceneSphere> spheres() {
    std::vector<SceneSphere> all{{{{0, 0, 0}, 1000}}, {{{0, 0, 0}, 1}}};
    const rt::Basis plane = rt::orthonormal_basis(rt::normalize({Real(-0.34), 1, Real(0.24)}));
    rt::Rng rng{3, 1};
    struct Ring {
        int count;
        Real distance, radius;
        int material;
    };
    for (const Ring& ring :
         {Ring{52, Real(1.42), Real(0.035), 0}, Ring{64, Real(1.66), Real(0.062), 1},
          Ring{48, Real(1.98), Real(0.045), 2}})
        for (int i = 0; i < ring.count; ++i) {
            const Real turn = 2 * rt::pi *
                              (static_cast<Real>(i) + rng.uniform(Real(-0.15), Real(0.15))) /
                              static_cast<Real>(ring.count);
            const Real away = ring.distance + rng.uniform(Real(-0.03), Real(0.03));
            const Vec3 center =
                plane.to_world({away * rt::portable::cos(turn), away * rt::portable::sin(turn), 0});
            all.push_back({{center, ring.radius * rng.uniform(Real(0.6), 1)}, ring.material});
        }
    // A moon behind the camera, out of sight.
    all.push_back({{{Real(-1.3), Real(2.2), Real(9.5)}, Real(0.7)}, 3});
    return all;
}

}  // namespace scene
