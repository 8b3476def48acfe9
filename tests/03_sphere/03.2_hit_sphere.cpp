#include <optional>
#include <rt/hit_sphere.hpp>
#include <string_view>

#include "checkpoint.hpp"
#include "exact_hits.hpp"

using namespace checkpoint;
using rt::hit_sphere;
using rt::infinity;
using rt::Interval;
using rt::Ray;
using rt::Sphere;

namespace {

using Hit = std::optional<Real>;

constexpr Interval ahead{0, infinity};
constexpr Interval whole_line{-infinity, infinity};
const Ray forward{{0, 0, 0}, {0, 0, -1}};

std::string text(const Hit& t) {
    return t ? "t = " + checkpoint::text(*t) : "no hit";
}

std::string scene(const Sphere& sphere, const Ray& ray) {
    using checkpoint::text;
    return "sphere at " + text(sphere.center) + " of radius " + text(sphere.radius) +
           ", ray from " + text(ray.origin) + " along " + text(ray.direction);
}

// For small whole numbers nothing is rounded: t must be exactly this.
void check(const Sphere& sphere, const Ray& ray, Interval within, Hit expected, const char* hint) {
    const Hit t = hit_sphere(sphere, ray, within);
    INFO(scene(sphere, ray) << ", t from " << within.min << " to " << within.max);
    INFO("expected " << text(expected) << ", but yours gives " << text(t) << ".\nHint: " << hint);
    CHECK((t == expected));
}

// The rows of one kind: both intersections, each within the error that the row allows.
void check_table(std::string_view kind, const char* hint) {
    for (const auto& row : exact::hits()) {
        if (row.kind != kind) continue;
        const Sphere sphere{vec3(row.center), real(row.radius)};
        const Ray ray{vec3(row.origin), vec3(row.direction)};
        INFO(scene(sphere, ray) << "\nHint: " << hint);
        const auto check_t = [&](const char* which, Interval within, Exact exact) {
            const Hit t = hit_sphere(sphere, ray, within);
            INFO(which << ": expected t = " << checkpoint::text(exact) << " within " << row.allowed
                       << ", but yours gives " << text(t));
            REQUIRE(t.has_value());
            REQUIRE(std::abs((Exact(static_cast<double>(*t)) - exact).high) <= row.allowed);
        };
        if (row.hits) {
            check_t("nearer hit", whole_line, row.low);
            const Real middle = real((row.low + row.high).high / 2);
            check_t("farther hit", {middle, infinity}, row.high);
        } else {
            const Hit t = hit_sphere(sphere, ray, whole_line);
            INFO("the ray passes by, but yours gives " << text(t));
            REQUIRE_FALSE(t.has_value());
        }
    }
}

}  // namespace

TEST_CASE("03.2 from outside the near side is hit", "[03.2]") {
    check({{0, 0, -5}, 1}, forward, ahead, Real(4), "4 is the near side, 6 the far one");
    check({{0, 3, -9}, 5}, forward, ahead, Real(5), "half of the chord is 4: 3, 4, 5");
}

TEST_CASE("03.2 the center of the sphere counts", "[03.2]") {
    check({{10, 20, 30}, 2}, {{10, 20, 40}, {0, 0, -1}}, ahead, Real(8),
          "f is the ray's origin minus the sphere's center");
    check({{0, 10, -5}, 1}, forward, ahead, {}, "this sphere is far above the ray");
}

TEST_CASE("03.2 a ray that passes by hits nothing", "[03.2]") {
    check({{2, 0, -5}, 1}, forward, ahead, {}, "the discriminant is negative here");
    check({{0, -3, -5}, 2}, forward, whole_line, {}, "the discriminant is negative here");
}

TEST_CASE("03.2 a sphere behind the ray is not hit", "[03.2]") {
    check({{0, 0, 5}, 1}, forward, ahead, {},
          "the line meets it at t = -6 and -4, but the interval starts at 0");
}

TEST_CASE("03.2 from inside the far side is hit", "[03.2]") {
    check({{0, 0, 0}, 3}, forward, ahead, Real(3),
          "the nearer solution, -3, is behind the origin: the farther one is the hit");
    check({{0, 0, -2}, 5}, forward, ahead, Real(7), "the solutions are -3 and 7");
}

TEST_CASE("03.2 the direction may have any length", "[03.2]") {
    check({{0, 0, -5}, 1}, {{0, 0, 0}, {0, 0, -2}}, ahead, Real(2),
          "t counts in lengths of the direction: a = dot(d, d) is 4 here");
    check({{0, 0, -5}, 1}, {{0, 0, 0}, {0, 0, Real(-0.5)}}, ahead, Real(8),
          "t counts in lengths of the direction: a = dot(d, d) is 1/4 here");
    check({{0, 0, -5}, 1}, {{0, 0, 0}, {0, 0, Real(-0x1p-40)}}, ahead, Real(0x4p40),
          "short is not zero: compare a with 0 exactly");
}

TEST_CASE("03.2 only hits within the interval count", "[03.2]") {
    const Sphere sphere{{0, 0, -5}, 1};  // hit at 4 and at 6
    check(sphere, forward, {0, 3}, {}, "both hits are beyond the end of the interval");
    check(sphere, forward, {0, 5}, Real(4), "4 is within");
    check(sphere, forward, {5, infinity}, Real(6), "4 lies before the interval, 6 within");
    check(sphere, forward, {Real(4.5), Real(5.5)}, {}, "neither 4 nor 6 is within");
    check(sphere, forward, {7, infinity}, {}, "both hits lie before the interval");
    check(sphere, forward, {4, 4}, Real(4), "the ends of the interval belong to it");
    check(sphere, forward, {6, 9}, Real(6), "the ends of the interval belong to it");
    check({{0, 0, 5}, 1}, forward, {-5, 0}, Real(-4), "an interval may begin below 0");
}

TEST_CASE("03.2 a direction of length zero hits nothing", "[03.2][hard]") {
    const char* const hint = "a is 0, and a ray that does not move meets nothing";
    check({{0, 0, 0}, 1}, {{0, 0, 5}, {0, 0, 0}}, whole_line, {}, hint);
    check({{0, 0, 0}, 1}, {{0, 0, 0}, {0, 0, 0}}, whole_line, {}, hint);
    check({{0, 0, 0}, 1}, {{0, 0, 1}, {0, 0, 0}}, whole_line, {}, hint);
}

TEST_CASE("03.2 a tangent ray touches the sphere once", "[03.2][hard]") {
    const char* const hint =
        "all numbers on the way are small and whole, so the discriminant is exactly 0: a hit";
    check({{0, 0, 0}, 1}, {{0, 1, 5}, {0, 0, -1}}, ahead, Real(5), hint);
    check({{0, 0, 0}, 5}, {{-10, -5, 0}, {3, 4, 0}}, ahead, Real(2), hint);
    check({{0, 0, 0}, 5}, {{-10, -5, 0}, {6, 8, 0}}, ahead, Real(1), hint);
    check({{7, 0, 1}, 13}, {{43, -10, 1}, {-12, -5, 0}}, ahead, {},
          "this one passes at 20 and more from the center");
    check({{1, 2, 3}, 13}, {{1 + 5 + 24, 2 - 12 + 10, 3}, {-12, -5, 0}}, ahead, Real(2), hint);
    check({{0, 0, 0}, 1}, {{0, 1, 0}, {0, 0, -1}}, ahead, Real(0), hint);
}

TEST_CASE("03.2 a ray that starts on the surface hits it at zero", "[03.2][hard]") {
    const char* const hint = "c is exactly 0, so one solution is exactly 0";
    const Sphere sphere{{1, 1, 1}, 7};
    const Vec3 start{3, 4, 7};  // 2, 3, 6 from the center: 4 + 9 + 36 = 49
    for (const Vec3 inwards : {Vec3{-2, -3, -6}, Vec3{-4, -6, -12}})
        check(sphere, {start, inwards}, ahead, Real(0), hint);
    check(sphere, {start, {2, 3, 6}}, ahead, Real(0), hint);
    check(sphere, {start, {2, 3, 6}}, {-9, Real(-0.5)}, Real(-2), "the other solution is -2");
    check(sphere, {start, {-2, -3, -6}}, {rt::epsilon, infinity}, Real(2),
          "an interval that begins after 0 leaves the other solution, 2");
    check_table("surface",
                "rounded to the surface, c is all rounding: 0 within what the bound allows");
}

TEST_CASE("03.2 near spheres are hit within the bound", "[03.2][hard]") {
    check_table("near",
                "2 b and four quarters of the discriminant go to roots_from_discriminant. (Section "
                "Hard cases "
                "derives how exact t must be)");
}

TEST_CASE("03.2 a sphere a million radii away is hit where it should", "[03.2][hard]") {
    check_table(
        "far",
        "b^2 - 4 a c cancels when the sphere is far. 'The discriminant of a far sphere' in the "
        "text has one whose terms are as small as the sphere");
}

TEST_CASE("03.2 nearly tangent rays are decided rightly", "[03.2][hard]") {
    check_table(
        "grazing",
        "b^2 - 4 a c cancels when the sphere is far. 'The discriminant of a far sphere' in the "
        "text has one whose terms are as small as the sphere");
}

TEST_CASE("03.2 from inside both ways are right", "[03.2][hard]") {
    check_table("inside", "one solution is negative, the other positive");
}

TEST_CASE("03.2 tiny and huge spheres are hit", "[03.2][hard]") {
    check_table("tiny or huge",
                "is there a number such as 0.001 in your code? No scale is special");
}

TEST_CASE("03.2 directions of any length give the same points", "[03.2][hard]") {
    check_table("any direction", "t counts in lengths of the direction");
}

TEST_CASE("03.2 the scene at any scale gives the same hits", "[03.2][hard]") {
    // 2^30 is about 10^9, and a power of two rounds nothing: t must scale to the last bit.
    for (const Real scale : {Real(0x1p-30), Real(0x1p30)})
        for (const auto& row : exact::hits()) {
            if (row.kind != std::string_view("near") && row.kind != std::string_view("inside"))
                continue;
            const Sphere sphere{vec3(row.center), real(row.radius)};
            const Ray ray{vec3(row.origin), vec3(row.direction)};
            const Hit t = hit_sphere(sphere, ray, ahead);
            const Hit scaled = hit_sphere({scale * sphere.center, scale * sphere.radius},
                                          {scale * ray.origin, ray.direction}, ahead);
            INFO(scene(sphere, ray)
                 << ": " << text(t) << "; everything times " << scale << ": " << text(scaled)
                 << ".\nHint: a fixed number such as 0.001 or 1e-6 in your code?");
            REQUIRE(scaled.has_value() == t.has_value());
            REQUIRE(scaled.value_or(0) == t.value_or(0) * scale);
        }
}
