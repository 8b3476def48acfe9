#pragma once
// The scene of chapter 06: matte spheres in the spirals of a sunflower, below an evening sky.

#include <cmath>
#include <rt/counting_world.hpp>
#include <rt/directions.hpp>
#include <rt/dot.hpp>
#include <rt/jitter.hpp>
#include <rt/lambertian.hpp>
#include <rt/length.hpp>
#include <rt/make_camera.hpp>
#include <rt/path.hpp>
#include <rt/portable.hpp>
#include <rt/primary_ray.hpp>
#include <rt/sample_rng.hpp>
#include <rt/sphere_list.hpp>

namespace threads {

using namespace rt;

// A sky that is warm and bright around a low sun, and violet above.
struct DuskSky {
    Color horizon = from_hex(0xf7b58f), above = from_hex(0x4a5aa6),
          glow{Real(1.9), Real(1.2), Real(0.5)};
    Vec3 to_sun = normalize({Real(-0.8), Real(0.42), Real(-0.28)});

    Color operator()(Vec3 direction) const {
        const Real height = std::max(Real(0), direction.y);
        const Real cosine = std::max(Real(0), dot(direction, to_sun));
        const Real cubed = cosine * cosine * cosine;
        return mix(horizon, above, height / (height + Real(0.22))) + cubed * glow;
    }
};

struct Scene {
    SphereList world;
    MaterialList<Lambertian> materials;
    DuskSky sky;
};

inline Scene make_scene() {
    Scene scene;
    const auto add = [&](Vec3 center, Real radius, Color albedo) {
        scene.world.spheres.push_back(
            {{center, radius}, static_cast<int>(scene.materials.materials.size())});
        scene.materials.materials.push_back({albedo});
    };
    const Real earth = 400;
    add({0, -earth, 0}, earth, from_hex(0xe9dccb));
    // The center of a sphere that stands on the ground.
    const auto stand = [&](Real x, Real z, Real radius) {
        return Vec3{x, std::sqrt((earth + radius) * (earth + radius) - x * x - z * z) - earth, z};
    };
    add(stand(0, 0, Real(0.95)), Real(0.95), from_hex(0xf6efe2));
    const Color colors[] = {from_hex(0xe4572e), from_hex(0xf2a541), from_hex(0x2e86ab),
                            from_hex(0x4b3f72), from_hex(0xf0c8a0), from_hex(0x3f8f7a)};
    const Real golden_angle = pi * (3 - std::sqrt(Real(5)));
    for (int i = 0; i < 66; ++i) {
        const auto n = static_cast<Real>(i);
        const Real distance = Real(0.5) * std::sqrt(n + Real(7.5)), angle = golden_angle * n;
        const Real radius = Real(0.18) + Real(0.0026) * n;
        add(stand(distance * rt::portable::cos(angle), distance * rt::portable::sin(angle), radius),
            radius, colors[i % 8 % 6]);
    }
    return scene;
}

inline View scene_view() {
    return {{Real(0.7), Real(1.75), Real(8.4)}, {0, Real(0.95), 0}, {0, 1, 0}, radians(31)};
}

// The color of one pixel, computed with the random streams of exercise 06.4, and the number of rays
// that it took.
struct ScenePixel {
    Color color;
    std::uint64_t rays = 0;
};

struct SceneShader {
    const Scene& scene;
    Camera camera;
    int samples, depth;
    std::uint64_t seed;

    // One sample of a pixel, with random numbers from any generator.
    template <class World, class Random>
    Color sample(const World& world, int x, int y, int number, Random& random) const {
        int n = 1;
        while ((n + 1) * (n + 1) <= samples) ++n;
        const Vec2 place = random_place(random);
        const Vec2 offset = number < n * n ? jittered_offset(number, n, place) : place;
        return path_radiance(primary_ray(camera, x, y, offset), world, scene.materials, scene.sky,
                             SkyEnding{}, depth, random);
    }

    ScenePixel operator()(int x, int y) const {
        ScenePixel pixel;
        const CountingWorld<SphereList> world{scene.world, pixel.rays};
        pixel.color = average_samples(seed, x, y, samples, [&](int number, Rng& random) {
            return sample(world, x, y, number, random);
        });
        return pixel;
    }
};

}  // namespace threads
