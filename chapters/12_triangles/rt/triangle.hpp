#pragma once
#include <cstdint>
#include <rt/ray.hpp>
#include <rt/vec3.hpp>

namespace rt {

// The corners of a triangle (given). Seen from outside, they go around counterclockwise.
struct Triangle {
    Vec3 a, b, c;
};

// Where a ray meets a triangle: at origin + t * direction = (1 - u - v) a + u b + v c.
struct TriangleHit {
    Real t = 0;
    Real u = 0, v = 0;  // the weights of b and c
};

// A triangle of a scene.
struct SceneTriangle {
    Triangle shape;
    std::int32_t material = 0;  // an index into the scene's materials
    std::int32_t number = 0;    // among the scene's triangles
};

}  // namespace rt
