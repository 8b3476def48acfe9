#include <rt/bounds.hpp>

#include "scenes.hpp"

using namespace checkpoint;
using rt::bounds_of;
using rt::join;
using rt::Sphere;

namespace {

void check_join(const Box& a, const Box& b, const Box& expected, const char* hint) {
    const Box both = join(a, b);
    if (const bool same = both == expected; same) {
        CHECK(same);
        return;
    }
    INFO(checkpoint::text(a) << " and " << checkpoint::text(b) << ".\nHint: " << hint);
    CHECK(checkpoint::text(both) == checkpoint::text(expected));
}

}  // namespace

TEST_CASE("07.2 the box extends from the sphere's center by the radius", "[07.2]") {
    for (const Sphere& sphere : {Sphere{{1, 2, -3}, 4}, Sphere{{-7, 5, 30}, Real(0.5)},
                                 Sphere{{0, 0, 0}, 1}, Sphere{{-2, 6, 1}, 0}}) {
        const Box box = bounds_of(sphere);
        INFO("sphere at " << checkpoint::text(sphere.center) << " of radius "
                          << checkpoint::text(sphere.radius) << ", your " << checkpoint::text(box));
        // The star adds a margin.
        const Real near = 2 * rt::hit_margin * (rt::max_component(sphere.center) + sphere.radius);
        const auto check = [&](Real value, Real expected) {
            HINT(expected, value,
                 "the box extends from center minus radius to center plus radius, along each axis");
            CHECK(std::abs(value - expected) <= near);
        };
        for (int axis = 0; axis < 3; ++axis) {
            const Real center = rt::along(sphere.center, axis);
            check(rt::along(box.low, axis), center - sphere.radius);
            check(rt::along(box.high, axis), center + sphere.radius);
        }
    }
}

TEST_CASE("07.2 the margin is as wide as the proof requires", "[07.2][hard]") {
    rt::Rng rng{72, 1};
    for (int i = 0; i < 3000; ++i) {
        const Real size = any_size(rng, -15, 15);
        Sphere sphere{size * in_cube(rng), size * any_size(rng, -3, 3)};
        if (i == 0) sphere = {{1, 2, -3}, 4};
        if (i % 8 == 1) sphere.radius = 0;
        if (i % 16 == 2) sphere.center = {};
        const Box box = bounds_of(sphere);
        const Real largest = rt::max_component(sphere.center) + sphere.radius;
        const Real margin = rt::hit_margin * largest, rounding = 2 * rt::epsilon * largest;
        const auto check = [&](int axis, const char* side, Real added) {
            if (const bool right = std::abs(added - margin) <= rounding; right) {
                CHECK(right);
                return;
            }
            INFO("sphere at " << checkpoint::text(sphere.center) << " of radius "
                              << checkpoint::text(sphere.radius) << ", your "
                              << checkpoint::text(box));
            INFO("along "
                 << "xyz"[axis] << ", " << side << " the sphere your box has a margin of " << added
                 << "; " EXPECTED << margin
                 << ".\nHint: hit_margin * (max_component(center) + radius), the same on "
                    "all six sides");
            REQUIRE(std::abs(added - margin) <= rounding);
        };
        for (int axis = 0; axis < 3; ++axis) {
            const Real center = rt::along(sphere.center, axis);
            check(axis, "below", (center - rt::along(box.low, axis)) - sphere.radius);
            check(axis, "above", (rt::along(box.high, axis) - center) - sphere.radius);
        }
    }
}

TEST_CASE("07.2 the union of two boxes contains both", "[07.2]") {
    const auto check = check_join;
    const Box a{{0, 0, 0}, {1, 1, 1}}, b{{-2, Real(0.5), 3}, {Real(0.5), 5, 4}};
    const Box expected{{-2, 0, 0}, {1, 5, 4}};
    const char* const hint =
        "take the smaller of the two lows and the larger of the two highs, along each axis";
    check(a, b, expected, hint);
    check(b, a, expected, hint);
    check(a, a, a, hint);
    // All twelve numbers are different, and each of the six results is the only right one.
    const Box low{{-9, -8, -7}, {1, 2, 3}}, high{{-3, -2, -1}, {7, 8, 9}};
    check(low, high, {{-9, -8, -7}, {7, 8, 9}}, hint);
    check(high, low, {{-9, -8, -7}, {7, 8, 9}}, hint);
    const Box inside{{Real(0.25), Real(0.25), Real(0.25)}, {Real(0.5), Real(0.5), Real(0.5)}};
    check(a, inside, a, hint);
    check(inside, a, a, hint);
    const Box point{{3, 0, 0}, {3, 0, 0}}, flat{{3, 0, 0}, {4, 0, 1}};
    const char* const not_empty =
        "a box of one point, or a flat one, is not empty; only Box{} is, and it needs no special "
        "case";
    check(a, point, {{0, 0, 0}, {3, 1, 1}}, not_empty);
    check(point, a, {{0, 0, 0}, {3, 1, 1}}, not_empty);
    check(flat, a, {{0, 0, 0}, {4, 1, 1}}, not_empty);
}

TEST_CASE("07.2 the union of boxes of all sizes is exact", "[07.2][hard]") {
    rt::Rng rng{72, 3};
    const auto any_box = [&](Real size) {
        if (rng() % 16 == 0) return Box{};
        const Vec3 low = size * in_cube(rng), reach = any_size(rng, -9, 1) * size * in_cube(rng);
        const auto larger = [&](Real x, Real by) { return rng() % 4 == 0 ? x : x + std::abs(by); };
        return Box{low, {larger(low.x, reach.x), larger(low.y, reach.y), larger(low.z, reach.z)}};
    };
    const auto lower = [](Real x, Real y) { return x < y ? x : y; };
    const auto higher = [](Real x, Real y) { return x < y ? y : x; };
    for (int i = 0; i < 4000; ++i) {
        const Real size = any_size(rng, -15, 15);
        const Box a = any_box(size);
        Box b = any_box(i % 2 ? size : any_size(rng, -15, 15));
        if (i % 3 == 0 && !a.is_empty()) b = {a.low + b.size(), a.low + b.size()};
        check_join(
            a, b,
            {{lower(a.low.x, b.low.x), lower(a.low.y, b.low.y), lower(a.low.z, b.low.z)},
             {higher(a.high.x, b.high.x), higher(a.high.y, b.high.y), higher(a.high.z, b.high.z)}},
            "each of the six numbers is one of the numbers of a or b, with all its digits");
    }
}

TEST_CASE("07.2 the union with the empty box changes nothing", "[07.2]") {
    const Box a{{-5, -6, -7}, {-2, -3, -4}};
    const char* const hint =
        "the empty box extends from infinity to -infinity; it needs no special case";
    check_join({}, a, a, hint);
    check_join(a, {}, a, hint);
    check_join({}, {}, {}, hint);
}

// The reason for the margin: whatever hit_sphere takes for a hit, the box test must let through.
TEST_CASE("07.2 no ray hits a sphere and misses its box", "[07.2][hard]") {
    rt::Rng rng{72, 2};
    const auto check = [&](const Sphere& sphere, const Ray& ray) {
        const auto t = rt::hit_sphere(sphere, ray, {});
        if (!t) return false;
        const Box box = bounds_of(sphere);
        const auto part = rt::hit_box(box, rt::slab_ray(ray), {0, std::max(Real(0), *t)});
        if (part.min <= part.max) return true;
        INFO("sphere at " << checkpoint::text(sphere.center) << " of radius "
                          << checkpoint::text(sphere.radius) << ", " << checkpoint::text(ray)
                          << ": hit at t = " << checkpoint::text(*t));
        FAIL("your " << checkpoint::text(box)
                     << " is missed.\nHint: does [07.1] pass, with the ray's margin? If so, the "
                        "box is too small: see the test of the margin above");
        return false;
    };
    int hits = 0;
    for (int i = 0; i < 40000; ++i) {
        const Real size = any_size(rng, -4, 4);
        const Sphere sphere{size * in_cube(rng), any_size(rng, -2, 2)};
        const Spheres only{{sphere, 0}};
        // At the sphere's tips along the axes, its box is nearest.
        const int axis = i % 3;
        const auto turn = [&](Vec3 v) {
            for (int k = 0; k < axis; ++k) v = {v.z, v.x, v.y};
            return v;
        };
        const Real slope = any_size(rng, -9, 0) * (rng.uniform() < Real(0.5) ? 1 : -1);
        const Vec3 tip = sphere.center + turn({0, sphere.radius, 0});
        const Vec3 d = turn({1, slope, rng.uniform(-1, 1)});
        hits += check(sphere, {tip - any_size(rng, -8, 4) * d, d});
        hits += check(sphere, any_ray(only, rng, i));
        // From the origin, where the ray's own share of the margin is 0.
        const Sphere there{any_size(rng, -2, 4) * d - turn({0, sphere.radius, 0}), sphere.radius};
        hits += check(there, {{0, 0, 0}, d});
    }
    INFO("the test itself is wrong if only a few of its rays hit");
    CHECK(hits > 15000);
}
