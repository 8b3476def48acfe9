#pragma once
// The scene of chapter 04: matte spheres on a ground, under an evening sky.

#include <cmath>
#include <rt/dot.hpp>
#include <rt/lambertian.hpp>
#include <rt/length.hpp>
#include <rt/portable.hpp>
#include <rt/sphere_list.hpp>
#include <rt/view.hpp>

namespace normals_aa {

using namespace rt;

// A sky that is warm at the horizon and blue above, with a wide, soft glow around the sun. The sky
// is the only light in the scene.
struct EveningSky {
    Color horizon = from_hex(0xffe3cc), above = from_hex(0x5f93d3),
          glow{Real(1.7), Real(1.3), Real(0.8)};
    Vec3 to_sun = normalize({Real(-0.75), Real(0.7), Real(0.45)});

    Color operator()(Vec3 direction) const {
        const Real height = std::max(Real(0), direction.y);
        const Real cosine = std::max(Real(0), dot(direction, to_sun));
        const Real squared = cosine * cosine;
        return mix(horizon, above, height / (height + Real(0.25))) + squared * squared * glow;
    }
};

struct Scene {
    SphereList world;
    MaterialList<Lambertian> materials;
    EveningSky sky;
};

// All lengths are multiplied by `scale`: the picture must stay the same.
inline Scene make_scene(Real scale = 1) {
    Scene scene;
    const auto add = [&](Vec3 center, Real radius, std::uint32_t color) {
        scene.world.spheres.push_back(
            {{scale * center, scale * radius}, static_cast<int>(scene.materials.materials.size())});
        scene.materials.materials.push_back({from_hex(color)});
    };
    const Real earth = 1000;
    // A sphere that stands on the ground, which curves down a little.
    const auto stand = [&](Real x, Real z, Real radius, std::uint32_t color) {
        const Real height = std::sqrt((earth + radius) * (earth + radius) - x * x - z * z);
        add({x, height - earth, z}, radius, color);
    };
    add({0, -earth, 0}, earth, 0xf1e6d6);
    stand(0, 0, 1, 0xf4efe6);
    stand(Real(-1.75), Real(-0.35), Real(0.75), 0xe07a5f);
    stand(Real(1.72), Real(0.1), Real(0.7), 0x3d5a98);
    stand(Real(0.75), Real(1.15), Real(0.38), 0xf2b84b);
    stand(Real(-0.72), Real(1.22), Real(0.42), 0x81b29a);
    stand(Real(2.55), Real(-1.1), Real(0.55), 0x9a6a8c);
    stand(Real(-2.7), Real(-1.5), Real(0.6), 0xf2cc8f);
    // Beads in an arc in front of the group.
    const std::uint32_t beads[] = {0xe4572e, 0xf2b84b, 0x3fa7d6, 0xf4efe6, 0x81b29a, 0x6d597a};
    for (int i = 0; i < 11; ++i) {
        const Real angle = (static_cast<Real>(i) / 10 - Real(0.5)) * Real(2.4);
        stand(Real(2.45) * rt::portable::sin(angle),
              Real(2.2) * rt::portable::cos(angle) + Real(i % 2) / 8,
              Real(0.13) + Real(0.04) * rt::portable::cos(5 * angle), beads[i % 6]);
    }
    return scene;
}

// The camera looks at the group from the front, a little from above.
inline View group_view(Real scale = 1) {
    return {scale * Vec3{0, Real(1.75), Real(7.2)},
            scale * Vec3{0, Real(0.72), 0},
            {0, 1, 0},
            radians(30)};
}

}  // namespace normals_aa
