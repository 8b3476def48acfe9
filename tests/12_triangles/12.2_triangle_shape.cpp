#include <rt/area_split.hpp>
#include <rt/hit_triangle.hpp>
#include <rt/shape_tree.hpp>
#include <rt/triangle_shape.hpp>

#include "shapes.hpp"

using namespace checkpoint;
using rt::Box;
using rt::Interval;
using rt::SceneTriangle;

namespace {

std::string text_of(const Box& box) {
    return "the box from " + text(box.low) + " to " + text(box.high);
}

// Many triangles of a size that leaves gaps, all in a cube.
std::vector<SceneTriangle> crowd(rt::Rng& rng, int count, Real size) {
    std::vector<SceneTriangle> all;
    for (int i = 0; i < count; ++i)
        all.push_back({placed(plain_triangle(rng), size, in_cube(rng)), i % 3, i});
    return all;
}

std::optional<Real> met(const SceneTriangle& triangle, const Ray& ray, Interval within) {
    const auto hit = rt::hit_triangle(triangle.shape, ray, within);
    if (!hit) return {};
    return hit->t;
}

// The nearest by asking all of them: of equally near ones the last.
int nearest_of_all(const std::vector<SceneTriangle>& all, const Ray& ray, Interval within) {
    int nearest = -1;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (const auto t = met(all[i], ray, within)) {
            nearest = static_cast<int>(i);
            within.max = *t;
        }
    return nearest;
}

void check_tree(const std::vector<SceneTriangle>& all, const Ray& ray) {
    const auto tree = rt::make_tree(all, rt::AreaSplit{});
    const Interval within{0, rt::infinity};
    const int expected = nearest_of_all(all, ray, within);
    const int actual = tree.search(ray, within).nearest;
    if (actual != expected) {
        INFO(text(ray) << " among " << all.size() << " triangles: " EXPECTED "number " << expected
                       << ", " ACTUAL << actual << " (-1 is none)");
        INFO(
            "Hint: the tree is that of chapter 07. Check that each box contains its triangle, and "
            "that hit_shape passes the interval on");
        REQUIRE(actual == expected);
    }
    REQUIRE(tree.occluded(ray, within) == (expected >= 0));
}

}  // namespace

TEST_CASE("12.2 the box fits the triangle", "[12.2]") {
    const Box box = rt::bounds_of(SceneTriangle{{{1, -7, 3}, {-4, 5, 9}, {2, 6, -8}}});
    INFO("the triangle is (1, -7, 3), (-4, 5, 9), (2, 6, -8), and your result is " << text_of(box));
    INFO("Hint: find the smallest and the largest x, y and z of the three corners");
    const Real near = rt::hit_margin * 16;
    const auto check = [&](Vec3 actual, Vec3 expected) {
        INFO(EXPECTED << text(expected) << ", " ACTUAL << text(actual));
        CHECK(rt::max_component(actual - expected) <= near);
    };
    check(box.low, {-4, -7, -8});
    check(box.high, {2, 6, 9});
}

TEST_CASE("12.2 the box fits the corners in whatever order they come", "[12.2]") {
    rt::Rng rng{122, 1};
    for (int i = 0; i < 5000; ++i) {
        const Triangle shape = plain_triangle(rng);
        const Box box = rt::bounds_of(SceneTriangle{shape});
        const Vec3 low{std::min({shape.a.x, shape.b.x, shape.c.x}),
                       std::min({shape.a.y, shape.b.y, shape.c.y}),
                       std::min({shape.a.z, shape.b.z, shape.c.z})};
        const Vec3 high{std::max({shape.a.x, shape.b.x, shape.c.x}),
                        std::max({shape.a.y, shape.b.y, shape.c.y}),
                        std::max({shape.a.z, shape.b.z, shape.c.z})};
        const Real near = 2 * rt::hit_margin;
        const bool right =
            rt::max_component(box.low - low) <= near && rt::max_component(box.high - high) <= near;
        if (!right) {
            INFO(text(shape) << ": " EXPECTED << text_of({low, high}) << "\n" ACTUAL
                             << text_of(box));
            REQUIRE(right);
        }
    }
    SUCCEED();
}

TEST_CASE("12.2 a shape is hit where its triangle is hit", "[12.2]") {
    rt::Rng rng{122, 2};
    for (int i = 0; i < 5000; ++i) {
        const SceneTriangle triangle{plain_triangle(rng), 1, 2};
        // To its inside, or clearly past it.
        const Vec3 aim = i % 4 == 0 ? point_of(triangle.shape, real(0.7), real(0.7))
                                    : point_of(triangle.shape, real(0.3), real(0.5));
        const Vec3 from = aim + 2 * any_direction(rng);
        if (off_plane(triangle.shape, exact_vector(from)) < 0.1) continue;
        // Near or far, ahead or behind.
        const Real t = (i % 3 == 0 ? -1 : 1) * any_size(rng, -6, 6);
        const Ray ray{from, (aim - from) / t};
        const Interval line{-rt::infinity, rt::infinity};
        const Real before = t - std::abs(t) / 2, after = t + std::abs(t) / 2;
        for (const Interval within :
             {Interval{}, line, {before, after}, {after, line.max}, {line.min, before}}) {
            const auto expected = met(triangle, ray, within);
            const auto actual = rt::hit_shape(triangle, ray, within);
            const bool right =
                actual.has_value() == expected.has_value() &&
                (!actual || std::abs(*actual - *expected) <= 1000 * rt::epsilon * std::abs(t));
            if (right) continue;
            INFO(text(triangle.shape) << " and " << text(ray) << ", within " << text(within.min)
                                      << " to " << text(within.max));
            INFO(EXPECTED << (expected ? text(*expected) : "none") << ", " ACTUAL
                          << (actual ? text(*actual) : "none"));
            INFO(
                "Hint: return the t of hit_triangle, within the same interval. Every t in it "
                "counts, however small");
            REQUIRE(right);
        }
        const auto found = rt::hit_shape(triangle, ray, line);
        if (!found || rt::hit_shape(triangle, ray, {*found, *found})) continue;
        INFO(text(triangle.shape) << " and " << text(ray) << ": found at t = " << text(*found)
                                  << ", but not within [t, t]");
        INFO("Hint: both ends of the interval belong to it");
        REQUIRE(rt::hit_shape(triangle, ray, {*found, *found}));
    }
    SUCCEED();
}

TEST_CASE("12.2 the triangles of a mesh keep their order and get consecutive numbers", "[12.2]") {
    rt::Mesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{rt::Corner{0}, {1}, {2}},
                      {rt::Corner{3}, {2}, {1}},
                      {rt::Corner{3}, {2}, {1}},
                      {rt::Corner{2}, {2}, {0}},
                      {rt::Corner{1}, {3}, {2}}};
    const auto all = rt::triangles_of(mesh, 70'000, 16'777'216);
    INFO(
        "the mesh has five triangles over four points, of material 70000, numbered from 16777216 "
        "on. The third is like the second, and the fourth has no area.\nHint: keep every triangle, "
        "so that a number leads back to its triangle in the mesh. An index is an int; a smaller "
        "type, or a float, cuts it short");
    REQUIRE(all.size() == 5);
    CHECK(text(all[0].shape) == text(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    CHECK(text(all[1].shape) == text(Triangle{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
    CHECK(text(all[2].shape) == text(all[1].shape));
    CHECK(text(all[3].shape) == text(Triangle{{0, 1, 0}, {0, 1, 0}, {0, 0, 0}}));
    CHECK(text(all[4].shape) == text(Triangle{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}));
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(all[i].material == 70'000);
        CHECK(all[i].number == 16'777'216 + static_cast<int>(i));
    }
    CHECK(rt::triangles_of({}, 0, 0).empty());
}

TEST_CASE("12.2 a tree over triangles finds what a list finds", "[12.2]") {
    rt::Rng rng{122, 3};
    for (int i = 0; i < 300; ++i) {
        const auto all = crowd(rng, 1 + static_cast<int>(rng() % 60), real(0.3));
        for (int k = 0; k < 10; ++k) {
            const Vec3 from = 2 * in_cube(rng);
            check_tree(all, {from, in_cube(rng) - from});
        }
    }
}

TEST_CASE("12.2 of triangles that coincide the last one counts", "[12.2][hard]") {
    rt::Rng rng{122, 4};
    for (int i = 0; i < 300; ++i) {
        auto all = crowd(rng, 20, real(0.6));
        for (int k = 0; k < 20; ++k) {
            SceneTriangle again = all[rng() % 20];
            again.number = static_cast<int>(all.size());
            all.push_back(again);
        }
        const Triangle& some = all[rng() % 20].shape;
        const Vec3 from = 3 * in_cube(rng);
        check_tree(all, {from, point_of(some, real(0.3), real(0.3)) - from});
    }
}

TEST_CASE("12.2 the margin is as wide as in 07.2", "[12.2][hard]") {
    rt::Rng rng{122, 5};
    for (int i = 0; i < 5000; ++i) {
        const Real size = any_size(rng, -9, 9);
        SceneTriangle triangle{placed(plain_triangle(rng), size, size * 5 * in_cube(rng))};
        if (i % 3 == 0) triangle.shape.a.y = triangle.shape.b.y = triangle.shape.c.y;
        const auto& [a, b, c] = triangle.shape;
        const Real largest =
            std::max({rt::max_component(a), rt::max_component(b), rt::max_component(c)});
        const Box box = rt::bounds_of(triangle);
        const Real low = std::min({a.y, b.y, c.y}) - box.low.y,
                   high = box.high.y - std::max({a.y, b.y, c.y});
        const Real expected = rt::hit_margin * largest, rounding = 2 * rt::epsilon * largest;
        const bool right =
            std::abs(low - expected) <= rounding && std::abs(high - expected) <= rounding;
        if (!right) {
            INFO(text(triangle.shape) << ", your " << text_of(box));
            INFO("along y the margin is " << low << " below and " << high << " above; " EXPECTED
                                          << expected);
            INFO(
                "Hint: hit_margin * (the largest absolute coordinate of all corners), the same on "
                "all six sides");
            REQUIRE(right);
        }
    }
    SUCCEED();
}

TEST_CASE("12.2 a ray that hits the triangle meets its box", "[12.2][hard]") {
    rt::Rng rng{122, 6};
    for (int i = 0; i < 200'000; ++i) {
        const Real size = any_size(rng, -9, 9);
        Triangle shape =
            placed(plain_triangle(rng), size, size * any_size(rng, -2, 2) * in_cube(rng));
        // In a wall, whose box is flat, or as it is.
        if (i % 2 == 0) shape.a.z = shape.b.z = shape.c.z;
        Vec3 from = shape.a + size * any_size(rng, -2, 3) * in_cube(rng);
        if (i % 5 == 0) from = {};
        Vec3 aim = point_of(shape, rng.uniform(), 0);  // on an edge
        if (i % 3 == 0) aim = shape.c;
        const Ray ray{from, aim - from};
        const auto hit = rt::hit_triangle(shape, ray, {});
        if (!hit) continue;
        const Interval until{0, hit->t};
        const auto in_box =
            rt::hit_box(rt::bounds_of(SceneTriangle{shape}), rt::slab_ray(ray), until);
        if (in_box.min <= in_box.max) continue;
        INFO(text(ray) << " hits " << text(shape) << " at " << text(hit->t)
                       << ", but misses your box");
        INFO("Hint: grow the box by the margin");
        REQUIRE(in_box.min <= in_box.max);
    }
    SUCCEED();
}

TEST_CASE("12.2 a mesh may have many points", "[12.2]") {
    rt::Mesh mesh;
    mesh.points.resize(70'003);
    mesh.points[70'000] = {1, 2, 3}, mesh.points[70'001] = {4, 5, 6},
    mesh.points[70'002] = {7, 8, 0};
    mesh.triangles = {{rt::Corner{70'000}, {70'001}, {70'002}}};
    const auto all = rt::triangles_of(mesh, 3, 100'000);
    REQUIRE(all.size() == 1);
    CHECK(all[0].shape.a == Vec3{1, 2, 3});
    CHECK(all[0].shape.b == Vec3{4, 5, 6});
    CHECK(all[0].shape.c == Vec3{7, 8, 0});
    CHECK(all[0].number == 100'000);
}
