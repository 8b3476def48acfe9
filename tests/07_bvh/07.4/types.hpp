#pragma once
// Types that both sides know.

#include <algorithm>
#include <rt/any_hit.hpp>
#include <rt/search.hpp>
#include <vector>

namespace answer {

// A search of another type: it meets spheres that have been moved.
struct MovedSearch : rt::Search {
    std::span<const rt::Vec3> motions;

    std::optional<rt::Real> meets_shape(int number) {
        ++shape_tests;
        const auto i = static_cast<std::size_t>(number);
        return rt::hit_sphere(rt::moved(shapes[i].shape, motions[i]), ray, within);
    }
};

using ShadowSearch = rt::AnyHit<rt::Search>;

// A node with any number of children, and where the ray enters its box.
struct ManyNode {
    rt::Real entry = 0;
    std::vector<ManyNode> children = {};
    std::vector<int> shapes = {};  // of a leaf

    bool is_leaf() const { return children.empty(); }
};

// A search among such nodes: it knows where the ray meets each shape.
struct ManySearch {
    struct Child {
        const ManyNode* place;
        const ManyNode& node() const { return *place; }
    };
    std::vector<rt::Real> hits;  // the t of each shape
    rt::Interval within = {};
    int nearest = -1;
    int opened = 0, shape_tests = 0;

    std::vector<Child> children_of(const ManyNode& node) {
        ++opened;
        std::vector<Child> met;
        for (const ManyNode& child : node.children)
            if (child.entry <= within.max) met.push_back({&child});
        std::stable_sort(met.begin(), met.end(), [](const Child& a, const Child& b) {
            return a.node().entry < b.node().entry;
        });
        return met;
    }
    bool reaches(const Child& child) const { return child.node().entry <= within.max; }
    const std::vector<int>& shapes_in(const ManyNode& leaf) const { return leaf.shapes; }
    std::optional<rt::Real> meets_shape(int number) {
        ++shape_tests;
        const rt::Real t = hits[static_cast<std::size_t>(number)];
        if (!within.contains(t)) return {};
        return t;
    }
};

}  // namespace answer
