#include <atomic>
#include <functional>
#include <future>
#include <numeric>
#include <rt/shape_tree.hpp>
#include <thread>

#include "scenes.hpp"

using namespace checkpoint;
using answer::ManyNode;
using answer::ManySearch;
using answer::MovedSearch;
using answer::ShadowSearch;
using rt::infinity;

namespace {

// A tree of two leaves, made by hand. The third sphere is in the order, but in no leaf.
struct ByHand {
    Spheres spheres;
    std::vector<int> order{0, 1, 2};
    rt::TreeNode root;

    ByHand(const rt::Sphere& left, const rt::Sphere& right) {
        spheres = {{left, 0}, {right, 1}, {{{0, 0, -3}, Real(0.5)}, 2}};
        for (auto* child : {&root.left, &root.right}) {
            *child = std::make_unique<rt::TreeNode>();
            (*child)->count = 1;
        }
        root.right->first = 1;
        root.left->box = rt::bounds_of(left);
        root.right->box = rt::bounds_of(right);
        root.box = rt::join(root.left->box, root.right->box);
    }
    rt::Search search(const Ray& ray, Interval within = {}) const {
        rt::Search search{spheres, order, ray, within};
        {
            INFO(
                IF_IT_CRASHES
                "a leaf has no children, so return after its spheres; and a ray may miss a sphere");
            if (search.meets(root.box)) rt::find_nearest(root, search);
        }
        INFO("sphere 2 is in no leaf.\nHint: search.shapes_in(node) has the IDs of a leaf");
        CHECK(search.nearest != 2);
        return search;
    }
};

void check_winner(const rt::Search& search, const Winner& expected, const char* hint) {
    const Winner found{search.nearest, search.within.max};
    INFO("Hint: " << hint);
    const bool same =
        found.sphere == expected.sphere && (expected.sphere < 0 || same_bits(found.t, expected.t));
    if (same)
        CHECK(same);
    else
        CHECK(text(found) == text(expected));
}

// A tree over this part of an order, in a shape that split chooses: given a number of spheres,
// split says how many of them go to the left, or 0 for a leaf.
std::unique_ptr<rt::TreeNode> shaped_tree(const std::vector<int>& order,
                                          const std::vector<Box>& boxes, int first, int count,
                                          const std::function<int(int)>& split) {
    auto node = std::make_unique<rt::TreeNode>();
    for (int place = first; place < first + count; ++place) {
        const int number = order[static_cast<std::size_t>(place)];
        node->box = rt::join(node->box, boxes[static_cast<std::size_t>(number)]);
    }
    const int left = split(count);
    if (left == 0) {
        node->first = first;
        node->count = count;
    } else {
        node->left = shaped_tree(order, boxes, first, left, split);
        node->right = shaped_tree(order, boxes, first + left, count - left, split);
    }
    return node;
}

std::vector<int> shuffled(int count, rt::Rng& rng) {
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[rng() % k]);
    return order;
}

// What a search must be after it has gone through a tree, computed with a list of waiting nodes.
void expect_of(const rt::TreeNode& root, rt::Search& search) {
    std::vector<rt::MetChild> waiting{{-infinity, &root}};
    while (!waiting.empty()) {
        const rt::MetChild next = waiting.back();
        const rt::TreeNode& node = next.node();
        waiting.pop_back();
        if (!search.reaches(next)) continue;
        if (!node.is_leaf()) {
            const auto children = search.children_of(node);
            waiting.insert(waiting.end(), children.begin(), children.end());
            std::reverse(waiting.end() - (children.end() - children.begin()), waiting.end());
            continue;
        }
        for (int place = node.first; place < node.first + node.count; ++place) {
            const int number = search.order[static_cast<std::size_t>(place)];
            const auto t = search.meets_shape(number);
            if (!t || (*t == search.within.max && search.nearest > number)) continue;
            search.within.max = *t;
            search.nearest = number;
        }
    }
}

std::string state(const rt::Search& search) {
    return (search.nearest < 0 ? "no hit" : "sphere " + std::to_string(search.nearest)) +
           ", t from " + text(search.within.min) + " to " + text(search.within.max) + ", " +
           std::to_string(search.box_tests) + " box tests, " + std::to_string(search.shape_tests) +
           " sphere tests";
}

// The same winner as the linear list, bit for bit, for this many rays.
void check_scene(const std::string& name, const Spheres& spheres, int rays) {
    const rt::SphereTree tree = rt::make_tree(spheres, rt::split_in_half);
    rt::Rng rng{74, spheres.size()};
    int right = 0;
    for (int i = 0; i < rays; ++i) {
        const Ray ray = any_ray(spheres, rng, i);
        const Interval within = i % 16 == 1 ? Interval{Real(0.25), 2} : Interval{};
        const Winner expected = linear(spheres, ray, within);
        const rt::Search search = tree.search(ray, within);
        if (search.nearest == expected.sphere &&
            (expected.sphere < 0 || same_bits(search.within.max, expected.t))) {
            ++right;
            continue;
        }
        INFO(name << ", " << checkpoint::text(ray));
        check_winner(search, expected, "the linear list finds this hit");
        return;
    }
    CHECK(right == rays);
}

}  // namespace

TEST_CASE("07.4 the nearer of two spheres is found", "[07.4]") {
    const Ray ray{{0, 0, 0}, {0, 0, -1}};
    const rt::Sphere near{{0, 0, -5}, 1}, far{{0, 0, -9}, 1};
    check_winner(ByHand{near, far}.search(ray), {0, 4}, "the left sphere is nearer");
    check_winner(ByHand{far, near}.search(ray), {1, 4},
                 "the right sphere is nearer: a hit on the left does not end the search");
    check_winner(ByHand{far, {{5, 0, -5}, 1}}.search(ray), {0, 8}, "only the left sphere is hit");
    const ByHand scene{near, far};
    rt::Search search{scene.spheres, scene.order, ray, {}};
    for (const int number : {1, 0}) rt::try_shape(number, search);
    check_winner(search, {0, 4},
                 "try_shape finds sphere 1, then a nearer hit on sphere 0. Every nearer hit "
                 "counts: only at the same t, the IDs decide");
    check_winner(ByHand{{{5, 0, -5}, 1}, far}.search(ray), {1, 8}, "only the right sphere is hit");
    check_winner(ByHand{near, far}.search({{0, 0, 0}, {0, 1, 0}}), {}, "neither sphere is hit");
}

TEST_CASE("07.4 only hits within the interval count", "[07.4]") {
    const Ray ray{{0, 0, 0}, {0, 0, -1}};
    const ByHand two{{{0, 0, -5}, 1}, {{0, 0, -9}, 1}};
    check_winner(two.search(ray, {0, 3}), {}, "both spheres are beyond the interval's end");
    check_winner(two.search(ray, {7, 100}), {1, 8}, "the left sphere lies before the interval");
    check_winner(two.search(ray, {0, 4}), {0, 4}, "the ends of the interval belong to it");
}

TEST_CASE("07.4 of equally near spheres the last in the list counts", "[07.4]") {
    const Ray ray{{0, 0, 0}, {0, 0, -1}};
    ByHand same{{{0, 0, -5}, 1}, {{0, 0, -5}, 1}};
    const char* const hint =
        "both hits are at t = 4: the higher ID counts, whichever comes first in the tree";
    check_winner(same.search(ray), {1, 4}, hint);
    same.order = {1, 0, 2};
    check_winner(same.search(ray), {1, 4}, hint);
    // An interval that ends right at the only hit has no sphere to compare with.
    rt::Search search{same.spheres, same.order, ray, {0, 4}};
    rt::try_shape(0, search);
    check_winner(search, {0, 4}, "nothing was found before: the first hit counts");
}

TEST_CASE("07.4 near ties are decided by t and exact ties by ID", "[07.4][hard]") {
    rt::Rng rng{74, 3};
    for (int i = 0; i < 4000; ++i) {
        const Real size = any_size(rng, -9, 9);
        const Vec3 d = any_direction(rng), middle = size * in_cube(rng);
        Spheres spheres;
        std::vector<Vec3> motions;
        const int count = 2 + static_cast<int>(rng() % 4);
        for (int k = 0; k < count; ++k) {
            // Farther away by nothing, by one rounding, or by more.
            const Real by = rng() % 3 == 0 ? Real(0) : any_size(rng, rng() % 2 ? -17 : -8, 0);
            const bool behind = rng() % 16 == 0;
            add(spheres, middle + (by - (behind ? 20 : 0)) * size * d, size);
            motions.push_back(i % 2 ? Vec3{} : any_size(rng, -17, 0) * size * in_cube(rng));
        }
        const Ray ray{middle - (3 + 9 * rng.uniform()) * size * d, any_size(rng, -3, 3) * d};
        Spheres there = spheres;
        for (std::size_t k = 0; k < there.size(); ++k)
            there[k].shape = rt::moved(there[k].shape, motions[k]);
        Interval within;
        if (i % 8 == 0) within = {-infinity, infinity};
        if (i % 8 == 1)
            if (const auto t = rt::hit_sphere(there[0].shape, ray, {})) within.max = *t;
        const Winner expected = linear(there, ray, within);
        MovedSearch search{{spheres, {}, ray, within}, motions};
        for (const int number : shuffled(count, rng)) rt::try_shape(number, search);
        rt::Search after = search;
        after.nearest = expected.sphere;
        after.within = {within.min, expected.sphere < 0 ? within.max : expected.t};
        after.box_tests = 0;
        after.shape_tests = count;
        if (const bool same = state(search) == state(after); same) {
            CHECK(same);
            continue;
        }
        INFO(
            count << " spheres whose hits are almost or exactly at the same t; the first is hit at "
                  << text(rt::hit_sphere(there[0].shape, ray, {}).value_or(-1)));
        INFO(
            "Hint: compare t with == and <, and the IDs only at the same t. Test each sphere "
            "once, by search.meets_shape");
        REQUIRE(state(search) == state(after));
    }
}

TEST_CASE("07.4 a search of another type uses its own functions", "[07.4]") {
    const ByHand two{{{0, 0, -5}, 1}, {{0, 0, -9}, 1}};
    const std::vector<Vec3> motions{{0, 0, -1}, {0, 0, 2}, {}};
    MovedSearch search{{two.spheres, two.order, {{0, 0, 0}, {0, 0, -1}}, {}}, motions};
    rt::find_nearest(two.root, search);
    check_winner(
        search, {0, 5},
        "chapter 08 searches with other types, whose meets_shape finds spheres that move: leave "
        "\"template <class AnySearch>\" as it is, and pass the search on as AnySearch&");
}

TEST_CASE("07.4 a node may have three children", "[07.4]") {
    // Three leaves, of which the second is entered first, and a node with one leaf.
    const ManyNode root{
        0, {{2, {}, {0, 1}}, {1, {}, {2, 3, 4}}, {Real(2.5), {{3, {}, {5}}}, {}}}, {}};
    const auto search = [&](std::vector<Real> hits) {
        ManySearch done{std::move(hits)};
        rt::find_nearest(root, done);
        return done;
    };
    struct Case {
        std::vector<Real> hits;
        int nearest, opened, shape_tests;
        const char* hint;
    };
    const Real none = std::numeric_limits<Real>::quiet_NaN();
    const Case cases[] = {
        {{4, 4, none, none, none, 5}, 1, 2, 6, "two shapes at the same t: the higher ID"},
        {{4, 6, 5, none, none, 3}, 5, 2, 6, "the third child has the nearest shape"},
        {{none, none, none, none, none, 3}, 5, 2, 6, "only the third child has a hit"},
        {{4, 6, none, none, Real(1.5), 5},
         4,
         1,
         3,
         "a hit in the nearest child lies in front of both others: ask search.reaches(child) just "
         "before you search a child"},
        {{Real(2.25), 6, 5, 3, none, 5},
         0,
         1,
         5,
         "a hit in the second child lies in front of the third: ask search.reaches(child) just "
         "before you search each child"},
        {{none, none, none, none, none, none}, -1, 2, 6, "no shape is hit"},
    };
    for (const Case& c : cases) {
        const ManySearch found = search(c.hits);
        const auto state_of = [](int nearest, int opened, int tests) {
            return (nearest < 0 ? "no hit" : "shape " + std::to_string(nearest)) + " after " +
                   std::to_string(opened) + " calls of children_of and " + std::to_string(tests) +
                   " of meets_shape";
        };
        INFO(
            "a node with three children, as in the wide tree.\nHint: go through all of "
            "search.children_of(node), in their order; "
            << c.hint);
        CHECK(state_of(found.nearest, found.opened, found.shape_tests) ==
              state_of(c.nearest, c.opened, c.shape_tests));
    }
}

TEST_CASE("07.4 a shadow ray's search ends at its first hit", "[07.4]") {
    const Spheres spheres = random_spheres(300);
    const rt::SphereTree tree = rt::make_tree(spheres, rt::split_in_half);
    rt::Rng rng{74, 6};
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = any_ray(spheres, rng, i);
        const bool expected = linear(spheres, ray, {}).sphere >= 0;
        ShadowSearch search{rt::Search{tree.shapes, tree.order, ray, {}}};
        rt::find_nearest(*tree.root, search);
        ShadowSearch again = search;  // if it has found a hit, it goes no farther than the root
        rt::find_nearest(*tree.root, again);
        const int more = again.shape_tests - search.shape_tests;
        INFO("300 spheres, " << text(ray) << ": " << (expected ? "something" : "nothing")
                             << " is in the way");
        INFO(
            "Hint: for a shadow ray, search.reaches(child) is false after the first hit: ask it "
            "just before you search a child");
        if (search.found() == expected && (!expected || more == 0)) continue;
        REQUIRE(search.found() == expected);
        REQUIRE((!expected || more == 0));
    }
    SUCCEED();
}

TEST_CASE("07.4 the tree gives the same hits as the linear list", "[07.4]") {
    for (const int count : {0, 1, 2, 3, 10, 300})
        check_scene(std::to_string(count) + " spheres", random_spheres(count), 4000);
}

TEST_CASE("07.4 most boxes and spheres are skipped", "[07.4]") {
    const Spheres spheres = random_spheres(4096);
    const rt::SphereTree tree = rt::make_tree(spheres, rt::split_in_half);
    rt::Rng rng{74, 9};
    long boxes = 0, tests = 0;
    const int rays = 300;
    for (int i = 0; i < rays; ++i) {
        const Vec3 from = 2 * any_direction(rng);
        const rt::Search search = tree.search(Ray{from, in_cube(rng) - from}, {});
        boxes += search.box_tests;
        tests += search.shape_tests;
    }
    boxes /= rays;
    tests /= rays;
    const char* hint = "look at what find_nearest tests";
    if (boxes < 40)
        hint = "go through search.children_of(node): it counts the box tests";
    else if (tests == 0)
        hint = "call search.meets_shape(id): it counts the sphere tests";
    else if (boxes > 110)
        hint =
            "call search.children_of(node) once for each node. And do you move search.within.max "
            "to each hit?";
    else if (boxes > 80)
        hint = "search the children in the order in which search.children_of(node) gives them";
    else if (boxes > 60)
        hint = "search a child only if search.reaches(child) is true just before";
    INFO("4096 spheres, 2047 boxes; per ray your search tests "
         << boxes << " boxes and " << tests
         << " spheres; " EXPECTED "about 58 and 20.\nHint: " << hint);
    CHECK(boxes <= 60);
    CHECK(boxes > 40);
    CHECK(tests < 24);
    CHECK(tests > 16);
}

TEST_CASE("07.4 each hit shortens the interval of the search", "[07.4]") {
    // 1024 spheres, one behind the other: behind the first hit there is nothing to look for.
    Spheres spheres;
    for (int i = 0; i < 1024; ++i) add(spheres, {static_cast<Real>(i), 0, 0}, Real(0.25));
    const rt::SphereTree tree = rt::make_tree(spheres, rt::split_in_half);
    const rt::Search search = tree.search(Ray{{-5, 0, 0}, {1, 0, 0}}, {});
    INFO("a ray along a row of 1024 spheres; your search tests "
         << search.box_tests << " boxes and " << search.shape_tests << " spheres.");
    INFO(
        "Hint: the nearest child comes first. Once search.within.max is the hit's t, "
        "search.reaches(child) is false for every child behind the hit");
    check_winner(search, {0, Real(4.75)}, "the first sphere of the row is the nearest");
    CHECK(search.shape_tests <= 4);
    CHECK(search.box_tests <= 18);
}

TEST_CASE("07.4 each necessary box is tested once and the nearest first", "[07.4][hard]") {
    rt::Rng rng{74, 5};
    for (int i = 0; i < 250; ++i) {
        const int count = 1 + static_cast<int>(rng() % 60),
                  largest = 1 + static_cast<int>(rng() % 9);
        const Spheres spheres = random_spheres(count, rng());
        const auto boxes = rt::bounds_of(spheres);
        const auto order = shuffled(count, rng);
        const auto split = [&](int n) {
            if (n == 1 || (n <= largest && rng() % 2)) return 0;
            return 1 + static_cast<int>(rng() % static_cast<unsigned>(n - 1));
        };
        // Two trees, one after the other: what was found in the first counts in the second.
        const int half = count / 2;
        const auto one = shaped_tree(order, boxes, half, count - half, split);
        const auto two = half ? shaped_tree(order, boxes, 0, half, split) : nullptr;
        for (int k = 0; k < 32; ++k) {
            const Ray ray = any_ray(spheres, rng, k);
            const Real a = rng.uniform(-2, 2), b = rng.uniform(-2, 4);
            const Interval within = k % 3 == 0   ? Interval{std::min(a, b), std::max(a, b)}
                                    : k % 3 == 1 ? Interval{std::abs(a), infinity}
                                                 : Interval{};
            rt::Search search{spheres, order, ray, within}, expected = search;
            rt::find_nearest(*one, search);
            expect_of(*one, expected);
            if (two && state(search) == state(expected)) {
                rt::find_nearest(*two, search);
                expect_of(*two, expected);
            }
            if (const bool same = state(search) == state(expected); same) {
                CHECK(same);
                continue;
            }
            INFO("a tree of " << count << " spheres, " << text(ray) << ", t from "
                              << text(within.min) << " to " << text(within.max));
            INFO(
                "Hint: call search.children_of once for each node that is no leaf. Search its "
                "children in this order, each with everything below it, and ask "
                "search.reaches(child) just before. Test each of a leaf's shapes once");
            REQUIRE(state(search) == state(expected));
        }
    }
}

TEST_CASE("07.4 a tree may have 84 levels", "[07.4][hard]") {
    // most_levels, and 20 more to halve a million. From either end of a row of spheres.
    const int levels = rt::most_levels + 20;
    Spheres spheres;
    for (int i = 0; i < levels; ++i) add(spheres, {static_cast<Real>(i), 0, 0}, Real(0.25));
    const auto boxes = rt::bounds_of(spheres);
    std::vector<int> order(spheres.size());
    std::iota(order.begin(), order.end(), 0);
    for (int shape = 0; shape < 3; ++shape) {
        const auto tree = shaped_tree(order, boxes, 0, levels, [&](int n) {
            if (n == 1) return 0;
            return shape == 0 || (shape == 1 && n % 2) ? 1 : n - 1;
        });
        for (const int way : {1, -1}) {
            const Real start = way > 0 ? Real(-5) : static_cast<Real>(levels + 4);
            const Ray ray{{start, 0, 0}, {static_cast<Real>(way), 0, 0}};
            rt::Search search{spheres, order, ray, {}}, expected = search;
            {
                INFO(IF_IT_CRASHES
                     "a list of nodes still to visit needs room for as many nodes as the tree has "
                     "levels");
                rt::find_nearest(*tree, search);
            }
            expect_of(*tree, expected);
            INFO("a tree of " << levels << " levels, with one sphere beside each node");
            INFO("Hint: set no limit of your own, neither on levels nor on waiting nodes");
            CHECK(state(search) == state(expected));
        }
    }
}

TEST_CASE("07.4 many threads can search one tree at the same time", "[07.4][hard]") {
    const Spheres spheres = random_spheres(300);
    const rt::SphereTree tree = rt::make_tree(spheres, rt::split_in_half);
    const auto ray = [&](int i) {
        rt::Rng rng{74, static_cast<std::uint64_t>(i)};
        return any_ray(spheres, rng, i);
    };
    std::vector<int> alone;
    for (int i = 0; i < 3000; ++i) alone.push_back(tree.search(ray(i), {}).nearest);
    std::atomic<int> to_come = 4;
    const auto searches = [&] {
        for (--to_come; to_come > 0;) std::this_thread::yield();  // all begin at once
        int others = 0;
        for (int again = 0; again < 6; ++again)
            for (int i = 0; i < 3000; ++i)
                others += tree.search(ray(i), {}).nearest != alone[static_cast<std::size_t>(i)];
        return others;
    };
    std::vector<std::future<int>> threads;
    for (int i = to_come; i > 0; --i) threads.push_back(std::async(std::launch::async, searches));
    int others = 0;
    for (auto& thread : threads) others += thread.get();
    INFO(
        "the number of rays whose hit changes when four threads search at the same time.\nHint: "
        "use no static variable: all that belongs to one ray is in its search");
    CHECK(others == 0);
}

TEST_CASE("07.4 tree and list give the same hits in hard scenes bit for bit", "[07.4][hard]") {
    for (const NamedScene& scene : hard_scenes()) check_scene(scene.name, scene.spheres, 6000);
}

TEST_CASE("07.4 a leaf and a scene may have many spheres", "[07.4]") {
    // One leaf at the end of a long order. Only its last sphere, with the highest number, is met.
    constexpr int count = 70'040, in_leaf = 40;
    Spheres spheres(count, rt::SceneSphere{{{50, 0, -5}, 1}, 0});
    spheres.back().shape.center = {0, 0, -5};
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    rt::TreeNode leaf;
    leaf.first = count - in_leaf;
    leaf.count = in_leaf;
    leaf.box = {{-99, -99, -99}, {99, 99, 99}};
    rt::Search search{spheres, order, {{0, 0, 0}, {0, 0, -1}}, {}};
    rt::find_nearest(leaf, search);
    CHECK(search.nearest == count - 1);
    CHECK(search.shape_tests == in_leaf);
}
