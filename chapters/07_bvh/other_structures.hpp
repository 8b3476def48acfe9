#pragma once
// What only the study compares: other ways to split, and other ways to search.

#include <rt/binned_split.hpp>
#include <rt/directions.hpp>
#include <rt/flat_tree.hpp>
#include <rt/portable.hpp>
#include <rt/primary_ray.hpp>
#include <rt/uniform_direction.hpp>
#include <rt/wide_leaf.hpp>
#include <study/timing.hpp>

#include "scene.hpp"

namespace bvh {

// The linear list, testing eight spheres at once.
struct PackedList {
    std::vector<SceneSphere> spheres;
    std::vector<SphereLeaf> leaves;

    explicit PackedList(std::vector<SceneSphere> all) : spheres{std::move(all)} {
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            if (i % lanes == 0) leaves.emplace_back();
            leaves.back().set(i % lanes, spheres[i], static_cast<int>(i));
        }
    }
    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& any_ray, Interval within) const {
        const Ray ray{any_ray.origin, any_ray.direction};
        Search search{spheres, {}, ray, within};
        for (const SphereLeaf& leaf : leaves)
            for (const int number : SomeOfLeaf{leaf.number, may_meet(leaf, ray, within)})
                try_shape(number, search);
        return hit_of(search);
    }
};

struct FlatInOrder {
    const FlatTree& tree;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        return hit_of(tree.search_in_order(ray, within));
    }
};

// Sorts the numbers of spheres along an axis, and splits them in half. If there are at most `leaf`,
// they stay together.
inline int halve(std::span<int> order, std::span<const Box> boxes, int axis, int leaf) {
    if (static_cast<int>(order.size()) <= leaf) return 0;
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return along(boxes[static_cast<std::size_t>(a)].center(), axis) <
               along(boxes[static_cast<std::size_t>(b)].center(), axis);
    });
    return static_cast<int>(order.size() / 2);
}

struct SplitRandomAxis {
    int operator()(std::span<int> order, std::span<const Box> boxes) const {
        // As good as random: mixed bits of the first number and the count.
        const std::uint64_t bits = mix_bits(static_cast<std::uint64_t>(order[0]) ^ order.size());
        return halve(order, boxes, static_cast<int>(bits % 3), leaf_size);
    }
};

// split_in_half with leaves of another size.
struct SplitLeaf {
    int leaf;
    int operator()(std::span<int> order, std::span<const Box> boxes) const {
        Box middles;
        for (const int i : order) {
            const Vec3 middle = boxes[static_cast<std::size_t>(i)].center();
            middles = join(middles, {middle, middle});
        }
        return halve(order, boxes, longest_axis(middles), leaf);
    }
};

// binned_split with leaves of up to two spheres.
inline int split_binned(std::span<int> order, std::span<const Box> boxes) {
    return order.size() <= 2 ? 0 : binned_split(order, boxes);
}

// The average number of boxes and of spheres that are tested for a ray of the picture.
struct Tests {
    double boxes = 0, spheres = 0;
};
inline Tests tests_per_ray(const SphereTree& tree) {
    const Camera camera = make_camera(scene_view(), 60, 42);
    Tests sum;
    for (int y = 0; y < 42; ++y)
        for (int x = 0; x < 60; ++x) {
            const Search s = tree.search(primary_ray(camera, x, y, {Real(0.5), Real(0.5)}), {});
            sum.boxes += s.box_tests / (60.0 * 42);
            sum.spheres += s.shape_tests / (60.0 * 42);
        }
    return sum;
}

// Spheres spread evenly over a cube. Whatever their number, they fill the same share of the cube.
// Two lists of rays are for searches: the rays of a picture of the cube, row by row, and random
// rays.
struct Cloud {
    std::vector<SceneSphere> spheres;
    std::vector<Ray> rays, random_rays;

    explicit Cloud(int count) {
        Rng rng{5, 5};
        const auto anywhere = [&] {
            const Real x = rng.uniform(-1, 1), y = rng.uniform(-1, 1), z = rng.uniform(-1, 1);
            return Vec3{x, y, z};
        };
        const Real size = Real(0.5) / rt::portable::cbrt(static_cast<Real>(count));
        for (int i = 0; i < count; ++i)
            spheres.push_back({{anywhere(), size * rng.uniform(Real(0.2), 1)}, 0});
        for (int i = 0; i < 20'000; ++i)
            random_rays.push_back({anywhere(), uniform_direction(random_place(rng))});
        View view;
        view.from = {2, Real(1.5), 3};
        view.at = {0, 0, 0};
        view.vertical_fov = radians(35);
        const Camera camera = make_camera(view, 240, 180);
        for (int y = 0; y < 180; ++y)
            for (int x = 0; x < 240; ++x)
                rays.push_back(primary_ray(camera, x, y, {Real(0.5), Real(0.5)}));
    }
};

// Work to be timed: searches along all these rays in a world.
template <class World>
study::Work search_all(const World& world, const std::vector<Ray>& rays) {
    return [&] {
        for (const Ray& ray : rays) study::keep(world.hit(ray, {}));
    };
}

}  // namespace bvh
