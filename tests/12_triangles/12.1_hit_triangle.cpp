#include <rt/hit_triangle.hpp>

#include "shapes.hpp"

using namespace checkpoint;
using rt::hit_triangle;
using rt::Interval;
using rt::TriangleHit;

namespace {

const Real no_number = std::numeric_limits<Real>::quiet_NaN();

std::string text_of(const std::optional<TriangleHit>& hit) {
    if (!hit) return "none";
    return "t " + text(hit->t) + ", u " + text(hit->u) + ", v " + text(hit->v);
}

// What is expected, up to a rounding error that even the plain formula has for such triangles.
void check_hit(const Triangle& triangle, const Ray& ray, Interval within,
               const TriangleHit& expected, const char* hint, Real epsilons = 1000) {
    const auto hit = hit_triangle(triangle, ray, within);
    const Real near = epsilons * rt::epsilon;
    const bool right = hit && std::abs(hit->t - expected.t) <= near * std::abs(expected.t) &&
                       std::abs(hit->u - expected.u) <= near &&
                       std::abs(hit->v - expected.v) <= near;
    if (!right) {
        INFO(text(triangle) << " and " << text(ray));
        INFO(EXPECTED << text_of(expected) << "\n" ACTUAL << text_of(hit));
        INFO("Hint: " << hint);
        REQUIRE(right);
    }
    REQUIRE(right);
}

void check_none(const Triangle& triangle, const Ray& ray, Interval within, const char* hint) {
    const auto hit = hit_triangle(triangle, ray, within);
    if (hit) {
        INFO(text(triangle) << " and " << text(ray) << "\n" EXPECTED "no hit, " ACTUAL
                            << text_of(hit));
        INFO("Hint: " << hint);
        REQUIRE(!hit);
    }
    REQUIRE(!hit);
}

// A triangle, and a ray to its point with these weights, which it meets steeply.
struct Aimed {
    Triangle triangle;
    Ray ray;
};
Aimed aimed(rt::Rng& rng, Real u, Real v, Real t) {
    for (;;) {
        const Triangle small = plain_triangle(rng);
        const Vec3 direction = any_direction(rng);
        const ExactVec3 normal = exact_unit(exact_normal(small));
        if (std::abs(dot(exact_vector(direction), normal).high) < 0.3) continue;
        const Real size = any_size(rng, -3, 3);
        const Triangle triangle = placed(small, size, size * in_cube(rng));
        const Vec3 way = size * rng.uniform(1, 3) * direction;
        return {triangle, {point_of(triangle, u, v) - way, way / t}};
    }
}

// How many triangles of a surface a ray meets at a t of 0 or more.
int count_hits(const std::vector<Triangle>& surface, const Ray& ray) {
    int count = 0;
    for (const Triangle& triangle : surface) count += hit_triangle(triangle, ray, {}).has_value();
    return count;
}

// Checks that rays to the corners and edges of a grid hit it once. Its corners are whole numbers,
// so that the areas are 0, and not nearly so.
template <class Corner>
void check_grid(const Corner& corner, Vec3 direction, rt::Rng& rng) {
    std::vector<Triangle> grid;
    for (int x = 0; x < 6; ++x)
        for (int z = 0; z < 6; ++z) {
            const Vec3 a = corner(x, z), b = corner(x + 1, z), c = corner(x + 1, z + 1),
                       d = corner(x, z + 1);
            const bool turned = rng() & 1, reversed = rng() & 1;
            const Triangle one = turned ? Triangle{a, b, c} : Triangle{a, b, d},
                           other = turned ? Triangle{a, c, d} : Triangle{d, b, c};
            grid.push_back(reversed ? Triangle{one.b, one.a, one.c} : one);
            grid.push_back(other);
        }
    // From six sides: the grid is turned, and the ray with it.
    const auto turned = [](Vec3 v, int side) {
        for (; side >= 2; side -= 2) v = {v.y, v.z, v.x};
        return v;
    };
    for (int side = 0; side < 6; ++side) {
        std::vector<Triangle> surface;
        for (const auto& [a, b, c] : grid)
            surface.push_back({turned(a, side), turned(b, side), turned(c, side)});
        for (int x = 1; x < 12; ++x)
            for (int z = 1; z < 12; ++z) {
                const Real way = side % 2 == 0 ? Real(9) : Real(-9);  // from above or below
                const Vec3 to{real(x) / 2, 0, real(z) / 2};
                const Ray ray{turned(to - way * direction, side),
                              turned(way / 9 * direction, side)};
                const int hits = count_hits(surface, ray);
                if (hits == 1) continue;
                INFO(text(ray) << ": " EXPECTED "one hit of the grid, " ACTUAL << hits);
                INFO(
                    "Hint: treat a ray through a corner as if it were moved a little, in the same "
                    "way for all triangles around it");
                REQUIRE(hits == 1);
            }
    }
    SUCCEED();
}

}  // namespace

TEST_CASE("12.1 the hit agrees with a small example on paper", "[12.1]") {
    const Triangle triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    check_hit(triangle, {{1, 2, 6}, {0, 0, -2}}, {}, {3, real(0.25), real(0.5)},
              "u is the weight of b, v is the weight of c, and the hit is at o + t d",
              16);  // most formulas round nothing here; with a normal of length 1, few times
}

TEST_CASE("12.1 a ray hits the triangle at the point that it was aimed at", "[12.1]") {
    rt::Rng rng{121, 1};
    for (int i = 0; i < 20'000; ++i) {
        // Near the edge at which the weight of c, of b or of a is 0, or farther inside.
        const Real in = any_size(rng, -3, 0), along = (1 - in) * rng.uniform(real(0.01), 1);
        const Real rest = 1 - in - along;
        if (rest < real(0.01)) continue;
        const Real u = i % 3 == 1 ? in : along, v = i % 3 == 0 ? in : rest;
        const Real t = any_size(rng, -2, 2);
        const auto [triangle, ray] = aimed(rng, u, v, t);
        check_hit(triangle, ray, {}, {t, u, v},
                  "solve o + t d = a + u (b - a) + v (c - a); a triangle has two sides, and both "
                  "count");
    }
}

TEST_CASE("12.1 a ray that passes beside an edge or a corner misses", "[12.1]") {
    rt::Rng rng{121, 2};
    for (int i = 0; i < 20'000; ++i) {
        const Real out = any_size(rng, -3, 0), along = rng.uniform(-1, 2);
        // Beyond the edge at which the weight of c, of b or of a is 0.
        const Real u[] = {along, -out, along}, v[] = {-out, along, 1 + out - along};
        const auto k = static_cast<std::size_t>(i % 3);
        const auto [triangle, ray] = aimed(rng, u[k], v[k], 1);
        check_none(triangle, ray, {},
                   k == 0   ? "v must not be less than 0"
                   : k == 1 ? "u must not be less than 0"
                            : "u + v must not be more than 1");
    }
}

TEST_CASE("12.1 only hits within the interval count", "[12.1]") {
    rt::Rng rng{121, 3};
    for (int i = 0; i < 5000; ++i) {
        const auto [triangle, ray] = aimed(rng, real(0.3), real(0.4), 2);
        check_none(triangle, ray, {0, real(1.9)}, "the triangle lies beyond the interval");
        check_none(triangle, ray, {real(2.1), 5}, "the triangle lies before the interval");
        check_hit(triangle, ray, {real(1.9), real(2.1)}, {2, real(0.3), real(0.4)},
                  "the interval limits t, not u and v");
        const Ray away{ray.origin, -ray.direction};
        check_none(triangle, away, {}, "t is less than 0: the triangle lies behind the ray");
        check_hit(triangle, away, {-5, 0}, {-2, real(0.3), real(0.4)},
                  "the interval decides, not whether t is greater than 0");
        const auto hit = hit_triangle(triangle, ray, {});
        if (!hit) continue;
        const auto again = hit_triangle(triangle, ray, {hit->t, hit->t});
        if (!again) {
            INFO(text(triangle) << " and " << text(ray) << ": found at t = " << text(hit->t)
                                << ", but not within [t, t]");
            INFO("Hint: both ends of the interval belong to it");
            REQUIRE(again);
        }
    }
}

TEST_CASE("12.1 a ray parallel to the triangle misses", "[12.1]") {
    const Triangle floor{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}};
    const char* const hint = "the determinant is 0: do not divide by it";
    check_none(floor, {{-5, 1, 0}, {1, 0, 0}}, {}, hint);
    check_none(floor, {{-5, -1, 0}, {1, 0, 0}}, {}, hint);
    check_none(floor, {{-5, 0, 0}, {1, 0, 0}}, {}, hint);
    check_none(floor, {{0, 0, 0}, {0, 0, 1}}, {-1, 1}, hint);
    check_hit(floor, {{-5, real(0.03125), 0}, {5, real(-0.03125), 0}}, {},
              {1, real(0.25), real(0.5)}, "a ray that comes in low hits, as it is not parallel");
}

TEST_CASE("12.1 a ray through a shared edge hits exactly one of the two triangles",
          "[12.1][hard]") {
    rt::Rng rng{121, 4};
    for (int i = 0; i < 200'000; ++i) {
        // A quadrilateral, seen from far enough that both halves face the ray or its back.
        const Vec3 a{-1, real(0.3) * rng.uniform(), 0}, b{1, real(0.3) * rng.uniform(), 0};
        const Vec3 c{rng.uniform(-1, 1), real(0.1), -1}, d{rng.uniform(-1, 1), real(0.1), 1};
        const Real size = any_size(rng, -4, 4);
        const Vec3 by = i % 2 == 0 ? Vec3{} : size * in_cube(rng);
        const bool turned = rng() & 1;
        const Triangle one = placed(turned ? Triangle{a, c, b} : Triangle{b, c, a}, size, by),
                       other = placed({a, b, d}, size, by);
        const Vec3 aim = by + size * (a + rng.uniform(real(0.1), real(0.9)) * (b - a));
        const Vec3 from = aim + size * Vec3{rng.uniform(-1, 1), 4, rng.uniform(-1, 1)};
        const Ray ray{from, aim - from};
        const int hits = count_hits({one, other}, ray);
        if (hits != 1) {
            INFO(text(one) << "\n" << text(other) << "\n" << text(ray));
            INFO(EXPECTED "one hit, " ACTUAL << hits);
            INFO("Hint: " << (hits == 0
                                  ? "the ray slips through the edge: decide by the sign of an area "
                                    "that both triangles compute from the same two points"
                                  : "both triangles are hit: if an area is 0, the edge's direction "
                                    "must decide"));
            REQUIRE(hits == 1);
        }
    }
    SUCCEED();
}

TEST_CASE("12.1 rays from straight above hit a grid once at corners and edges", "[12.1][hard]") {
    rt::Rng rng{121, 5};
    const auto corner = [&](int x, int z) {
        return Vec3{static_cast<Real>(x), static_cast<Real>((x * 7 + z * 5) % 3),
                    static_cast<Real>(z)};
    };
    check_grid(corner, {0, -1, 0}, rng);
}

TEST_CASE("12.1 rays hit a grid in one level plane once at corners and edges", "[12.1][hard]") {
    rt::Rng rng{121, 12};
    const auto corner = [&](int x, int z) {
        return Vec3{static_cast<Real>(x), 0, static_cast<Real>(z)};
    };
    for (const Vec3 direction : {Vec3{0, -1, 0}, Vec3{real(0.25), -1, real(-0.5)},
                                 Vec3{real(-0.5), -1, 0}, Vec3{0, -1, real(0.75)}})
        check_grid(corner, direction, rng);
}

TEST_CASE("12.1 a ray from inside a closed surface without dents hits it once", "[12.1][hard]") {
    rt::Rng rng{121, 6};
    const rt::Mesh mesh = ball(2);
    const std::vector<Triangle> surface = shapes_of(mesh);
    for (int i = 0; i < 30'000; ++i) {
        const Vec3 from = real(0.4) * in_cube(rng);
        const auto point = [&] { return mesh.points[rng() % mesh.points.size()]; };
        const auto& [a, b, c] = surface[rng() % surface.size()];
        Vec3 aim = point();  // a corner, an edge, or anything
        if (i % 3 == 1) aim = a + rng.uniform() * (b - a);
        if (i % 3 == 2) aim = any_direction(rng);
        const Ray ray{from, aim - from};
        const int hits = count_hits(surface, ray);
        if (hits == 1) continue;
        INFO(text(ray) << " starts inside a closed surface without dents: " EXPECTED
                          "one hit, " ACTUAL
                       << hits);
        INFO("Hint: all triangles around a corner must compute the same position for it");
        REQUIRE(hits == 1);
    }
    SUCCEED();
}

TEST_CASE("12.1 a ray enters a closed surface as often as it leaves it", "[12.1][hard]") {
    rt::Rng rng{121, 7};
    const rt::Mesh mesh = ball(2, &rng);
    const std::vector<Triangle> surface = shapes_of(mesh);
    for (int i = 0; i < 30'000; ++i) {
        const Vec3 from = 3 * any_direction(rng);
        const Ray ray{from, mesh.points[rng() % mesh.points.size()] - from};
        const int hits = count_hits(surface, ray);
        if (hits % 2 == 0) continue;
        INFO(text(ray) << " starts outside a closed surface and goes toward a corner: " EXPECTED
                          "an even number of hits, " ACTUAL
                       << hits);
        REQUIRE(hits % 2 == 0);
    }
    SUCCEED();
}

TEST_CASE("12.1 the order of the corners does not change the decision", "[12.1][hard]") {
    rt::Rng rng{121, 8};
    for (int i = 0; i < 50'000; ++i) {
        const auto& [a, b, c] = plain_triangle(rng);
        const Vec3 from = 2 * in_cube(rng);
        const Vec3 aim = i % 2 == 0 ? a + rng.uniform() * (b - a) : in_cube(rng);
        const Ray ray{from, aim - from};
        const bool first = hit_triangle({a, b, c}, ray, {}).has_value();
        for (const Triangle& other : {Triangle{b, c, a}, Triangle{c, a, b}, Triangle{b, a, c},
                                      Triangle{c, b, a}, Triangle{a, c, b}})
            if (hit_triangle(other, ray, {}).has_value() != first) {
                INFO(text(other) << " and " << text(ray)
                                 << ": the decision must be the same as for "
                                 << text(Triangle{a, b, c}));
                REQUIRE(hit_triangle(other, ray, {}).has_value() == first);
            }
    }
    SUCCEED();
}

TEST_CASE("12.1 the point at t lies on the triangle's plane", "[12.1][hard]") {
    rt::Rng rng{121, 9};
    double worst = 0;
    for (int i = 0; i < 300'000; ++i) {
        // Needles, too: up to 10^5 times as long as wide (10^2 in float).
        const Real thin = any_size(rng, for_this_precision(-2, -5), 0);
        Triangle triangle = plain_triangle(rng);
        const Vec3 end = i % 2 == 0 ? triangle.a : triangle.b;
        triangle.c = end + thin * (triangle.c - end);
        const Real size = any_size(rng, -9, 9);
        triangle = placed(triangle, size, size * any_size(rng, -2, 2) * in_cube(rng));
        Real u = rng.uniform(), v = rng.uniform();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const Vec3 from = triangle.a + size * any_size(rng, -3, 3) * in_cube(rng);
        const Ray ray{from, any_size(rng, -3, 3) / size * (point_of(triangle, u, v) - from)};
        const auto hit = hit_triangle(triangle, ray, {});
        if (!hit) continue;
        const ExactVec3 at = exact_vector(from) + Exact(hit->t) * exact_vector(ray.direction);
        const double allowed =
            16 * static_cast<double>(rt::epsilon) * static_cast<double>(reach_from(from, triangle));
        const double off_over_allowed = off_plane(triangle, at) / allowed;
        worst = std::max(worst, off_over_allowed);
        if (off_over_allowed <= 1) continue;
        INFO(text(triangle) << " and " << text(ray) << ", t = " << text(hit->t));
        INFO("the ray's point at t is off the plane by " << off_over_allowed * allowed
                                                         << "; the limit is " << allowed);
        INFO(
            "Hint: areas that nearly cancel need difference_of_products of 01.3; t is the mean of "
            "the corners' t, weighted by the areas");
        REQUIRE(off_over_allowed <= 1);
    }
    CHECK(worst <= 1);
}

TEST_CASE("12.1 the weights are right far from the scene's origin", "[12.1][hard]") {
    rt::Rng rng{121, 10};
    for (int i = 0; i < 50'000; ++i) {
        const Triangle small = plain_triangle(rng);
        const Vec3 by = for_this_precision<Real>(1000, 1e6) * in_cube(rng);
        const Triangle triangle = placed(small, 1, by);
        const ExactVec3 normal = exact_unit(exact_normal(triangle));
        const Vec3 way = 2 * any_direction(rng);
        if (std::abs(dot(exact_vector(way), normal).high) < 1) continue;
        const Ray ray{point_of(triangle, real(0.3), real(0.3)) - way, way};
        const auto hit = hit_triangle(triangle, ray, {});
        const ExactVec3 a = exact_vector(triangle.a), ab = exact_vector(triangle.b) - a,
                        ac = exact_vector(triangle.c) - a, d = exact_vector(way),
                        s = exact_vector(ray.origin) - a;
        const Exact det = dot(ab, cross(d, ac));
        const double u = (dot(s, cross(d, ac)) / det).high, v = (dot(d, cross(s, ab)) / det).high;
        const double near = 200 * static_cast<double>(rt::epsilon);
        const bool right = hit && std::abs(static_cast<double>(hit->u) - u) <= near &&
                           std::abs(static_cast<double>(hit->v) - v) <= near;
        if (!right) {
            INFO(text(triangle) << " and " << text(ray));
            INFO(EXPECTED "u " << u << ", v " << v << "\n" ACTUAL << text_of(hit));
            INFO(
                "Hint: subtract the ray's origin from the corners first; the differences are "
                "small and exact, or nearly so");
            REQUIRE(right);
        }
    }
    SUCCEED();
}

TEST_CASE("12.1 a triangle is hit however thin it is", "[12.1][hard]") {
    for (int power = 1; power < for_this_precision(25, 200); ++power) {
        const Real thin = std::pow(Real(10), static_cast<Real>(-power));
        check_hit({{-1, 0, 0}, {1, 0, 0}, {0, thin, 0}}, {{0, thin / 4, 6}, {0, 0, -2}}, {},
                  {3, real(0.375), real(0.25)},
                  "only a triangle without area is never hit; a ray between the two neighbors of "
                  "a thin triangle would slip through");
    }
}

TEST_CASE("12.1 a triangle without area is never hit", "[12.1][hard]") {
    rt::Rng rng{121, 11};
    for (int i = 0; i < 300'000; ++i) {
        // Three points on a line, at whole numbers; sometimes two or all three coincide.
        const auto whole = [&] { return static_cast<Real>(static_cast<int>(rng() % 9) - 4); };
        const Vec3 a{whole(), whole(), whole()}, step{whole(), whole(), whole()};
        const Triangle flat{a + whole() * step, a + whole() * step, a + whole() * step};
        const Vec3 aim = flat.a + rng.uniform() * (flat.b - flat.a);
        const Vec3 from = i % 2 == 0 ? 9 * in_cube(rng) : Vec3{whole(), whole(), whole()};
        check_none(
            flat, {from, aim - from}, {},
            "the corners lie on a line, or coincide: the triangle has no area, so no ray hits it");
    }
}

TEST_CASE("12.1 a ray or a triangle that contains NaN gives no hit", "[12.1][hard]") {
    const Triangle triangle{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}};
    const char* const hint = "a comparison with NaN is false: make false mean a miss";
    check_none(triangle, {{0, 0, 0}, {0, 0, 0}}, {},
               "a ray with a direction of length 0 hits nothing");
    for (int i = 0; i < 3; ++i) {
        Vec3 bad{0, 0, real(0.5)};
        (i == 0 ? bad.x : i == 1 ? bad.y : bad.z) = no_number;
        check_none(triangle, {{0, 0, 0}, bad}, {}, hint);
        check_none(triangle, {bad, {0, 0, 1}}, {}, hint);
        check_none({triangle.a, triangle.b, bad}, {{0, 0, 0}, {0, 0, 1}}, {}, hint);
        check_none({bad, triangle.b, triangle.c}, {{0, 0, 0}, {0, 0, 1}}, {}, hint);
    }
}

TEST_CASE("12.1 a scene 2^30 times larger or smaller is hit at the same t", "[12.1][hard]") {
    rt::Rng rng{121, 12};
    for (int i = 0; i < 20'000; ++i) {
        const auto [triangle, ray] = aimed(rng, real(0.3), rng.uniform(), 1);
        const auto hit = hit_triangle(triangle, ray, {});
        for (const int power : {-30, 30}) {
            const Real s = std::scalbn(Real(1), power);
            const auto scaled =
                hit_triangle(placed(triangle, s, {}), {s * ray.origin, s * ray.direction}, {});
            if (text_of(scaled) == text_of(hit)) continue;
            INFO(text(triangle) << " and " << text(ray) << ", all scaled by 2^" << power);
            INFO(
                "Hint: your code must not compare with a fixed number that does not come from the "
                "triangle and the ray");
            REQUIRE(text_of(scaled) == text_of(hit));
        }
    }
    SUCCEED();
}
