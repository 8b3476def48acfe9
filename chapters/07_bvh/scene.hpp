#pragma once
// The scene of chapter 07: 10,000 spheres, most of them small, wound into a ring of two arms.

#include <cmath>
#include <rt/lambertian.hpp>
#include <rt/length.hpp>
#include <rt/make_camera.hpp>
#include <rt/portable.hpp>
#include <rt/rng.hpp>
#include <rt/sphere_list.hpp>

namespace bvh {

using namespace rt;

struct Scene {
    std::vector<SceneSphere> spheres;
    MaterialList<Lambertian> materials;
};

// A sky that is nearly black below, where the camera looks, blue above, and warm on one side, so
// that the shading of each sphere shows its shape.
struct StudioSky {
    Color below = from_hex(0x0c0d16), above = from_hex(0xbcd3f2), lamp{4, Real(3.2), Real(2.3)};
    Vec3 to_lamp = normalize({Real(-0.6), Real(0.75), Real(0.35)});

    Color operator()(Vec3 direction) const {
        const Real cosine = std::max(Real(0), dot(direction, to_lamp));
        const Real squared = cosine * cosine, fourth = squared * squared;
        return mix(below, above, std::max(Real(0), direction.y)) + fourth * fourth * lamp;
    }
};

inline Scene make_scene(int count, std::uint64_t seed) {
    constexpr std::uint32_t palette[] = {0xf94144, 0xf3722c, 0xf9c74f, 0x90be6d,
                                         0x43aa8b, 0x577590, 0xf4efe6};
    Scene scene;
    for (const std::uint32_t color : palette)
        scene.materials.materials.push_back({from_hex(color)});
    Rng rng{seed, 7};
    // A random number from -width to width, most often near 0.
    const auto scatter = [&](Real width) {
        Real sum = 0;
        for (int i = 0; i < 3; ++i) sum += rng.uniform(-1, 1);
        return width * sum / 3;
    };
    for (int i = 0; i < count; ++i) {
        const Real way = std::sqrt(rng.uniform());  // along the arm, from the middle to its end
        const int arm = static_cast<int>(rng() % 2);
        const Real turn = Real(1.5) * 2 * pi * way * Real(0.62) + static_cast<Real>(arm) * pi;
        const Real distance = Real(0.35) + 3 * way;
        const Real wide = Real(0.55) + Real(0.45) * way;
        const Vec3 center{distance * rt::portable::cos(turn) + scatter(wide),
                          scatter(Real(1.1) - Real(0.7) * way),
                          distance * rt::portable::sin(turn) + scatter(wide)};
        // Only a few spheres are large.
        const Real size = rng.uniform();
        const Real radius =
            Real(0.014) + Real(0.035) * size * size + (i % 100 == 0 ? Real(0.16) * size : Real(0));
        const auto colors = static_cast<Real>(std::size(palette) - 1);
        int color = static_cast<int>(colors *
                                     std::min(Real(0.999), way + scatter(Real(0.25)) + Real(0.02)));
        color = std::clamp(color, 0, 5);
        if (rng() % 9 == 0) color = 6;
        scene.spheres.push_back({{center, radius}, color});
    }
    return scene;
}

inline View scene_view() {
    View view;
    view.from = {Real(0.9), Real(5.3), Real(7.2)};
    view.at = {Real(-0.25), Real(-0.2), Real(0.3)};
    view.vertical_fov = radians(38);
    return view;
}

}  // namespace bvh
