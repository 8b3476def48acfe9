#include <rt/make_teapot.hpp>
#include <rt/mesh_world.hpp>

#include "../shapes.hpp"

using namespace checkpoint;
using rt::Interval;
using rt::SceneTriangle;

namespace {

struct Nearest {
    int number = -1;
    Real t = 0;
};
Nearest of_list(const std::vector<SceneTriangle>& all, const Ray& ray, Interval within) {
    Nearest nearest;
    for (const SceneTriangle& triangle : all)
        if (const auto hit = rt::hit_triangle(triangle.shape, ray, within)) {
            nearest = {triangle.number, hit->t};
            within.max = hit->t;
        }
    return nearest;
}

// Triangles in a cube, many of them odd.
std::vector<SceneTriangle> odd_triangles(int count, Real size, rt::Rng& rng) {
    std::vector<SceneTriangle> all;
    for (int i = 0; i < count; ++i) {
        Triangle shape = placed(plain_triangle(rng), Real(0.4) * size, size * in_cube(rng));
        if (i % 4 == 0) shape.c = shape.a + Real(1e-3) * (shape.c - shape.a);  // a needle
        if (i % 5 == 0) shape.a.y = shape.b.y = shape.c.y;                     // a flat box
        if (i % 7 == 0 && i > 0) shape = all[rng() % all.size()].shape;        // coplanar
        if (i % 11 == 0) shape.c = shape.b;                                    // no area
        all.push_back({shape, i % 3, i});
    }
    return all;
}
Ray ray_to_one_of(const std::vector<SceneTriangle>& all, int i, Real size, rt::Rng& rng) {
    const Triangle& at = all[rng() % all.size()].shape;
    const Vec3 from = i % 3 == 0 ? at.a : 2 * size * in_cube(rng);
    const Vec3 aim = i % 2 == 0 ? at.b : point_of(at, Real(0.3), Real(0.3));
    return {from, aim == from ? Vec3{1, 0, 0} : aim - from};
}

void check_tree(const std::vector<SceneTriangle>& all, const std::vector<Ray>& rays) {
    const rt::TriangleTree tree = rt::make_wide_tree(all);
    for (const Ray& ray : rays) {
        const Interval within{0, rt::infinity};
        const Nearest expected = of_list(all, ray, within);
        const auto found = tree.search(ray, within);
        const bool same = found.nearest == expected.number &&
                          (expected.number < 0 || found.within.max == expected.t);
        if (!same || tree.occluded(ray, within) != (expected.number >= 0)) {
            INFO(text(ray) << ": a list finds " << expected.number << " at " << text(expected.t)
                           << ", the wide tree " << found.nearest << " at "
                           << text(found.within.max));
            REQUIRE(same);
            REQUIRE(tree.occluded(ray, within) == (expected.number >= 0));
        }
    }
    SUCCEED();
}

}  // namespace

TEST_CASE("the wide tree of triangles finds what a list finds to the last bit") {
    rt::Rng rng{12, 20};
    for (int round = 0; round < 60; ++round) {
        const Real size = any_size(rng, -9, 9);
        const std::vector<SceneTriangle> all = odd_triangles(200, size, rng);
        std::vector<Ray> rays;
        for (int i = 0; i < 300; ++i) rays.push_back(ray_to_one_of(all, i, size, rng));
        check_tree(all, rays);
    }
}

TEST_CASE("a leaf keeps a triangle that is hit at an end of the interval") {
    rt::Rng rng{12, 21};
    int kept = 0, beyond = 0, left_out = 0;
    for (int round = 0; round < 40'000; ++round) {
        const Real size = any_size(rng, -12, 12);
        const std::vector<SceneTriangle> all = odd_triangles(rt::lanes, size, rng);
        rt::TriangleLeaf leaf;
        for (const SceneTriangle& one : all)
            leaf.set(static_cast<std::size_t>(one.number), one, one.number);
        const rt::TriangleRay ray{ray_to_one_of(all, round, size, rng)};
        for (const SceneTriangle& one : all) {
            const auto hit = rt::hit_triangle(one.shape, ray, {-rt::infinity, rt::infinity});
            if (!hit) continue;
            const Real t = hit->t;
            const auto may_meet = [&](Interval within) {
                return (rt::may_meet(leaf, ray, within) >> one.number & 1) != 0;
            };
            for (const Interval& within :
                 {Interval{t, t}, {t, rt::infinity}, {-rt::infinity, t}, {t, 2 * std::abs(t)}}) {
                INFO(text(one.shape) << ", " << text(ray) << ": hit at " << text(t));
                REQUIRE(may_meet(within));
                ++kept;
            }
            if (t == 0) continue;
            ++beyond;
            left_out += !may_meet({t + std::abs(t) / 16, rt::infinity}) &&
                        !may_meet({-rt::infinity, t - std::abs(t) / 16});
        }
    }
    CHECK(kept > 80'000);
    INFO(left_out << " of " << beyond << " hits beyond the interval are left out");
    CHECK(left_out > beyond * 0.9);
}

TEST_CASE("several threads build the tree that one thread builds") {
    const auto all = rt::triangles_of(rt::make_teapot(40), 0, 0);
    REQUIRE(all.size() > 80'000);
    const rt::TriangleTree one = rt::make_wide_tree(all);
    for (const int threads : {2, 3, 16}) {
        const rt::TriangleTree more = rt::make_wide_tree(all, threads);
        CHECK(more.places == one.places);
        REQUIRE(more.nodes.size() == one.nodes.size());
        for (std::size_t i = 0; i < one.nodes.size(); ++i) {
            REQUIRE(more.nodes[i].planes == one.nodes[i].planes);
            REQUIRE(more.nodes[i].child == one.nodes[i].child);
        }
    }
}

TEST_CASE("the teapot's triangles have areas and normals and its points are shared") {
    const rt::Mesh teapot = rt::make_teapot(6);
    CHECK(teapot.triangles.size() > 2000);
    CHECK(teapot.points.size() < teapot.triangles.size());
    Vec3 low{9, 9, 9}, high{-9, -9, -9};
    for (const Vec3& p : teapot.points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    CHECK(low.y == 0);
    CHECK(std::abs(high.y - real(3.15)) < real(1e-5));
    CHECK(std::abs(high.x - real(3.434)) < real(0.01));
    CHECK(std::abs(low.x + 3) < real(0.01));
    const std::vector<Triangle> shapes = shapes_of(teapot);
    int outward = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        REQUIRE(exact_length(exact_normal(shapes[i])).high > 0);
        // The sides of the body: the normal leads away from the axis.
        const Vec3 middle = point_of(shapes[i], Real(0.33), Real(0.33));
        if (middle.y > Real(0.5) && middle.y < 2 && std::abs(middle.x) < 2) {
            const ExactVec3 n = exact_normal(shapes[i]);
            outward += (n.x * Exact(middle.x) + n.z * Exact(middle.z)).high > 0 ? 1 : -1;
        }
    }
    CHECK(outward > 300);
}
