#pragma once
#include <optional>
#include <rt/hit_box.hpp>
#include <rt/sphere_shape.hpp>
#include <span>

namespace rt {

// One ray on its way through a tree of shapes, and the nearest hit so far (given). Here the shapes
// are spheres. Chapter 08 searches for other shapes, with rays of other types.
template <class Shape, class AnyRay = Ray>
struct SearchOf {
    std::span<const Shape> shapes;  // of the scene
    std::span<const int> order;     // of the tree: its leaves hold indices into it
    AnyRay ray;
    Interval within;    // its upper end moves down to the nearest hit
    int nearest = -1;   // the number of the shape that was hit there; -1 before any hit
    int box_tests = 0;  // the tests made so far
    int shape_tests = 0;
    SlabRay slabs = slab_ray(ray);

    // True if the ray meets a box where a hit would still count.
    bool meets(const Box& box) {
        ++box_tests;
        return hit_box(box, slabs, with_origin(within));
    }

    // The shape with this number.
    const Shape& shape(int number) const { return shapes[static_cast<std::size_t>(number)]; }

    // Where the ray meets the shape with this number within the interval.
    std::optional<Real> meets_shape(int number) {
        ++shape_tests;
        return hit_shape(shape(number), ray, within);
    }
};
using Search = SearchOf<SceneSphere>;

}  // namespace rt
