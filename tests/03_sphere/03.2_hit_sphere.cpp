#include <optional>
#include <rt/hit_sphere.hpp>
#include <string>

#include "checkpoint.hpp"
#include "random_inputs.hpp"
#include "statistics.hpp"

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

// Where the line of a ray meets a sphere, exactly, and the error that t is allowed: both as
// docs/03-sphere.md derives them.
struct Meeting {
    bool moves = false;     // the direction is not zero
    bool hits = false;      // the line meets the sphere
    bool is_clear = false;  // whether it does is clear in spite of rounding
    Exact low, high;
    double allowed = 0;
    double length = 0;  // of the direction

    Meeting(const Sphere& sphere, const Ray& ray) {
        const ExactVec3 f = exact_vector(ray.origin) - exact_vector(sphere.center);
        const ExactVec3 d = exact_vector(ray.direction);
        const Exact a = dot(d, d), r(sphere.radius);
        if (!(a.high > 0)) return;
        moves = true;
        const Exact one = study::sqrt(a), along = dot(f, d) / one;
        const Exact p = exact_length(cross(f, d)) / one;
        const double size = exact_length(f).high + r.high;
        length = one.high;
        hits = p.high < r.high;
        is_clear = std::abs((p - r).high) >= 3 * static_cast<double>(rt::epsilon) * size;
        if (!hits) return;
        const Exact h = study::sqrt((r - p) * (r + p));
        low = (-along - h) / one;
        high = (-along + h) / one;
        allowed = 6 * static_cast<double>(rt::epsilon) * size * (1 + p.high / h.high) / length;
    }

    bool is_at(double t, Exact where) const { return std::abs((Exact(t) - where).high) <= allowed; }
};

// What a wrong answer suggests.
const char* suggestion(const Meeting& exact, Interval within, const Hit& t) {
    if (!exact.moves) return "a is 0: a ray that does not move meets nothing";
    if (!exact.hits) return "the ray passes by: the discriminant is negative, so return {}";
    if (!t) return "the discriminant is positive: check the nearer solution, then the farther one";
    if (!within.contains(*t))
        return "this t is not within the interval: test it with within.contains(t)";
    const auto computed = static_cast<double>(*t);
    if (exact.is_at(computed, exact.high))
        return "this is the farther solution: take the nearer one if it is within the interval";
    if (exact.is_at(computed / exact.length, exact.low) ||
        exact.is_at(computed / exact.length, exact.high) ||
        exact.is_at(computed / exact.length / exact.length, exact.low))
        return "t is measured in lengths of the direction; the square of this length is "
               "a = dot(d, d)";
    return "f is the ray's origin minus the sphere's center, and a is dot(d, d), which is 1 only "
           "if the direction has length 1. solve_quadratic takes a, 2 b and c; "
           "roots_from_discriminant also takes 4 times your quarter of the discriminant";
}

// Checks only where both ends of the interval are clearly away from both solutions, in
// spite of rounding.
void check_within(const Sphere& sphere, const Ray& ray, Interval within) {
    const Meeting exact{sphere, ray};
    if (exact.moves && !exact.is_clear) return;
    const auto is_in = [&](Exact t) {
        return static_cast<double>(within.min) < t.high - exact.allowed &&
               t.high + exact.allowed < static_cast<double>(within.max);
    };
    const auto is_out = [&](Exact t) {
        return t.high + exact.allowed < static_cast<double>(within.min) ||
               static_cast<double>(within.max) < t.high - exact.allowed;
    };
    const bool has_low = exact.hits && is_in(exact.low);
    const bool has_high = exact.hits && !has_low && is_in(exact.high);
    if (exact.hits && !has_low && !(is_out(exact.low) && (has_high || is_out(exact.high)))) return;
    // The hit of an earlier call must not show through.
    hit_sphere({{0, 0, -5}, 1}, forward, whole_line);
    const Hit t = hit_sphere(sphere, ray, within);
    const bool has_any = has_low || has_high;
    const Exact expected = has_low ? exact.low : exact.high;
    INFO(scene(sphere, ray) << ", t from " << checkpoint::text(within.min) << " to "
                            << checkpoint::text(within.max) << ": " EXPECTED
                            << (has_any ? "t = " + checkpoint::text(expected) : "no hit")
                            << ", " ACTUAL << text(t)
                            << ".\nHint: " << suggestion(exact, within, t));
    const std::string came = t ? "a hit" : "no hit";
    REQUIRE(came == (has_any ? "a hit" : "no hit"));
    if (!has_any) return;
    const double error_over_allowed = times_allowed(*t, expected, exact.allowed);
    REQUIRE(error_over_allowed <= 1);
}

// The same for small whole numbers, with an answer found by hand. The hint is for code that misses
// the hit, or finds one where there is none.
void check(const Sphere& sphere, const Ray& ray, Interval within, Hit expected, const char* hint) {
    const Hit t = hit_sphere(sphere, ray, within);
    const Meeting exact{sphere, ray};
    const bool same_kind = t.has_value() == expected.has_value();
    INFO(scene(sphere, ray) << ", t from " << within.min << " to " << within.max);
    INFO(EXPECTED << text(expected) << ", " ACTUAL << text(t)
                  << ".\nHint: " << (same_kind ? suggestion(exact, within, t) : hint));
    const std::string came = t ? "a hit" : "no hit";
    REQUIRE(came == (expected ? "a hit" : "no hit"));
    if (!expected) return;
    const double error_over_allowed = times_allowed(*t, Exact(*expected), exact.allowed);
    CHECK(error_over_allowed <= 1);
}

// A ray from `distance` radii away that passes the center at `aside` radii, or half of the way
// round to the back.
Ray aimed(rt::Rng& rng, const Sphere& sphere, Real distance, Real aside, Real length,
          bool backward = false) {
    const auto across = [&](Vec3 w) {
        const Vec3 v = any_direction(rng);
        const Vec3 c{v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x};
        return c / std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z);
    };
    const Vec3 w = any_direction(rng), side = across(w);
    const Real sine = std::min(aside / distance, Real(1));
    const Real cosine = std::sqrt((1 - sine) * (1 + sine)) * (backward ? -1 : 1);
    return {sphere.center + sphere.radius * distance * w, length * (sine * side - cosine * w)};
}

// Checks such a ray with intervals of all kinds, for a sphere about as far from (0, 0, 0) as it is
// large.
void check_any_interval(rt::Rng& rng, Real radius, Real distance, Real aside, Real length) {
    const Sphere sphere{any_vector(rng, -2, 1) * radius, radius};
    const Ray ray = aimed(rng, sphere, distance, aside, length, rng() % 8 == 0);
    check_within(sphere, ray, whole_line);
    check_within(sphere, ray, ahead);
    const Meeting exact{sphere, ray};
    const Real low = real(exact.low.high), high = real(exact.high.high);
    const Real middle = low + (high - low) * rng.uniform(), past = high + (high - low) * 2;
    const Real before = low - (high - low) * rng.uniform();
    check_within(sphere, ray, {middle, infinity});
    check_within(sphere, ray, {before, middle});
    check_within(sphere, ray, {middle, past});
    check_within(sphere, ray, {-infinity, before});
    check_within(sphere, ray, {past, infinity});
    check_within(sphere, ray, {middle, middle});
    check_within(sphere, ray, {past, before});  // empty
}

// Checks both intersections, and says whether the sphere is clearly hit or missed, in spite of
// rounding: otherwise there is nothing to check.
bool check_both(const Sphere& sphere, const Ray& ray, const char* hint) {
    const Meeting exact{sphere, ray};
    if (!exact.is_clear) return false;
    INFO(scene(sphere, ray) << "\nHint: " << hint);
    if (!exact.hits) {
        const Hit t = hit_sphere(sphere, ray, whole_line);
        INFO("the ray passes by: " EXPECTED "no hit, " ACTUAL << text(t));
        REQUIRE(text(t) == "no hit");
        return true;
    }
    const auto check_t = [&](const char* which, Interval within, Exact expected) {
        const Hit t = hit_sphere(sphere, ray, within);
        INFO(which << ": " EXPECTED "t = " << checkpoint::text(expected) << " within "
                   << exact.allowed << ", " ACTUAL << text(t));
        REQUIRE(text(t) != "no hit");
        const double error_over_allowed = times_allowed(*t, expected, exact.allowed);
        REQUIRE(error_over_allowed <= 1);
    };
    check_t("nearer hit", whole_line, exact.low);
    const Real middle = real(((exact.low + exact.high) * Exact(0.5)).high);
    check_t("farther hit", {middle, infinity}, exact.high);
    return true;
}

// How far aside a ray passes, in radii, at random: any point of a disk of this radius is as likely.
Real any_aside(rt::Rng& rng, Real most) {
    return most * std::sqrt(rng.uniform());
}

// A sphere of any usual size at a place as far away.
Sphere any_sphere(rt::Rng& rng) {
    const Real radius = any_size(rng, -1, 1);
    return {radius * Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)}, radius};
}

}  // namespace

TEST_CASE("03.2 a ray from outside hits the near side", "[03.2]") {
    check({{0, 0, -5}, 1}, forward, ahead, Real(4),
          "the line meets the sphere at t = 4 and 6. If you find -6 and -4, f has the wrong sign: "
          "it must lead from the center to the ray's origin. Otherwise: the factor of t in the "
          "equation is 2 b");
    check({{0, 3, -9}, 5}, forward, ahead, Real(5),
          "half of the chord is 4, because 3^2 + 4^2 = 5^2");
}

TEST_CASE("03.2 t need not be a whole number", "[03.2]") {
    const char* const hint = "a, b and c are of the type Real: an int drops the fraction";
    check({{0, 0, -2}, Real(1.5)}, forward, ahead, Real(0.5), hint);
    check({{0, 0, Real(-1.25)}, 1}, forward, ahead, Real(0.25), hint);
}

TEST_CASE("03.2 a hit depends on where the center of the sphere is", "[03.2]") {
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
          "the line meets the sphere at t = -6 and -4, but the interval starts at 0");
}

TEST_CASE("03.2 a ray from inside hits the far side", "[03.2]") {
    check({{0, 0, 0}, 3}, forward, ahead, Real(3),
          "the nearer solution, -3, is behind the origin: the farther one is the hit");
    check({{0, 0, -2}, 5}, forward, ahead, Real(7), "the solutions are -3 and 7");
}

TEST_CASE("03.2 the direction may have any length", "[03.2]") {
    check({{0, 0, -5}, 1}, {{0, 0, 0}, {0, 0, -2}}, ahead, Real(2),
          "t is measured in lengths of the direction: a = dot(d, d) is 4 here");
    check({{0, 0, -5}, 1}, {{0, 0, 0}, {0, 0, Real(-0.5)}}, ahead, Real(8),
          "t is measured in lengths of the direction: a = dot(d, d) is 1/4 here");
    check({{0, 0, -5}, 1}, {{0, 0, 0}, {0, 0, Real(-0x1p-40)}}, ahead, Real(0x4p40),
          "a short direction is not zero: compare a with 0 exactly");
}

TEST_CASE("03.2 only hits within the interval count", "[03.2]") {
    const Sphere sphere{{0, 0, -5}, 1};  // hit at 4 and at 6
    check(sphere, forward, {0, 3}, {}, "both hits are beyond the end of the interval");
    check(sphere, forward, {0, 5}, Real(4), "t = 4 is within the interval");
    check(sphere, forward, {5, infinity}, Real(6),
          "t = 4 lies before the interval, and t = 6 within it");
    check(sphere, forward, {Real(4.5), Real(5.5)}, {},
          "neither t = 4 nor t = 6 is within the interval");
    check(sphere, forward, {7, infinity}, {}, "both hits lie before the interval");
    check(sphere, forward, {4, 4}, Real(4), "the ends of the interval belong to it");
    check(sphere, forward, {6, 6}, Real(6), "the ends of the interval belong to it");
    check({{0, 0, 5}, 1}, forward, {-5, 0}, Real(-4), "an interval may begin below 0");
    check({{0, 0, 5}, 1}, forward, {-9, 0}, Real(-6), "an interval may begin below 0");
}

TEST_CASE("03.2 a hit close to the ray's origin counts", "[03.2]") {
    const char* const hint =
        "the interval alone decides which hits count: no t within it is too small";
    check({{0, 0, -1}, 1}, forward, ahead, Real(0), hint);
    check({{0, 0, Real(-1 - 0x1p-12)}, 1}, forward, ahead, Real(0x1p-12), hint);
    check({{0, 0, Real(-0x1p-20)}, Real(0x1p-21)}, forward, ahead, Real(0x1p-21), hint);
}

TEST_CASE("03.2 a direction of length zero hits nothing", "[03.2][hard]") {
    const char* const hint = "a is 0, and a ray that does not move meets nothing";
    check({{0, 0, 0}, 1}, {{0, 0, 5}, {0, 0, 0}}, whole_line, {}, hint);
    check({{0, 0, 0}, 1}, {{0, 0, 0}, {0, 0, 0}}, whole_line, {}, hint);
    check({{0, 0, 0}, 1}, {{0, 0, 1}, {0, 0, 0}}, whole_line, {}, hint);
}

TEST_CASE("03.2 hits keep to their error bound for any sphere and ray and interval",
          "[03.2][hard]") {
    rt::Rng rng{32, 1};
    for (int i = 0; i < 400; ++i) {
        const Real radius = rng.uniform(Real(0.5), 2), length = rng.uniform(Real(0.5), 2);
        const Real distance = i % 4 == 0 ? rng.uniform() : rng.uniform(1, 10);
        check_any_interval(rng, radius, distance, rng.uniform(0, Real(1.3)), length);
    }
}

TEST_CASE("03.2 both hits are accurate for a ray that starts on the surface", "[03.2][hard]") {
    const Sphere sphere{{1, 1, 1}, 7};
    const Vec3 start{3, 4, 7};  // 2, 3, 6 from the center: 4 + 9 + 36 = 49
    check(sphere, {start, {2, 3, 6}}, {-9, Real(-0.5)}, Real(-2),
          "one solution is 0, which is not within the interval, and the other is -2");
    check(sphere, {start, {-2, -3, -6}}, {Real(0.5), infinity}, Real(2),
          "one solution is 0, which is not within the interval, and the other is 2");
    rt::Rng rng{32, 3};
    for (int i = 0; i < 200; ++i) {
        // Just outside, just inside, or on it.
        const Real radius = any_size(rng, -1, 1);
        const Vec3 center{rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-3, 3)};
        check_both({center, radius}, {center + radius * any_direction(rng), any_direction(rng)},
                   "the ray starts on the surface, up to rounding, so c is nothing but rounding "
                   "error, and one t must be 0 within the bound");
    }
}

TEST_CASE("03.2 t is within its error bound for near spheres", "[03.2][hard]") {
    rt::Rng rng{32, 4};
    for (int i = 0; i < 300; ++i) {
        const Sphere sphere = any_sphere(rng);
        const Real distance = rng.uniform(real(1.5), real(11.5));
        check_both(sphere, aimed(rng, sphere, distance, any_aside(rng, real(1.5)), 1),
                   "pass 2 b and 4 times your quarter of the discriminant to "
                   "roots_from_discriminant. (The section Hard cases derives how accurate t must "
                   "be)");
    }
}

const char* const cancels =
    "b^2 - 4 a c cancels when the sphere is far. 'The discriminant of a far sphere' in the text "
    "derives a form whose terms are small for a ray near the sphere";

TEST_CASE("03.2 a sphere a million radii away is hit at an accurate t", "[03.2][hard]") {
    rt::Rng rng{32, 5};
    for (int i = 0; i < 400; ++i) {
        const Sphere sphere = any_sphere(rng);
        const Real distance = i % 2 == 0 ? Real(1e6) : any_size(rng, 2, 6);
        check_both(sphere, aimed(rng, sphere, distance, any_aside(rng, real(1.4)), 1), cancels);
    }
}

TEST_CASE("03.2 nearly tangent rays are decided correctly", "[03.2][hard]") {
    rt::Rng rng{32, 6};
    int decided = 0;
    for (int i = 0; i < 600; ++i) {
        const Sphere sphere = any_sphere(rng);
        const Real distance = any_size(rng, real(0.3), 3);
        const Real least = std::log10(4 * rt::epsilon * (distance + 1));
        const Real gap = any_number(rng, least, -2);
        if (check_both(sphere, aimed(rng, sphere, distance, 1 + gap, 1), cancels)) ++decided;
    }
    REQUIRE(decided > 400);
}

TEST_CASE("03.2 both solutions are accurate for a ray from inside", "[03.2][hard]") {
    rt::Rng rng{32, 7};
    for (int i = 0; i < 200; ++i) {
        const Sphere sphere = any_sphere(rng);
        const Real distance = rng.uniform();
        check_both(sphere, aimed(rng, sphere, distance, distance * rng.uniform(), 1),
                   "one solution is negative, the other positive");
    }
}

TEST_CASE("03.2 tiny and huge spheres are hit", "[03.2][hard]") {
    rt::Rng rng{32, 8};
    for (int i = 0; i < 400; ++i) {
        // A speck seen in a room of 1 m, a planet from its surface.
        const Real radius = i % 2 == 0 ? Real(1e-6) : Real(1e6);
        const Real seen_from = radius < 1 ? Real(1e6) : 1 + Real(1e-6);
        const Sphere sphere{
            radius * Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)}, radius};
        const Real distance = i % 4 < 2 ? rng.uniform(2, 102) : seen_from;
        const Real aside = any_aside(rng, i % 4 < 2 ? real(1.3) : Real(1));
        check_both(sphere, aimed(rng, sphere, distance, aside, 1),
                   "use no fixed number such as 0.001: spheres may have any size");
    }
}

TEST_CASE("03.2 directions of any length lead to the same hit points", "[03.2][hard]") {
    rt::Rng rng{32, 9};
    for (int i = 0; i < 200; ++i) {
        const Sphere sphere = any_sphere(rng);
        const Real distance = rng.uniform(2, 12), length = any_size(rng, -6, 6);
        check_both(sphere, aimed(rng, sphere, distance, any_aside(rng, real(1.3)), length),
                   "t is measured in lengths of the direction");
    }
}

TEST_CASE("03.2 a scene gives the same hits at any scale", "[03.2][hard]") {
    constexpr Real far = for_this_precision<Real>(6, 40), longest = for_this_precision<Real>(3, 20);
    constexpr Real farthest = for_this_precision<Real>(5, 8);
    rt::Rng rng{32, 2};
    for (int i = 0; i < 500; ++i) {
        const Real radius = any_size(rng, -far, far), length = any_size(rng, -longest, longest);
        check_any_interval(rng, radius, rng.uniform(0, 10), rng.uniform(0, Real(1.3)), length);
        // From far away, to the middle and to the rim.
        const Real distance = any_size(rng, 0, farthest);
        const Real rim = 1 + any_number(rng, for_this_precision<Real>(-6, -15), -1);
        check_any_interval(rng, radius, distance, i % 4 == 0 ? 0 : rim, length);
    }
}
