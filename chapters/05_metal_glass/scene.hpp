#pragma once
// What the picture shows: five metal balls, a glass ball, a hollow one, and the evening around
// them.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <rt/dielectric.hpp>
#include <rt/lambertian.hpp>
#include <rt/material_set.hpp>
#include <rt/metal.hpp>
#include <rt/sphere_list.hpp>

namespace scene {

using namespace rt;

// x^8, by squaring three times.
inline Real to_the_8th(Real x) {
    for (int i = 0; i < 3; ++i) x *= x;
    return x;
}

// An evening sky: deep blue above, a warm band along the horizon, and a low sun with a wide glow.
struct EveningSky {
    Color zenith = from_hex(0x2f5fa8), dusk = from_hex(0xd9a7a0), horizon = from_hex(0xfbd9a5),
          ground = from_hex(0x6b5a52);
    Vec3 sun = normalize({Real(-0.75), Real(0.42), Real(0.5)});
    Color glow{Real(1.5), Real(1.05), Real(0.6)};

    Color operator()(Vec3 d) const {
        const Real up = std::clamp(d.y, Real(-1), Real(1));
        const Color low = mix(horizon, dusk, std::min(Real(1), 9 * std::max(Real(0), up)));
        const Color sky = up > 0 ? mix(low, zenith, std::sqrt(up)) : mix(horizon, ground, -up);
        return sky + to_the_8th(std::max(Real(0), dot(d, sun))) * glow;
    }
};

// Whether a point of the floor lies on an even tile. Tiles are squares with sides of length 1.
inline bool even_tile(Real x, Real z) {
    const auto tile = [](Real p) { return static_cast<long>(std::floor(p)); };
    return ((tile(x) + tile(z)) & 1) == 0;
}

// A matte floor of two colors. The path loop knows nothing about it: any type that has a scatter()
// of its own can be a material.
struct Tiles {
    Color even, odd;
};

template <class Random>
std::optional<Scatter> scatter(const Tiles& tiles, Vec3 incoming, const Hit& hit, Random& random) {
    const Color color = even_tile(hit.point.x, hit.point.z) ? tiles.even : tiles.odd;
    return scatter(Lambertian{color}, incoming, hit, random);
}

using Materials = MaterialSet<Lambertian, Tiles, Metal, Dielectric>;

constexpr std::array<Real, 5> fuzz_values{0, Real(0.1), Real(0.3), Real(0.5), 1};

struct Scene {
    SphereList world;
    Materials set;

    template <class Material>
    void add(Vec3 center, Real radius, Material material) {
        world.spheres.push_back({{center, radius}, static_cast<int>(set.materials.size())});
        set.materials.emplace_back(material);
    }
};

inline Scene evening() {
    Scene scene;
    scene.add({0, -1000, 0}, 1000, Tiles{from_hex(0xcfc4b8), from_hex(0x938d94)});
    for (std::size_t i = 0; i < fuzz_values.size(); ++i)
        scene.add({Real(2.15) * (static_cast<Real>(i) - 2), 1, Real(-1.2)}, 1,
                  Metal{from_hex(0xf6d58e), fuzz_values[i]});
    scene.add({Real(-1.15), Real(0.72), Real(3.4)}, Real(0.72), Dielectric{Real(1.5)});
    // A hollow ball: on the inner surface, glass is outside and air is inside.
    const Vec3 hollow{Real(1.15), Real(0.72), Real(3.4)};
    scene.add(hollow, Real(0.72), Dielectric{Real(1.5)});
    scene.add(hollow, Real(0.62), Dielectric{1 / Real(1.5)});
    const auto matte = [&](Real x, Real z, Real radius, std::uint32_t color) {
        scene.add({x, radius, z}, radius, Lambertian{from_hex(color)});
    };
    matte(0, Real(2.4), Real(0.36), 0xd8432f);
    matte(Real(-2.9), Real(2.4), Real(0.36), 0x2f9fb0);
    matte(Real(2.9), Real(2.4), Real(0.36), 0x7a4fa3);
    matte(Real(-0.28), Real(3.6), Real(0.18), 0xf0b429);
    matte(Real(0.3), Real(3.5), Real(0.22), 0x4a9d5b);
    return scene;
}

}  // namespace scene
