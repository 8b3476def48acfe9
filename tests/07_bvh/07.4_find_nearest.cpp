#include <rt/sphere_tree.hpp>

#include "scenes.hpp"

using namespace checkpoint;

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
                "Hint, if this crashes: a leaf has no children, so return after its spheres; these "
                "are at the places first ... first + count - 1 of search.order");
            rt::find_nearest(root, search);
        }
        INFO(
            "sphere 2 is in no leaf.\nHint: a leaf's places are first ... first + count - 1: < and "
            "not <=");
        CHECK(search.nearest != 2);
        return search;
    }
};

void check_winner(const rt::Search& search, const Winner& expected, const char* hint) {
    const Winner found{search.nearest, search.within.max};
    INFO("expected " << text(expected) << ", but yours gives " << text(found)
                     << ".\nHint: " << hint);
    CHECK(found.sphere == expected.sphere);
    if (expected.sphere >= 0) CHECK(same_bits(found.t, expected.t));
}

// The same winner as the linear list, bit for bit, for this many rays.
void check_scene(const std::string& name, const Spheres& spheres, int rays) {
    const rt::SphereTree tree = rt::make_tree(spheres, rt::split_in_half);
    rt::Rng rng{74, spheres.size()};
    for (int i = 0; i < rays; ++i) {
        const Ray ray = any_ray(spheres, rng, i);
        const Interval within = i % 16 == 1 ? Interval{Real(0.25), 2} : Interval{};
        const Winner expected = linear(spheres, ray, within);
        const rt::Search search = tree.search(ray, within);
        if (search.nearest == expected.sphere &&
            (expected.sphere < 0 || same_bits(search.within.max, expected.t)))
            continue;
        INFO(name << ", " << checkpoint::text(ray));
        check_winner(search, expected, "the linear list finds this one");
        return;
    }
}

}  // namespace

TEST_CASE("07.4 the nearer of two spheres is found", "[07.4]") {
    const Ray ray{{0, 0, 0}, {0, 0, -1}};
    const rt::Sphere near{{0, 0, -5}, 1}, far{{0, 0, -9}, 1};
    check_winner(ByHand{near, far}.search(ray), {0, 4}, "the left one is nearer");
    check_winner(ByHand{far, near}.search(ray), {1, 4},
                 "the right one is nearer: a hit on the left does not end the search");
    check_winner(ByHand{far, {{5, 0, -5}, 1}}.search(ray), {0, 8}, "only the left one is hit");
    check_winner(ByHand{{{5, 0, -5}, 1}, far}.search(ray), {1, 8}, "only the right one is hit");
    check_winner(ByHand{near, far}.search({{0, 0, 0}, {0, 1, 0}}), {}, "neither is hit");
}

TEST_CASE("07.4 only hits within the interval count", "[07.4]") {
    const Ray ray{{0, 0, 0}, {0, 0, -1}};
    const ByHand two{{{0, 0, -5}, 1}, {{0, 0, -9}, 1}};
    check_winner(two.search(ray, {0, 3}), {}, "both are beyond the interval's end");
    check_winner(two.search(ray, {7, 100}), {1, 8}, "the left one lies before the interval");
    check_winner(two.search(ray, {0, 4}), {0, 4}, "the ends of the interval belong to it");
}

TEST_CASE("07.4 of equally near spheres the last in the list counts", "[07.4]") {
    const Ray ray{{0, 0, 0}, {0, 0, -1}};
    ByHand same{{{0, 0, -5}, 1}, {{0, 0, -5}, 1}};
    const char* const hint =
        "both hits are at t = 4: the higher number counts, whichever comes first in the tree";
    check_winner(same.search(ray), {1, 4}, hint);
    same.order = {1, 0, 2};
    check_winner(same.search(ray), {1, 4}, hint);
    // An interval that ends right at the only hit has no sphere to compare with.
    rt::Search search{same.spheres, same.order, ray, {0, 4}};
    rt::try_sphere(0, search);
    check_winner(search, {0, 4}, "nothing was found before: the first hit counts");
}

TEST_CASE("07.4 the same hits as the linear list", "[07.4]") {
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
        tests += search.sphere_tests;
    }
    boxes /= rays;
    tests /= rays;
    const char* hint = "does [07.3] pass? If so, look at find_nearest and at what it asks";
    if (boxes == 0)
        hint = "ask search.meets(node.box): it counts, and knows the interval that boxes need";
    else if (tests == 0)
        hint = "ask search.meets_sphere(number): it counts";
    else if (boxes >= 1000)
        hint =
            "return at once where search.meets(node.box) is false; if you do, all boxes are too "
            "large: does [07.3] pass?";
    else if (tests > boxes / 2)
        hint = "a leaf has a box, too: ask it before its spheres";
    else if (boxes > 95)
        hint =
            "ask each box only once: either a node its own or its parent, but not both. And is "
            "search.within.max moved to each hit?";
    INFO("4096 spheres, 2047 boxes; for a ray yours tests " << boxes << " boxes and " << tests
                                                            << " spheres. Expected are about 79 "
                                                               "and 30.\nHint: "
                                                            << hint);
    CHECK(boxes < 95);
    CHECK(boxes > 20);
    CHECK(tests < 40);
    CHECK(tests > 20);
}

TEST_CASE("07.4 hits move the end of the search", "[07.4]") {
    // 1000 spheres behind each other: behind the first hit there is nothing to look for.
    Spheres spheres;
    for (int i = 0; i < 1024; ++i) add(spheres, {static_cast<Real>(i), 0, 0}, Real(0.25));
    const rt::SphereTree tree = rt::make_tree(spheres, rt::split_in_half);
    const rt::Search search = tree.search(Ray{{-5, 0, 0}, {1, 0, 0}}, {});
    INFO("a ray along a row of 1024 spheres; yours tests " << search.box_tests << " boxes and "
                                                           << search.sphere_tests << " spheres.");
    INFO(
        "Hint: left comes before right, and what lies behind a hit is not met any more once "
        "search.within.max is the hit's t");
    check_winner(search, {0, Real(4.75)}, "the first in the row");
    CHECK(search.sphere_tests <= 8);
    CHECK(search.box_tests <= 30);
}

TEST_CASE("07.4 hard scenes give the same hits bit for bit", "[07.4][hard]") {
    for (const NamedScene& scene : hard_scenes()) check_scene(scene.name, scene.spheres, 6000);
}
