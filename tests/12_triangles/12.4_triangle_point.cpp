#include <rt/hit_triangle.hpp>
#include <rt/leave_surface.hpp>
#include <rt/triangle_number.hpp>
#include <rt/triangle_point.hpp>

#include "shapes.hpp"

using namespace checkpoint;
using rt::Hit;
using rt::SceneTriangle;

namespace {

double exact_dot(Vec3 a, Vec3 b) {
    return dot(exact_vector(a), exact_vector(b)).high;
}

struct Place {
    SceneTriangle triangle;
    Ray ray;
    Hit hit;
};

// A point of a triangle as a ray meets it. The triangle is of size 10^-9 to 10^9, up to 10^3 times
// its size from the origin (10^5 in double), and thin in one case of two.
Place any_place(rt::Rng& rng) {
    for (;;) {
        const Real thin = rng() % 2 == 0 ? 1 : any_size(rng, for_this_precision(-2, -5), 0);
        Triangle shape = plain_triangle(rng);
        // Any two of its corners may be close together.
        const auto tips = rng() % 8;
        Vec3& tip = tips % 2 == 0 ? shape.b : shape.c;
        const Vec3 near = tips == 7 ? shape.b : shape.a;
        tip = near + thin * (tip - near);
        const Real size = any_size(rng, -9, 9);
        shape =
            placed(shape, size, size * any_size(rng, -2, for_this_precision(2, 5)) * in_cube(rng));
        Real u = rng.uniform(), v = rng.uniform();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const Vec3 from = shape.a + size * any_size(rng, 0, 3) * in_cube(rng);
        const SceneTriangle triangle{shape, 4, 17};
        const Ray ray{from, (point_of(shape, u, v) - from) / size};
        const auto met = rt::hit_triangle(shape, ray, {});
        if (met) return {triangle, ray, rt::surface_hit(triangle, ray, met->t)};
    }
}

// A direction on the side of the normal: any, or one that all but grazes the triangle.
Vec3 leaving(Vec3 normal, rt::Rng& rng) {
    for (;;) {
        Vec3 d = any_direction(rng);
        if (rng() & 1)
            d += (any_size(rng, -6, 0) - static_cast<Real>(exact_dot(d, normal))) * normal;
        if (exact_dot(d, normal) < 0) d = -d;
        if (exact_dot(d, normal) > 4 * static_cast<double>(rt::epsilon)) return d;
    }
}

std::string describe(const Place& place) {
    return text(place.triangle.shape) + " and " + text(place.ray) + ", met at " +
           text(place.hit.point) + " with normal " + text(place.hit.normal) + " and point_error " +
           text(place.hit.point_error);
}

}  // namespace

TEST_CASE("12.4 the point agrees with a small example on paper", "[12.4]") {
    const SceneTriangle triangle{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, 70'000, 16'777'217};
    const Ray ray{{1, 2, 6}, {0, 0, -2}};
    const auto met = rt::hit_triangle(triangle.shape, ray, {});
    REQUIRE(met);
    const Hit hit = rt::surface_hit(triangle, ray, met->t);
    {
        HINT((Vec3{1, 2, 0}), hit.point, "the point is a + u (b - a) + v (c - a)");
        CHECK(rt::max_component(hit.point - Vec3{1, 2, 0}) <= 16 * rt::epsilon);
    }
    {
        HINT((Vec3{0, 0, 1}), hit.normal,
             "seen from the side of the normal, a, b and c go around counterclockwise: normalize "
             "(b - a) x (c - a)");
        CHECK(rt::max_component(hit.normal - Vec3{0, 0, 1}) <= 8 * rt::epsilon);
    }
    CHECK(hit.t == met->t);
    CHECK(hit.front);
    INFO("Hint: copy the whole index, an int; a smaller type, or a float, cuts it short");
    CHECK(hit.material == 70'000);
    INFO("Hint: light is kept_as_light(number)");
    CHECK(hit.light == rt::kept_as_light(16'777'217));
}

TEST_CASE("12.4 point and normal are correct for any triangle from either side", "[12.4]") {
    rt::Rng rng{124, 1};
    for (int i = 0; i < 20'000; ++i) {
        const SceneTriangle triangle{placed(plain_triangle(rng), 1, in_cube(rng)), 2, 5};
        Real u = rng.uniform(), v = rng.uniform();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const Vec3 aim = point_of(triangle.shape, u, v);
        const Vec3 from = aim + 2 * any_direction(rng);
        const ExactVec3 normal = exact_unit(exact_normal(triangle.shape));
        const double cosine = dot(exact_vector(from - aim), normal).high / 2;
        if (std::abs(cosine) < 0.1) continue;
        const Ray ray{from, aim - from};
        const auto met = rt::hit_triangle(triangle.shape, ray, {});
        if (!met) continue;
        const Hit hit = rt::surface_hit(triangle, ray, met->t);
        const Real near = 100 * rt::epsilon;
        const Vec3 expected{static_cast<Real>(normal.x.high), static_cast<Real>(normal.y.high),
                            static_cast<Real>(normal.z.high)};
        const bool right = rt::max_component(hit.point - aim) <= near &&
                           rt::max_component(hit.normal - expected) <= near &&
                           hit.front == (cosine > 0) && hit.t == met->t;
        if (!right) {
            INFO(text(triangle.shape) << " and " << text(ray));
            INFO("expected: the point " << text(aim) << ", the normal " << text(expected)
                                        << ", front " << (cosine > 0) << ", t " << text(met->t));
            INFO("actual: the point " << text(hit.point) << ", the normal " << text(hit.normal)
                                      << ", front " << hit.front << ", t " << text(hit.t));
            INFO("Hint: the normal does not depend on which side was hit; front says which side");
            REQUIRE(right);
        }
    }
    SUCCEED();
}

TEST_CASE("12.4 a ray that leaves an ordinary triangle does not meet it again", "[12.4]") {
    rt::Rng rng{124, 2};
    for (int i = 0; i < 50'000; ++i) {
        SceneTriangle triangle{placed(plain_triangle(rng), 3, 2 * in_cube(rng))};
        const Real u = real(0.3) * rng.uniform();
        // In some scenes, the point or the ray's origin is at (0, 0, 0).
        if (i % 3 == 1)
            triangle.shape = placed(triangle.shape, 1, -point_of(triangle.shape, u, real(0.6)));
        const Vec3 aim = point_of(triangle.shape, u, real(0.6));
        const Vec3 from = i % 3 == 2 ? Vec3{} : aim + 4 * any_direction(rng);
        const Ray ray{from, (aim - from) / any_size(rng, -3, 3)};
        const auto met = rt::hit_triangle(triangle.shape, ray, {});
        if (!met) continue;
        const Hit hit = rt::surface_hit(triangle, ray, met->t);
        Vec3 out = any_direction(rng);
        if (std::abs(exact_dot(out, hit.normal)) < 0.1) continue;
        const Ray left{rt::leave_surface(hit, out), out};
        if (const auto again = rt::hit_triangle(triangle.shape, left, {})) {
            INFO(text(triangle.shape)
                 << ": a ray that leaves it from " << text(hit.point) << " along " << text(out)
                 << " meets it again at t = " << text(again->t));
            INFO("point_error is " << text(hit.point_error)
                                   << ".\nHint: point_error must not be 0, but a few times epsilon "
                                      "times the numbers that are rounded");
            REQUIRE(!again);
        }
        if (!(hit.point_error < real(1e-3))) {
            INFO("point_error is "
                 << text(hit.point_error)
                 << ".\nHint: point_error bounds rounding errors; a fixed 0.001 is far too large");
            REQUIRE(hit.point_error < real(1e-3));
        }
    }
    SUCCEED();
}

TEST_CASE("12.4 the point is off the plane by no more than its point_error", "[12.4][hard]") {
    rt::Rng rng{124, 3};
    for (int i = 0; i < 200'000; ++i) {
        const Place place = any_place(rng);
        const double off = off_plane(place.triangle.shape, exact_vector(place.hit.point));
        if (off <= static_cast<double>(place.hit.point_error)) continue;
        INFO(describe(place));
        INFO("the point is off the plane by "
             << off
             << ".\nHint: origin + t * direction has a larger error than the mean of the corners, "
                "and it grows with the distance");
        REQUIRE(off <= static_cast<double>(place.hit.point_error));
    }
    SUCCEED();
}

TEST_CASE("12.4 a million rays never meet the triangle that they leave", "[12.4][hard]") {
    rt::Rng rng{124, 4};
    for (int i = 0; i < 1'000'000; ++i) {
        const Place place = any_place(rng);
        const Vec3 out = (rng() & 1 ? Real(1) : Real(-1)) * leaving(place.hit.normal, rng);
        const Ray left{rt::leave_surface(place.hit, out), out};
        const auto again = rt::hit_triangle(place.triangle.shape, left, {});
        if (!again) continue;
        INFO(describe(place) << ": a ray that leaves it from " << text(left.origin) << " along "
                             << text(out));
        INFO("the ray meets the triangle again at t = "
             << text(again->t)
             << ".\nHint: when the ray leaves, hit_triangle rounds in "
                "proportion to the triangle's size");
        REQUIRE(!again);
    }
    SUCCEED();
}

TEST_CASE("12.4 the point_error is no larger than necessary", "[12.4][hard]") {
    rt::Rng rng{124, 5};
    for (int i = 0; i < 200'000; ++i) {
        const Place place = any_place(rng);
        const auto& [a, b, c] = place.triangle.shape;
        const Real largest = rt::max_component(place.hit.point) +
                             std::max(rt::max_component(b - a), rt::max_component(c - a));
        const Real allowed = 40 * rt::epsilon * largest;
        if (place.hit.point_error <= allowed) continue;
        INFO(describe(place));
        INFO("the limit is " << text(allowed)
                             << ".\nHint: a long, thin triangle needs no larger error than other "
                                "triangles; a ray that "
                                "starts too far away may start beyond another surface");
        REQUIRE(place.hit.point_error <= allowed);
    }
    SUCCEED();
}

TEST_CASE("12.4 rays meet a wall that is ten error bounds away", "[12.4][hard]") {
    rt::Rng rng{124, 6};
    for (int i = 0; i < 300'000; ++i) {
        const Place place = any_place(rng);
        const Hit& hit = place.hit;
        const auto& [a, b, c] = place.triangle.shape;
        if (exact_length(exact_normal(place.triangle.shape)).high <
            0.01 * static_cast<double>(rt::max_component(b - a) * rt::max_component(c - a)))
            continue;  // the direction of its normal has too few digits
        // A large triangle that faces this one.
        const Vec3 there = hit.point + 10 * hit.point_error * hit.normal;
        const Real big = 3 * std::max(rt::max_component(b - a), rt::max_component(c - a));
        const Vec3 side = (b - a) / static_cast<Real>(exact_length(exact_vector(b - a)).high);
        const Vec3 other{hit.normal.y * side.z - hit.normal.z * side.y,
                         hit.normal.z * side.x - hit.normal.x * side.z,
                         hit.normal.x * side.y - hit.normal.y * side.x};
        const Triangle wall{there - big * (side + other), there + 2 * big * side,
                            there + 2 * big * other};
        const Ray left{rt::leave_surface(hit, hit.normal), hit.normal};
        if (rt::hit_triangle(wall, left, {})) continue;
        INFO(describe(place) << " starts at " << text(left.origin)
                             << ", beyond a wall at a distance of ten times its error");
        REQUIRE(rt::hit_triangle(wall, left, {}));
    }
    SUCCEED();
}

TEST_CASE("12.4 a scene 2^30 times larger or smaller scales the point and its error",
          "[12.4][hard]") {
    rt::Rng rng{124, 7};
    for (int i = 0; i < 10'000; ++i) {
        const SceneTriangle triangle{placed(plain_triangle(rng), 1, in_cube(rng))};
        const Vec3 from = 3 * any_direction(rng);
        const Ray ray{from, point_of(triangle.shape, real(0.3), real(0.5)) - from};
        const auto met = rt::hit_triangle(triangle.shape, ray, {});
        if (!met) continue;
        const Hit hit = rt::surface_hit(triangle, ray, met->t);
        for (const int power : {-30, 30}) {
            const Real s = std::scalbn(Real(1), power);
            const SceneTriangle scaled{placed(triangle.shape, s, {})};
            const Hit there = rt::surface_hit(scaled, {s * from, s * ray.direction}, met->t);
            const bool same = there.point == s * hit.point &&
                              there.point_error == s * hit.point_error &&
                              there.normal == hit.normal;
            if (same) continue;
            INFO(text(triangle.shape) << " and " << text(ray) << ", scaled by 2^" << power);
            HINT(s * hit.point, there.point,
                 "the point scales with the scene: use no fixed length");
            HINT(s * hit.point_error, there.point_error,
                 "the error scales with the scene: use no fixed length");
            REQUIRE(same);
        }
    }
    SUCCEED();
}
