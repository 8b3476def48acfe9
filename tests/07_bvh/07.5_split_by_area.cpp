#include <algorithm>
#include <numeric>
#include <rt/build.hpp>
#include <rt/sphere_tree.hpp>
#include <rt/split_by_area.hpp>

#include "scenes.hpp"
#include "tree_checks.hpp"

using namespace checkpoint;
using rt::surface_area;

namespace {

std::vector<int> numbers(std::size_t count) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    return order;
}

double area(const Box& box) {
    const double x = double(box.high.x) - double(box.low.x);
    const double y = double(box.high.y) - double(box.low.y);
    const double z = double(box.high.z) - double(box.low.z);
    return 2 * (x * y + y * z + z * x);
}

double cost_of(const std::vector<int>& order, std::size_t k, const std::vector<Box>& boxes) {
    Box left, right;
    for (std::size_t i = 0; i < order.size(); ++i) {
        Box& side = i < k ? left : right;
        side = rt::join(side, boxes[static_cast<std::size_t>(order[i])]);
    }
    const double n = double(order.size());
    if (k == 0) return n;
    return 1 +
           (double(k) * area(left) + (n - double(k)) * area(right)) / area(rt::join(left, right));
}

// The least cost of all splits, tried one by one.
double best_cost(const std::vector<Box>& boxes) {
    double best = double(boxes.size());
    for (int axis = 0; axis < 3; ++axis) {
        auto order = numbers(boxes.size());
        std::sort(order.begin(), order.end(), [&](int a, int b) {
            return rt::along(boxes[static_cast<std::size_t>(a)].center(), axis) <
                   rt::along(boxes[static_cast<std::size_t>(b)].center(), axis);
        });
        for (std::size_t k = 1; k < order.size(); ++k)
            best = std::min(best, cost_of(order, k, boxes));
    }
    return best;
}

void check_split(const std::vector<Box>& boxes, const char* hint) {
    auto order = numbers(boxes.size());
    const int left = rt::split_by_area(order, boxes);
    REQUIRE(left >= 0);
    REQUIRE(static_cast<std::size_t>(left) < boxes.size());
    REQUIRE(std::is_permutation(order.begin(), order.end(), numbers(boxes.size()).begin()));
    const double cost = cost_of(order, static_cast<std::size_t>(left), boxes);
    const double best = best_cost(boxes);
    INFO(boxes.size() << " spheres, yours puts " << left << " of them to the left, at a cost of "
                      << cost << "; the best costs " << best << ".\nHint: " << hint);
    // The areas are sums of three products: 8 roundings each, and three for the cost.
    CHECK(cost <= best * (1 + 4 * double(rt::rounding_bound(16))));
}

}  // namespace

TEST_CASE("07.5 the surface of a box", "[07.5]") {
    const Real two_three_four = surface_area(Box{{1, 1, 1}, {3, 4, 5}});
    HINT(Real(52), two_three_four, "six faces: 2 (2 * 3 + 3 * 4 + 4 * 2)");
    CHECK(two_three_four == 52);
    const Real flat = surface_area(Box{{0, 0, 0}, {1, 0, 1}});
    HINT(Real(2), flat, "a flat box still has two faces: an area and not a volume");
    CHECK(flat == 2);
}

TEST_CASE("07.5 two groups are kept apart", "[07.5]") {
    // 3 spheres at one end and 9 at the other.
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<Box> boxes;
        for (int i = 0; i < 12; ++i) {
            const Real far = i % 4 == 0 ? Real(100) : Real(0), step = static_cast<Real>(i);
            Vec3 p{far + step / 8, step / 4, -step / 4};
            for (int k = 0; k < axis; ++k) p = {p.z, p.x, p.y};
            boxes.push_back({p, p + Vec3{1, 1, 1}});
        }
        auto order = numbers(12);
        const int left = rt::split_by_area(order, boxes);
        HINT(Real(9), static_cast<Real>(left),
             "nine spheres are near 0 and three near 100: the boxes are smallest between them");
        REQUIRE(left == 9);
        const auto is_far = [&](int i) { return i % 4 == 0; };
        INFO("the near ones come first");
        CHECK(std::none_of(order.begin(), order.begin() + 9, is_far));
        CHECK(std::all_of(order.begin() + 9, order.end(), is_far));
    }
}

TEST_CASE("07.5 the cheapest of all splits is found", "[07.5]") {
    for (const int count : {2, 3, 5, 17, 40})
        for (std::uint64_t seed = 1; seed <= 8; ++seed)
            check_split(rt::bounds_of(random_spheres(count, seed)),
                        "try every k along every axis; count times area on either side; order and "
                        "k must belong to the same axis in the end");
}

TEST_CASE("07.5 a leaf where it is cheaper", "[07.5]") {
    std::vector<int> one{0};
    const std::vector<Box> at_one_place(12, Box{{0, 0, 0}, {1, 1, 1}});
    const int alone = rt::split_by_area(one, at_one_place);
    HINT(Real(0), static_cast<Real>(alone), "one sphere cannot be split");
    CHECK(alone == 0);
    auto order = numbers(12);
    const int left = rt::split_by_area(order, at_one_place);
    HINT(Real(0), static_cast<Real>(left),
         "12 boxes at one place: any split costs 1 + 12, a leaf 12");
    CHECK(left == 0);
}

TEST_CASE("07.5 rays test less in its tree", "[07.5]") {
    // Many small spheres on a huge one.
    Spheres spheres;
    rt::Rng rng{75, 1};
    add(spheres, {0, -100, 0}, 100);
    for (int i = 0; i < 500; ++i)
        add(spheres, 4 * in_cube(rng), Real(0.02) + (i % 50 == 0 ? Real(0.8) : Real(0)));
    const rt::SphereTree half = rt::make_tree(spheres, rt::split_in_half);
    const rt::SphereTree by_area = rt::make_tree(spheres, rt::split_by_area);
    long tests_half = 0, tests_area = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 from{0, 2, 12};
        const Ray ray{from, 4 * in_cube(rng) - from};
        const rt::Search a = half.search(ray, {}), b = by_area.search(ray, {});
        tests_half += a.box_tests + a.sphere_tests;
        tests_area += b.box_tests + b.sphere_tests;
    }
    INFO("tests a ray: " << tests_half / 300 << " in the sorted tree, " << tests_area / 300
                         << " in yours by area");
    CHECK(4 * tests_area < 3 * tests_half);
}

TEST_CASE("07.5 the empty box has no surface", "[07.5][hard]") {
    const Real empty = surface_area(Box{});
    HINT(Real(0), empty, "box.size() of the empty box is 0, high - low is minus infinity");
    CHECK(empty == 0);
}

TEST_CASE("07.5 hard scenes are split well", "[07.5][hard]") {
    for (const NamedScene& scene : hard_scenes()) {
        INFO(scene.name);
        check_split(rt::bounds_of(scene.spheres), "all middles or all boxes may be at one place");
        const rt::SphereTree tree = rt::make_tree(scene.spheres, rt::split_by_area);
        check_tree(*tree.root, tree.order, rt::bounds_of(scene.spheres));
    }
}

TEST_CASE("07.5 many spheres do not take long", "[07.5][hard]") {
    // With the areas of all spheres on one side computed anew for each k this would take minutes.
    const auto boxes = rt::bounds_of(random_spheres(60000));
    auto order = numbers(boxes.size());
    const int left = rt::split_by_area(order, boxes);
    INFO("yours puts " << left << " of 60000 to the left");
    CHECK(left > 20000);
    CHECK(left < 40000);
}
