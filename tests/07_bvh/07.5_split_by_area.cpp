#include <algorithm>
#include <numeric>
#include <rt/area_split.hpp>
#include <rt/build.hpp>
#include <rt/shape_tree.hpp>

#include "own_process.hpp"
#include "processor_time.hpp"
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

// Of a split into the first k of the order and the rest; of a leaf, if k is 0.
double cost_of(const std::vector<int>& order, std::size_t k, const std::vector<Box>& boxes,
               Real boxes_cost) {
    Box left, right;
    for (std::size_t i = 0; i < order.size(); ++i) {
        Box& side = i < k ? left : right;
        side = rt::join(side, boxes[static_cast<std::size_t>(order[i])]);
    }
    const double n = double(order.size());
    if (k == 0) return n;
    return double(boxes_cost) +
           (double(k) * area(left) + (n - double(k)) * area(right)) / area(rt::join(left, right));
}

std::vector<int> sorted_along(int axis, const std::vector<Box>& boxes, std::vector<int> order) {
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        const Real of_a = rt::along(boxes[static_cast<std::size_t>(a)].center(), axis);
        const Real of_b = rt::along(boxes[static_cast<std::size_t>(b)].center(), axis);
        return of_a != of_b ? of_a < of_b : a < b;
    });
    return order;
}

// The lowest cost of a leaf and of all splits between different centers, tried one by one. The
// learner chooses in which order equal centers come.
double best_cost(const std::vector<int>& numbers, const std::vector<Box>& boxes, Real boxes_cost) {
    double best = double(numbers.size());
    for (int axis = 0; axis < 3; ++axis) {
        const auto order = sorted_along(axis, boxes, numbers);
        const auto middle = [&](std::size_t k) {
            return rt::along(boxes[static_cast<std::size_t>(order[k])].center(), axis);
        };
        for (std::size_t k = 1; k < order.size(); ++k)
            if (middle(k - 1) < middle(k))
                best = std::min(best, cost_of(order, k, boxes, boxes_cost));
    }
    return best;
}

// The areas are sums of three products: 8 roundings each, and three for the cost. Where the sizes
// of a box are differences of large numbers, those are rounded as well.
double allowed(const std::vector<int>& order, const std::vector<Box>& boxes) {
    Box around;
    for (const int number : order)
        around = rt::join(around, boxes[static_cast<std::size_t>(number)]);
    const Real far = std::max(max_component(around.low), max_component(around.high));
    const Real rounded = far * rt::epsilon / max_component(around.size());
    return 1 + 4 * double(rt::rounding_bound(16)) + 16 * double(rounded);
}

void check_split(const std::vector<int>& part, const std::vector<Box>& boxes, Real boxes_cost) {
    auto order = part;
    const int left = rt::split_by_area(order, boxes, boxes_cost);
    REQUIRE(left >= 0);
    REQUIRE(static_cast<std::size_t>(left) < part.size());
    REQUIRE(from_smallest(order) == from_smallest(part));
    const auto k = static_cast<std::size_t>(left);
    const double cost = cost_of(order, k, boxes, boxes_cost),
                 best = best_cost(part, boxes, boxes_cost), leaf = double(order.size()),
                 factor = allowed(part, boxes);
    if (cost > best * factor) {
        std::string hint =
            "try every k from 1 to count - 1 along every axis; its cost is boxes_cost * area(A) + "
            "k * area(left) + (count - k) * area(right). In the end, the IDs must be sorted "
            "along the axis that "
            "k belongs to";
        if (k == 0)
            hint =
                "a split is cheaper than a leaf here. Everything is multiplied by area(A), so "
                "boxes_cost becomes boxes_cost * area(A); and A is the box around this part";
        else if (best >= leaf)
            hint = "a leaf is cheaper than any split: its cost is count * area(A)";
        else if (order.size() > 10)  // with few spheres it may be chance
            for (int axis = 0; axis < 3; ++axis)
                if (cost_of(sorted_along(axis, boxes, order), k, boxes, boxes_cost) <=
                    best * factor) {
                    hint =
                        "sort along the best axis once more: this count is right for the order "
                        "along ";
                    hint += "xyz"[axis];
                }
        INFO(part.size() << " spheres, boxes_cost " << boxes_cost << "; your split puts " << left
                         << " of them to the left, at a cost of " << cost
                         << "; the best split costs " << best << ", a leaf " << leaf
                         << ".\nHint: " << hint);
        REQUIRE(text(Real(cost)) == text(Real(best)));
    }
    if (k == 0) return;
    // In the order that was returned, no other k may be better.
    for (std::size_t other = 1; other < part.size(); ++other) {
        const double better = cost_of(order, other, boxes, boxes_cost);
        if (cost <= better * factor) continue;
        INFO(part.size()
             << " spheres; your split puts " << left << " of them to the left, at a cost of "
             << cost << "; the same order with " << other << " to the left costs " << better
             << ".\nHint: is this the order whose costs you computed? If you sort once more, equal "
                "centers must come in the same order: put the lower ID first");
        REQUIRE(text(Real(cost)) == text(Real(better)));
    }
}
void check_split(const std::vector<Box>& boxes, Real boxes_cost = 1) {
    check_split(numbers(boxes.size()), boxes, boxes_cost);
}

Box cube(Vec3 middle, Real half) {
    return {middle - Vec3{half, half, half}, middle + Vec3{half, half, half}};
}

template <class Work>
double seconds(const Work& work) {
    const double start = checkpoint::processor_seconds();
    work();
    return checkpoint::processor_seconds() - start;
}

}  // namespace

TEST_CASE("07.5 the surface of a box is the sum of its six faces", "[07.5]") {
    {
        const Real two_three_four = surface_area(Box{{1, 1, 1}, {3, 4, 5}});
        HINT(Real(52), two_three_four, "add up the six faces: 2 (2 * 3 + 3 * 4 + 4 * 2)");
        CHECK(two_three_four == 52);
    }
    const Real flat = surface_area(Box{{0, 0, 0}, {1, 0, 1}});
    HINT(Real(2), flat, "a flat box still has two faces: return the surface, not the volume");
    CHECK(flat == 2);
}

TEST_CASE("07.5 the surface is accurate for boxes of all sizes", "[07.5][hard]") {
    rt::Rng rng{75, 3};
    for (int i = 0; i < 2000; ++i) {
        const Real size = any_size(rng, -15, 15);
        const Vec3 low = size * in_cube(rng);
        Vec3 reach = size * Vec3{any_size(rng, -3, 1), any_size(rng, -3, 1), any_size(rng, -3, 1)};
        if (rng() % 8 == 0) reach.y = 0;
        if (rng() % 8 == 0) reach.z = 0;
        const Box box{low, low + reach};
        const Real computed = surface_area(box);
        const double error = std::abs(double(computed) - area(box));
        if (const bool right = error <= double(rt::rounding_bound(12)) * area(box); right) {
            CHECK(right);
            continue;
        }
        INFO(checkpoint::text(box));
        HINT(Real(area(box)), computed, "2 (x y + y z + z x), where (x, y, z) is box.size()");
        REQUIRE(text(computed) == text(Real(area(box))));
    }
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
        const int left = rt::split_by_area(order, boxes, 1);
        {
            HINT(Real(9), static_cast<Real>(left),
                 "nine spheres are near 0 and three near 100: the boxes are smallest if you split "
                 "between the two groups");
            REQUIRE(left == 9);
        }
        const auto is_far = [&](int i) { return i % 4 == 0; };
        INFO("the best split has 9 spheres on the left, along axis "
             << axis
             << ", but the nine near spheres do not come first.\n"
                "Hint: after all three axes the IDs are "
                "sorted along z; sort along the best axis once "
                "more");
        REQUIRE((std::none_of(order.begin(), order.begin() + 9, is_far) &&
                 std::all_of(order.begin() + 9, order.end(), is_far)));
    }
}

TEST_CASE("07.5 the cheapest of all splits is found", "[07.5]") {
    for (const int count : {2, 3, 5, 17, 300})
        for (std::uint64_t seed = 1; seed <= 8; ++seed)
            for (const Real boxes_cost : {Real(1), Real(4)})
                check_split(rt::bounds_of(random_spheres(count, seed)), boxes_cost);
}

TEST_CASE("07.5 the caller says what the test of both boxes costs", "[07.5]") {
    // Two groups of three cubes, far apart: few of the rays through A meet either group.
    std::vector<Box> boxes;
    for (int i = 0; i < 6; ++i)
        boxes.push_back(cube({i < 3 ? Real(0) : Real(100), 0, 0}, Real(0.5)));
    for (const Real boxes_cost : {Real(1), Real(4), Real(8)}) {
        auto order = numbers(boxes.size());
        const int left = rt::split_by_area(order, boxes, boxes_cost);
        INFO("boxes_cost is " << boxes_cost);
        HINT(Real(boxes_cost < 5 ? 3 : 0), static_cast<Real>(left),
             "few rays meet either group of three, so the split costs boxes_cost + 0.1, "
             "and a leaf 6");
        CHECK(left == (boxes_cost < 5 ? 3 : 0));
    }
}

// Few boxes at a time, because then a leaf often costs nearly as much as a split. They have all
// sizes, some are in one place, and between them are other boxes, which do not count.
TEST_CASE("07.5 the cheapest split or a leaf is chosen for any part of a scene", "[07.5][hard]") {
    rt::Rng rng{75, 5};
    for (int i = 0; i < 4000; ++i) {
        const Real size = any_size(rng, -9, 9);
        const int count = 1 + static_cast<int>(rng() % (i % 16 == 0 ? 60 : 8));
        const Real radius = any_size(rng, -2, 1);
        std::vector<Box> boxes;
        std::vector<int> order;
        const auto to_grid = [&](Real x) { return i % 2 ? x : std::round(2 * x) / 2; };
        while (static_cast<int>(order.size()) < count) {
            const Vec3 p = in_cube(rng), half = radius * abs(in_cube(rng));
            const Vec3 middle = Vec3{to_grid(p.x), to_grid(p.y), to_grid(p.z)};
            const bool counts = rng() % 3 > 0;
            if (counts) order.push_back(static_cast<int>(boxes.size()));
            boxes.push_back(counts ? Box{size * (middle - half), size * (middle + half)}
                                   : cube(3 * size * p, 5 * size * p.x * p.y));
        }
        for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[rng() % k]);
        check_split(order, boxes, Real(i % 5));
    }
}

TEST_CASE("07.5 a split that is only a little cheaper is chosen", "[07.5][hard]") {
    // Two splits that differ by less and less: boxes in a row, all but two of the gaps alike.
    for (Real more = Real(0.1); more > 64 * rt::epsilon; more /= 7)
        for (const bool first : {true, false})
            for (int axis = 0; axis < 3; ++axis) {
                std::vector<Box> boxes;
                Real at = 0;
                for (int i = 0; i < 9; ++i) {
                    Vec3 p{at, 0, 0};
                    for (int k = 0; k < axis; ++k) p = {p.z, p.x, p.y};
                    boxes.push_back(cube(p, Real(0.5)));
                    at += i == 3 ? 2 + (first ? more : 0) : i == 4 ? 2 + (first ? 0 : more) : 1;
                }
                check_split(boxes);
            }
}

TEST_CASE("07.5 a split and a leaf of almost the same cost are told apart", "[07.5][hard]") {
    // Two cubes, one moved by 1.5 edges: the split costs as much as the leaf. A move that is larger
    // by next to nothing makes the split cheaper, a smaller one the leaf. The costs then differ by
    // 100 epsilon, and rounding may change them by 20.
    const Real little = 256 * rt::epsilon;
    for (int i = 0; i < 200; ++i) {
        const Real edge = 1 + static_cast<Real>(i) / 41;
        for (const bool apart : {true, false}) {
            const Real gap = Real(1.5) * edge * (apart ? 1 + little : 1 - little);
            const std::vector<Box> boxes{{{0, 0, 0}, {edge, edge, edge}},
                                         {{gap, 0, 0}, {gap + edge, edge, edge}}};
            auto order = numbers(2);
            const int left = rt::split_by_area(order, boxes, 1);
            INFO("two cubes of edge " << checkpoint::text(edge) << ", the second one moved by "
                                      << checkpoint::text(gap) << " along x: " EXPECTED
                                      << (apart ? "1, the split" : "0, the leaf") << ", " ACTUAL
                                      << left);
            REQUIRE(left == (apart ? 1 : 0));
        }
    }
}

TEST_CASE("07.5 a leaf is made unless a split is cheaper", "[07.5]") {
    const auto expect_leaf = [](const std::vector<Box>& boxes, const char* hint) {
        auto order = numbers(boxes.size());
        const int left = rt::split_by_area(order, boxes, 1);
        HINT(Real(0), static_cast<Real>(left), hint);
        CHECK(left == 0);
    };
    const Box unit{{0, 0, 0}, {1, 1, 1}};
    expect_leaf({unit}, "one sphere cannot be split");
    expect_leaf(std::vector<Box>(300, unit),
                "300 boxes in one place: any split costs 1 + 300, and a leaf costs 300");
    expect_leaf(
        {unit, {{Real(1.5), 0, 0}, {Real(2.5), 1, 1}}},
        "the split costs 1 + (6 + 6) / 12 = 2, the same as a leaf; split only if that is cheaper");
}

TEST_CASE("07.5 no sphere is lost if the centers are equal", "[07.5]") {
    checkpoint::check_equal_centers(
        [](auto order, auto boxes) { rt::split_by_area(order, boxes, 1); });
}

TEST_CASE("07.5 only the boxes of the part that is split count", "[07.5]") {
    // Numbers 0 to 5 are huge, and do not belong to this part.
    std::vector<Box> boxes(6, cube({0, 0, 0}, 1000));
    for (int i = 0; i < 6; ++i) boxes.push_back(cube({5, 0, 0}, Real(0.5)));
    auto order = numbers(boxes.size());
    const int left = rt::split_by_area(std::span{order}.subspan(6), boxes, 1);
    HINT(Real(0), static_cast<Real>(left),
         "6 equal boxes in one place make a leaf. A is the box around those whose IDs are in "
         "order: for (int id : order) join boxes[id]");
    CHECK(left == 0);
}

TEST_CASE("07.5 rays need fewer tests than in a tree split in half", "[07.5]") {
    // Many small spheres on a huge one.
    Spheres spheres;
    rt::Rng rng{75, 1};
    add(spheres, {0, -100, 0}, 100);
    for (int i = 0; i < 500; ++i)
        add(spheres, 4 * in_cube(rng), Real(0.02) + (i % 50 == 0 ? Real(0.8) : Real(0)));
    const rt::SphereTree half = rt::make_tree(spheres, rt::split_in_half);
    const rt::SphereTree by_area = rt::make_tree(spheres, rt::AreaSplit{1});
    long tests_half = 0, tests_area = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 from{0, 2, 12};
        const Ray ray{from, 4 * in_cube(rng) - from};
        const rt::Search a = half.search(ray, {}), b = by_area.search(ray, {});
        tests_half += a.box_tests + a.shape_tests;
        tests_area += b.box_tests + b.shape_tests;
    }
    INFO("tests per ray: " << tests_half / 300 << " in the sorted tree, " << tests_area / 300
                           << " in yours by area");
    INFO("Hint: if all tests above pass, check that A is the box around this part alone");
    CHECK(4 * tests_area < 3 * tests_half);
}

TEST_CASE("07.5 the surface of the empty box is 0", "[07.5]") {
    const Real empty = surface_area(Box{});
    HINT(Real(0), empty, "box.size() of the empty box is 0, but high - low is minus infinity");
    CHECK(empty == 0);
}

TEST_CASE("07.5 boxes without area stay together in a leaf", "[07.5][hard]") {
    for (const Real length : {Real(0), Real(0.5), Real(2)}) {
        std::vector<Box> boxes;
        for (Real x = 0; x < 8; ++x) boxes.push_back({{x, 0, 0}, {x + length, 0, 0}});
        auto order = numbers(boxes.size());
        const int left = rt::split_by_area(order, boxes, 1);
        HINT(Real(0), static_cast<Real>(left),
             "the box around 8 points or lines on the x axis has area 0: nothing is cheaper");
        CHECK(left == 0);
    }
}

TEST_CASE("07.5 the cheapest splits are found in hard scenes", "[07.5][hard]") {
    for (const NamedScene& scene : hard_scenes()) {
        INFO(scene.name);
        check_split(rt::bounds_of(scene.spheres));
        const rt::SphereTree tree = rt::make_tree(scene.spheres, rt::AreaSplit{});
        check_tree(*tree.root, tree.order, rt::bounds_of(scene.spheres));
    }
}

TEST_CASE("07.5 boxes with equal centers keep the order whose cost was computed", "[07.5][hard]") {
    // All centers are in one place: sorting may leave the huge box anywhere.
    rt::Rng rng{75, 7};
    for (int i = 0; i < 60; ++i) {
        const int count = 17 + static_cast<int>(rng() % 60);
        std::vector<Box> boxes(static_cast<std::size_t>(count), cube({0, 0, 0}, 1));
        for (Box& box : boxes)
            if (i >= 20) box = cube({0, 0, 0}, rng.uniform(Real(0.1), 1));
        boxes[i == 0 ? 0 : rng() % boxes.size()] = cube({0, 0, 0}, 100);
        auto order = numbers(boxes.size());
        for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[rng() % k]);
        {
            auto split = order;
            const int left = rt::split_by_area(split, boxes, 1);
            INFO(count
                 << " boxes with the same center, one of them huge: whatever your rule for equal "
                    "centers, some of the boxes can be split off from the huge one\nHint: any k "
                    "may be the best, even where the centers to its left and right are equal");
            REQUIRE(left > 0);
        }
        check_split(order, boxes, 1);
    }
}

TEST_CASE("07.5 splitting many spheres takes less than 15 times as long as sorting them",
          "[07.5][hard]") {
    const auto boxes = rt::bounds_of(random_spheres(8000));
    // Compared with the time of sorting, which any solution needs: little more than that, but more
    // than 40 times as much if the boxes of one side are computed again for each k.
    double ratio = 0;
    int left = 0;
    for (int attempt = 0; attempt < 3; ++attempt) {
        auto order = numbers(boxes.size());
        const double sorting = seconds([&] {
            for (const int axis : {0, 1, 2, 0}) order = sorted_along(axis, boxes, order);
        });
        order = numbers(boxes.size());
        const double all = seconds([&] { left = rt::split_by_area(order, boxes, 4); });
        ratio = all / sorting;
        if (ratio < 15) break;
    }
    INFO("8000 spheres: your split takes "
         << ratio
         << " times the time of sorting them.\nHint: let a box grow by one sphere per step, once "
            "from each end, and keep the areas. Then sorting is what takes longest");
    CHECK(ratio < 15);
    INFO("your split puts " << left << " of 8000 to the left");
    CHECK(left > 2650);
    CHECK(left < 5350);
}

TEST_CASE("07.5 as many spheres as fit into memory can be split", "[07.5][hard]") {
    constexpr int count = 200'000;
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) boxes.push_back(cube({static_cast<Real>(i), 0, 0}, 1));
    auto order = numbers(boxes.size());
    // With half a megabyte of stack: less than one number for each sphere needs.
    const std::string actual = in_own_process(
        [&] {
            const int left = rt::split_by_area(order, boxes, 1);
            return left > count / 4 && left < count / 4 * 3 ? "split" : std::to_string(left);
        },
        3, std::size_t{512} << 10);
    INFO(count << " spheres in a row\nHint: an array on the stack, or one of fixed length, is too "
                  "small for the areas of a large scene. A std::vector of as many numbers as there "
                  "are spheres is not. It may also have taken too long");
    CHECK(actual == "split");
}
