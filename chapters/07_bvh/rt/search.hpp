#pragma once
#include <algorithm>
#include <optional>
#include <rt/hit_box.hpp>
#include <rt/nearest_first.hpp>
#include <rt/sphere_shape.hpp>
#include <rt/tree.hpp>
#include <span>

namespace rt {

// A child of a TreeNode whose box a ray meets, and the t at which the ray enters the box.
struct MetChild {
    Real entry;
    const TreeNode* place;
    const TreeNode& node() const { return *place; }
};

// One ray on its way through a tree of shapes, and the nearest hit so far (given). Here the shapes
// are spheres. Chapter 08 searches for other shapes, with rays of other types. WideSearch has the
// same functions for trees with eight children per node.
template <class Shape, class AnyRay = Ray>
struct SearchOf {
    std::span<const Shape> shapes;  // of the scene
    std::span<const int> order;     // of the tree: its leaves hold indices into it
    AnyRay ray;
    Interval within;    // its upper end moves down to the nearest hit
    int nearest = -1;   // the ID of the shape that was hit there; -1 before any hit
    int box_tests = 0;  // the tests made so far
    int shape_tests = 0;
    SlabRay slabs = slab_ray(ray);

    // The part of the ray in a box where a hit would still count; min > max if there is none.
    Interval part_in(const Box& box) {
        ++box_tests;
        return hit_box(box, slabs, with_origin(within));
    }
    bool meets(const Box& box) {
        const Interval part = part_in(box);
        return part.min <= part.max;
    }

    // The children of an inner node whose boxes the ray meets, the nearest first.
    NearestFirst<MetChild, 2> children_of(const TreeNode& node) {
        NearestFirst<MetChild, 2> met;
        for (const TreeNode* const child : {node.left.get(), node.right.get()}) {
            const Interval part = part_in(child->box);
            if (part.min <= part.max) met.add({part.min, child});
        }
        return met;
    }
    // True if a hit in this child would still count: no hit has been found in front of its box.
    bool reaches(const MetChild& child) const { return child.entry <= with_origin(within).max; }

    // The IDs of the shapes in a leaf that the ray may meet: here all of them.
    std::span<const int> shapes_in(const TreeNode& leaf) const {
        return order.subspan(static_cast<std::size_t>(leaf.first),
                             static_cast<std::size_t>(leaf.count));
    }
    // The shape with this ID, its index in the scene.
    const Shape& shape(int id) const { return shapes[static_cast<std::size_t>(id)]; }

    // Where the ray meets the shape with this ID within the interval.
    std::optional<Real> meets_shape(int id) {
        ++shape_tests;
        return hit_shape(shape(id), ray, within);
    }
};
using Search = SearchOf<SceneSphere>;

// Makes the Hit for the shape that a search has found, as SphereList does.
template <class AnySearch>
std::optional<Hit> hit_of(const AnySearch& search) {
    if (search.nearest < 0) return {};
    Hit hit = surface_hit(search.shape(search.nearest), search.ray, search.within.max);
    hit.shape = search.nearest;
    return hit;
}

}  // namespace rt
