// The structures that the chapter gives: each returns the hits of the linear list, bit for bit.

#include <rt/area_split.hpp>
#include <rt/flat_tree.hpp>
#include <rt/wide_builder.hpp>
#include <study/timing.hpp>

#include "../scenes.hpp"
#include "../tree_checks.hpp"

using namespace checkpoint;

namespace {

struct All {
    rt::SphereTree sorted, by_area;
    rt::FlatTree flat;
    rt::WideTree wide_float;
    rt::WideTreeOf<rt::SceneSphere, Real> wide;

    explicit All(const Spheres& spheres)
        : sorted{rt::make_tree(spheres, rt::split_in_half)},
          by_area{rt::make_tree(spheres, rt::AreaSplit{})},
          flat{rt::make_flat(by_area)},
          wide_float{rt::make_wide_tree<float>(spheres)},
          wide{rt::make_wide_tree<Real>(spheres)} {}
};

void check_scene(const std::string& name, const Spheres& spheres, int rays) {
    const All all{spheres};
    rt::Rng rng{76, spheres.size()};
    long wrong = 0;
    std::string first;
    for (int i = 0; i < rays; ++i) {
        const Ray ray = any_ray(spheres, rng, i);
        const Interval within = i % 16 == 1 ? Interval{Real(0.25), 2} : Interval{};
        const Winner expected = linear(spheres, ray, within);
        const auto compare = [&](const char* structure, const Winner& found) {
            if (found.sphere == expected.sphere &&
                (expected.sphere < 0 || same_bits(found.t, expected.t)))
                return;
            if (wrong++ == 0)
                first = std::string(structure) + ", " + checkpoint::text(ray) + ": " + text(found) +
                        " instead of " + text(expected);
        };
        const auto of = [](const auto& s) { return Winner{s.nearest, s.within.max}; };
        compare("sorted tree", of(all.sorted.search(ray, within)));
        compare("tree by area", of(all.by_area.search(ray, within)));
        compare("flat in order", of(all.flat.search_in_order(ray, within)));
        compare("flat nearest first", of(all.flat.search_nearest_first(ray, within)));
        compare("8-wide in float", of(all.wide_float.search(ray, within)));
        compare("8-wide", of(all.wide.search(ray, within)));
    }
    INFO(name << ": " << wrong << " wrong, the first: " << first);
    CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("a million random rays find the same in every structure", "[given][rays]") {
    for (const int count : {0, 1, 2, 3, 10})
        check_scene(std::to_string(count) + " spheres", random_spheres(count), 100'000);
    for (const NamedScene& scene : hard_scenes()) check_scene(scene.name, scene.spheres, 75'000);
    check_scene("1000 spheres", random_spheres(1000), 45'000);
    check_scene("10000 spheres", random_spheres(10'000), 5'000);
}

TEST_CASE("at any scale", "[given][rays]") {
    // Powers of two, about 10^-15, 10^-9, 10^9 and 10^15: nothing is rounded differently.
    for (const int exponent : {-50, -30, 30, 50}) {
        const Real scale = std::ldexp(Real(1), exponent);
        Spheres spheres = random_spheres(300);
        for (SceneSphere& s : spheres) s.shape = {scale * s.shape.center, scale * s.shape.radius};
        check_scene("300 spheres, scaled", spheres, 20'000);
    }
}

TEST_CASE("rays along an axis as nearly as numbers can", "[given][rays]") {
    // Far from the origin, where origin / direction is larger than any number.
    rt::Rng rng{76, 5};
    Spheres spheres = random_spheres(300);
    const Real scale = std::ldexp(Real(1), 50);
    for (SceneSphere& s : spheres) s.shape = {scale * s.shape.center, scale * s.shape.radius};
    const All all{spheres};
    const auto tiny = [&] {
        const Real sign = rng() % 2 == 0 ? Real(1) : Real(-1);
        return rng() % 8 == 0 ? sign * 0
                              : sign * std::ldexp(Real(1), -static_cast<int>(rng() % 149));
    };
    long wrong = 0;
    for (int i = 0; i < 20'000; ++i) {
        const rt::Sphere& aim = spheres[rng() % spheres.size()].shape;
        const rt::Vec3 beside{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
        std::array<Real, 3> d{tiny(), tiny(), tiny()};
        d[rng() % 3] = rng() % 2 == 0 ? Real(1) : Real(-1);
        const rt::Vec3 direction{d[0], d[1], d[2]};
        const Ray ray{aim.center + aim.radius * beside - rng.uniform(0, 4) * scale * direction,
                      direction};
        const int expected = linear(spheres, ray, {}).sphere;
        wrong += all.wide_float.search(ray, {}).nearest != expected;
        wrong += all.wide.search(ray, {}).nearest != expected;
    }
    CHECK(wrong == 0);
}

TEST_CASE("a hit says which sphere of its structure it is", "[given]") {
    const Spheres spheres = random_spheres(100);
    const All all{spheres};
    const rt::SphereList list{spheres};
    rt::Rng rng{76, 6};
    int hits = 0;
    for (int i = 0; i < 500; ++i) {
        const Ray ray = any_ray(spheres, rng, i);
        const int expected = linear(spheres, ray, {}).sphere;
        const auto check = [&](const auto& world) {
            const std::optional<rt::Hit> hit = world.hit(ray, Interval{});
            REQUIRE((hit ? hit->shape : -1) == expected);
        };
        check(list);
        check(all.sorted);
        check(all.flat);
        check(all.wide_float);
        hits += expected > 0;
    }
    CHECK(hits > 100);
}

TEST_CASE("a ray along an axis visits as few boxes as its neighbors", "[given][rays]") {
    Spheres spheres = random_spheres(10'000);
    for (SceneSphere& s : spheres) s.shape.radius /= 20;
    const All all{spheres};
    const auto visits = [&](const rt::Vec3& direction) {
        rt::Rng places{76, 7};
        int visited = 0;
        const auto add = [&](const auto& found) { visited += found.box_tests + found.shape_tests; };
        for (int i = 0; i < 1000; ++i) {
            const rt::Vec3 at = spheres[places() % spheres.size()].shape.center;
            const Ray ray{at - 4 * direction, direction};
            add(all.wide_float.search(ray, {}));
            add(all.wide.search(ray, {}));
        }
        return visited;
    };
    const Real near_0 = real(1e-9);
    for (const rt::Vec3 axis : {rt::Vec3{1, 0, 0}, rt::Vec3{0, -1, 0}, rt::Vec3{0, 0, 1}}) {
        const rt::Vec3 beside = axis + near_0 * rt::Vec3{1, 1, 1};
        CHECK(visits(axis) < 1.1 * visits(beside));
    }
}

TEST_CASE("the search ends even for invalid rays, and for rays from very far away",
          "[given][rays]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN(), inf = rt::infinity;
    const Ray rays[] = {
        {{nan, 0, 0}, {0, 0, 1}}, {{nan, nan, nan}, {1, 1, 1}},
        {{inf, 0, 0}, {1, 0, 0}}, {{0, -inf, 0}, {0, 1, 0}},
        {{}, {nan, 0, 1}},        {{}, {inf, 0, 0}},
        {{}, {0, 0, 0}},          {{Real(3e38), 0, 0}, {-1, 0, 0}},
        {{}, {nan, nan, nan}},    {{std::numeric_limits<Real>::max(), 0, 0}, {1, 1, 0}}};
    for (const int count : {1, 10, 40, 5000}) {
        const Spheres spheres = random_spheres(count);
        const All all{spheres};
        for (const Ray& ray : rays) {
            const int expected = linear(spheres, ray, {}).sphere;
            INFO(count << " spheres, " << checkpoint::text(ray));
            CHECK(all.sorted.search(ray, {}).nearest == expected);
            CHECK(all.flat.search_in_order(ray, {}).nearest == expected);
            CHECK(all.flat.search_nearest_first(ray, {}).nearest == expected);
            CHECK(all.wide_float.search(ray, {}).nearest == expected);
            CHECK(all.wide.search(ray, {}).nearest == expected);
        }
    }
}

TEST_CASE("an 8-wide tree holds every sphere once and its boxes contain it", "[given][wide]") {
    auto scenes = hard_scenes();
    scenes.push_back({"5000 spheres", random_spheres(5000)});
    for (const NamedScene& scene : scenes) {
        const auto tree = rt::make_wide_tree<float>(scene.spheres);
        INFO(scene.name);
        std::vector<int> seen(scene.spheres.size(), 0);
        for (const auto& node : tree.nodes) {
            const auto &low = node.planes[0], &high = node.planes[1];
            for (std::size_t i = 0; i < rt::lanes; ++i) {
                if (!(low[0][i] <= high[0][i]) || !node.child[i].is_leaf()) continue;
                const rt::SphereLeaf& leaf =
                    tree.leaves[static_cast<std::size_t>(node.child[i].number())];
                for (std::size_t k = 0; k < rt::lanes; ++k) {
                    if (!leaf.is_used(k)) continue;
                    ++seen[static_cast<std::size_t>(leaf.number[k])];
                    const Box box = rt::bounds_of(leaf.sphere(k));
                    REQUIRE(static_cast<Real>(low[0][i]) <= box.low.x);
                    REQUIRE(static_cast<Real>(low[1][i]) <= box.low.y);
                    REQUIRE(static_cast<Real>(low[2][i]) <= box.low.z);
                    REQUIRE(static_cast<Real>(high[0][i]) >= box.high.x);
                    REQUIRE(static_cast<Real>(high[1][i]) >= box.high.y);
                    REQUIRE(static_cast<Real>(high[2][i]) >= box.high.z);
                }
            }
        }
        for (const int times : seen) REQUIRE(times == 1);
    }
}

namespace {

void add_inner(const rt::TreeNode& node, std::vector<const rt::TreeNode*>& inner) {
    if (node.is_leaf()) return;
    inner.push_back(&node);
    add_inner(*node.left, inner);
    add_inner(*node.right, inner);
}

// How many children a wide node has that replaces this one, if those in `wide` become wide nodes.
int children_if(const rt::TreeNode& node, const std::vector<const rt::TreeNode*>& wide) {
    int count = 0;
    for (const rt::TreeNode* child : {node.left.get(), node.right.get()})
        count += child->is_leaf() || std::find(wide.begin(), wide.end(), child) != wide.end()
                     ? 1
                     : children_if(*child, wide);
    return count;
}

// The smallest area of wide nodes of all ways to choose them: the root, and any others.
float least_area(const std::vector<const rt::TreeNode*>& inner) {
    float least = std::numeric_limits<float>::infinity();
    for (unsigned others = 0; others < 1u << (inner.size() - 1); ++others) {
        std::vector<const rt::TreeNode*> wide{inner[0]};
        for (std::size_t i = 1; i < inner.size(); ++i)
            if (others >> (i - 1) & 1) wide.push_back(inner[i]);
        float area = 0;
        bool fit = true;
        for (const rt::TreeNode* node : wide) {
            area += static_cast<float>(rt::surface_area(node->box));
            fit = fit && children_if(*node, wide) <= static_cast<int>(rt::lanes);
        }
        if (fit) least = std::min(least, area);
    }
    return least;
}

// The area of the wide nodes from this one on, and how many leaves they have.
float area_of(const rt::WideCut& cut, rt::WideCut::Numbered top, int& leaves) {
    auto area = static_cast<float>(rt::surface_area(top.node->box));
    const auto children = cut.children(top);
    REQUIRE(children.size() <= rt::lanes);
    for (const auto& child : children)
        if (child.node->is_leaf())
            ++leaves;
        else
            area += area_of(cut, child, leaves);
    return area;
}

}  // namespace

TEST_CASE("no other choice of wide nodes has a smaller area", "[given][wide]") {
    for (int count = 2; count <= 14; ++count)
        for (int round = 0; round < 10; ++round) {
            const Spheres spheres = random_spheres(count, round);
            // Trees of all shapes, down to leaves of one sphere.
            rt::Rng rng{79, static_cast<std::uint64_t>(round)};
            const rt::SphereTree tree =
                rt::make_tree(spheres, [&](std::span<int> order, std::span<const Box>) {
                    return order.size() < 2 ? 0 : 1 + static_cast<int>(rng() % (order.size() - 1));
                });
            std::vector<const rt::TreeNode*> inner;
            add_inner(*tree.root, inner);
            const auto leaves = inner.size() + 1;
            int found = 0;
            const float area = area_of({*tree.root, leaves}, {tree.root.get(), 0}, found);
            INFO(count << " spheres, tree " << round);
            CHECK(found == static_cast<int>(leaves));
            CHECK(area == Approx(inner.empty() ? area : least_area(inner)));
        }
}

TEST_CASE("a wide tree is searched as fast as if all its nodes were split exactly",
          "[given][wide]") {
    for (const int count : {50, 1000, 10'000}) {
        Spheres on_ground = random_spheres(count, 3);
        for (SceneSphere& s : on_ground) s.shape.center.y = s.shape.radius /= 3;
        add(on_ground, {0, -1000, 0}, 1000);
        for (const Spheres& spheres : {random_spheres(count, 2), on_ground}) {
            const auto exact = rt::make_wide_tree<float>(spheres, rt::AreaSplit{1});
            const auto tree = rt::make_wide_tree<float>(spheres);
            rt::Rng rng{78, 1};
            long exact_tests = 0, tests = 0;
            for (int i = 0; i < 3000; ++i) {
                const Ray ray{3 * any_direction(rng), in_cube(rng)};
                const auto count_tests = [&](const auto& any_tree) {
                    const auto found =
                        any_tree.search({ray.origin, ray.direction - ray.origin}, {});
                    return found.box_tests + found.shape_tests;
                };
                exact_tests += count_tests(exact);
                tests += count_tests(tree);
            }
            INFO(spheres.size() << " spheres: " << tests
                                << " tests, " EXPECTED "at most 1.04 times " << exact_tests);
            CHECK(static_cast<double>(tests) <= 1.04 * static_cast<double>(exact_tests));
        }
    }
}

TEST_CASE("a wide tree is built nearly as fast as by bins alone", "[given][wide]") {
    for (const int count : {10'000, 50'000}) {
        const Spheres spheres = random_spheres(count);
        const auto times = study::in_turns_ns(
            {[&] { study::keep(rt::make_wide_tree<float>(spheres, rt::binned_split)); },
             [&] { study::keep(rt::make_wide_tree<float>(spheres)); }});
        INFO(count << " spheres: " << times[1] / times[0] << " times as long as by bins");
        CHECK(times[1] <= 1.25 * times[0]);
    }
}

TEST_CASE("a million spheres", "[given][million]") {
    const Spheres spheres = random_spheres(1'000'000);
    const rt::SphereTree tree = rt::make_tree(spheres, rt::split_in_half);
    CHECK(levels_of(*tree.root) <= 19);
    const auto wide = rt::make_wide_tree<float>(spheres);
    const std::size_t bytes = wide.nodes.size() * sizeof(wide.nodes[0]) +
                              wide.leaves.size() * sizeof(wide.leaves[0]) +
                              wide.places.size() * sizeof(wide.places[0]);
    INFO(static_cast<double>(bytes) / 1e6 << " bytes per sphere, including all that a hit needs");
    CHECK(bytes <= 120'000'000);
    rt::Rng rng{77, 1};
    for (int i = 0; i < 3000; ++i) {
        const Ray ray = any_ray(spheres, rng, i);
        const rt::Search found = tree.search(ray, {});
        const auto wide_found = wide.search(ray, {});
        REQUIRE(found.nearest == wide_found.nearest);
        if (found.nearest >= 0) REQUIRE(same_bits(found.within.max, wide_found.within.max));
    }
}
