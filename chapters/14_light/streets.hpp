#pragma once
// A town at night, with 10,000 lamps along its streets.

#include <rt/tree_lights.hpp>

#include "scene.hpp"

namespace light {

using namespace rt;

inline View streets_view() {
    View view;
    view.from = {Real(-3.5), 7, 58};
    view.at = {Real(-3.5), 0, 44};
    view.vertical_fov = radians(32);
    return view;
}

// A hundred streets with a hundred lamps each, at distance 1. Each second street leads between two
// rows of houses.
inline Scene make_streets(const View& view) {
    Scene scene;
    SceneDescription& description = scene.description;
    description.camera = {view, {}, 0};
    description.sky = {};
    enum { ground, stone, brick, first_lamp };
    description.materials = {Lambertian{from_hex(0x8a8378)}, Lambertian{from_hex(0xc8bda8)},
                             Lambertian{from_hex(0xa8644a)}};
    const unsigned colors[]{0xffb45cu, 0xffd9a0u, 0xff8f4au, 0x9fd0ffu};
    for (const unsigned color : colors)
        description.materials.push_back(Emitter{Real(150) * from_hex(color)});

    Mesh square;
    add_four(square, {{{-100, 0, -100}, {-100, 0, 100}, {100, 0, 100}, {100, 0, -100}}});
    scene.meshes.add(square, Mat4{}, ground);

    Rng random{14, 5};
    const auto add_house = [&](Vec3 at, Vec3 half, int material) {
        Mesh house;
        Four foot;
        for (std::size_t i = 0; i < 4; ++i)
            foot[i] = at + Vec3{i < 2 ? -half.x : half.x, 0, i % 3 == 0 ? -half.z : half.z};
        Four roof = foot;
        for (Vec3& corner : roof) corner.y += half.y;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t next = (i + 1) % 4;
            add_four(house, {foot[i], foot[next], roof[next], roof[i]});
        }
        add_four(house, roof);
        scene.meshes.add(house, Mat4{}, material);
    };
    for (int row = 0; row < 100; ++row)
        for (int column = 0; column < 100; ++column) {
            const Real x = static_cast<Real>(column) - Real(49.5),
                       z = static_cast<Real>(row) - Real(49.5);
            const Vec3 lamp{x + random.uniform(Real(-0.1), Real(0.1)),
                            random.uniform(Real(0.25), Real(0.4)), z};
            const auto color = static_cast<int>(random.uniform() * random.uniform() * 4);
            description.spheres.push_back(
                {{lamp, random.uniform(Real(0.015), Real(0.04))}, first_lamp + color});
            if (row % 2 == 0 && column % 3 != 2)
                add_house({x, 0, z + Real(0.5)},
                          {Real(0.3), random.uniform(Real(0.3), Real(1.1)), Real(0.28)},
                          random.uniform() < Real(0.4) ? brick : stone);
        }
    return scene;
}

}  // namespace light
