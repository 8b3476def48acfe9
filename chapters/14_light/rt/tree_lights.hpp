#pragma once
#include <rt/choose_lamp.hpp>
#include <rt/mesh_lights.hpp>

namespace rt {

// Chooses among lamps by a tree (given): near ones more often, with the star of 14.5.
class ByTree {
  public:
    ByTree() = default;
    ByTree(const std::vector<Light>& spheres, const std::vector<LampTriangle>& triangles)
        : tree_{make_lamp_tree(boxes_of(spheres, triangles), powers_of(spheres, triangles))} {}

    Pick choose(Vec3 from, Real number) const { return choose_lamp(tree_, from, number); }
    Real probability(Vec3 from, std::size_t lamp) const {
        return lamp_probability(tree_, from, lamp);
    }

  private:
    static std::vector<Box> boxes_of(const std::vector<Light>& spheres,
                                     const std::vector<LampTriangle>& triangles) {
        std::vector<Box> boxes;
        for (const Light& sphere : spheres)
            boxes.push_back(bounds_of(std::get<Sphere>(sphere.shape)));
        for (const LampTriangle& triangle : triangles) {
            const auto& [a, b, c] = triangle.shape;
            boxes.push_back(join(join({a, a}, {b, b}), {c, c}));
        }
        return boxes;
    }

    LampTree tree_;
};

// Lamps of a scene that has very many of them (given).
using TreeLights = LampsBy<ByTree>;

}  // namespace rt
