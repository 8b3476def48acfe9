#include <cstdint>
#include <rt/hit_box.hpp>

#include "scenes.hpp"

using namespace checkpoint;
using rt::hit_box;
using rt::infinity;
using rt::SlabRay;

namespace {

using Whole = std::int64_t;

const Box unit{{0, 0, 0}, {1, 1, 1}};
constexpr Interval ahead{0, infinity};

// A ray with a margin of its own, mostly none: with small whole numbers, everything is exact.
SlabRay bare(Vec3 origin, Vec3 direction, Real margin = 0) {
    return {origin, {1 / direction.x, 1 / direction.y, 1 / direction.z}, margin};
}

bool is_hit(const Box& box, const SlabRay& ray, Interval within) {
    const Interval part = hit_box(box, ray, within);
    return part.min <= part.max;
}

void check(const Box& box, Vec3 origin, Vec3 direction, Interval within, bool expected,
           const char* hint, Real margin = 0) {
    const Interval part = hit_box(box, bare(origin, direction, margin), within);
    const bool met = part.min <= part.max;
    INFO(checkpoint::text(box) << ", " << checkpoint::text(Ray{origin, direction}) << ", t from "
                               << checkpoint::text(within.min) << " to "
                               << checkpoint::text(within.max) << ", margin "
                               << checkpoint::text(margin));
    INFO(EXPECTED << (expected ? "a hit" : "no hit") << ", " ACTUAL "the part from "
                  << checkpoint::text(part.min) << " to " << checkpoint::text(part.max)
                  << ", which is " << (met ? "a hit" : "no hit") << ".\nHint: " << hint);
    CHECK(met == expected);
}

// The ray is in the box from t = expected.min to expected.max.
void check_part(const Box& box, const SlabRay& ray, Interval within, Interval expected,
                const char* hint) {
    const Interval part = hit_box(box, ray, within);
    INFO("within t from " << checkpoint::text(within.min) << " to " << checkpoint::text(within.max)
                          << " the ray is in the box from " << checkpoint::text(expected.min)
                          << " to " << checkpoint::text(expected.max) << ", " ACTUAL "from "
                          << checkpoint::text(part.min) << " to " << checkpoint::text(part.max)
                          << ".\nHint: " << hint);
    CHECK((part.min == expected.min && part.max == expected.max));
}

Vec3 turned(Vec3 v, int times) {
    for (int i = 0; i < times; ++i) v = {v.z, v.x, v.y};
    return v;
}

}  // namespace

TEST_CASE("07.1 a ray through the box hits it", "[07.1]") {
    check(unit, {-1, Real(0.5), Real(0.25)}, {1, Real(0.125), Real(0.125)}, ahead, true,
          "the ray is in all three slabs at once from t = 1 to t = 2");
    check(unit, {-1, -1, -1}, {1, 1, 1}, ahead, true, "the ray runs along the diagonal");
    check(unit, {Real(0.5), Real(0.5), Real(0.5)}, {1, 2, -4}, ahead, true,
          "the ray starts inside: it enters the box at a negative t and leaves it at a positive t");
}

TEST_CASE("07.1 a ray past the box misses it", "[07.1]") {
    check(unit, {-1, 3, Real(0.5)}, {1, Real(0.5), Real(0.25)}, ahead, false,
          "the ray passes far above the box");
    check(unit, {-1, Real(0.5), Real(0.5)}, {1, 2, Real(0.125)}, ahead, false,
          "the ray is in the slab of x from t = 1 on, but in the slab of y only until t = 1/4: the "
          "three intervals must overlap");
    check(unit, {2, Real(0.5), Real(0.5)}, {1, Real(0.125), Real(0.125)}, ahead, false,
          "the box is behind the ray");
}

TEST_CASE("07.1 a ray may run against the direction of each axis", "[07.1]") {
    for (int axis = 0; axis < 3; ++axis) {
        const char* const hint =
            "if a component of the direction is negative, the ray meets the high plane first";
        const Vec3 origin = turned({2, Real(0.5), Real(0.25)}, axis);
        check(unit, origin, turned({-1, Real(0.125), Real(0.125)}, axis), ahead, true, hint);
        check(unit, origin, turned({-1, 2, Real(0.125)}, axis), ahead, false,
              "the ray leaves the slab of another axis before it enters this one");
    }
    check(unit, {2, 2, 2}, {-1, -1, -1}, ahead, true, "the ray runs backward along the diagonal");
}

TEST_CASE("07.1 only hits within the interval count", "[07.1]") {
    const Vec3 o{-2, Real(0.5), Real(0.25)}, d{1, Real(0.125), Real(0.125)};  // from t = 2 to 3
    check(unit, o, d, {0, 1}, false, "the box begins after the end of the interval");
    check(unit, o, d, {4, 9}, false, "the box ends before the interval begins");
    check(unit, o, d, {0, Real(2.5)}, true, "the box and the interval overlap from 2 to 2.5");
    check(unit, o, d, {Real(2.25), Real(2.5)}, true, "the interval lies within the box");
    check(unit, o, d, {0, 2}, true, "the ends of the interval belong to it: a hit at 2 counts");
    check(unit, o, d, {3, 9}, true, "the ends of the interval belong to it");
    check(unit, {2, Real(0.5), Real(0.25)}, d, {-9, 0}, true, "an interval may begin below 0");
}

TEST_CASE("07.1 the part of the interval in the box is returned", "[07.1]") {
    for (int axis = 0; axis < 3; ++axis) {
        // In the three slabs from t = 2 to 3, from -4 to 4, and from -2 to 6.
        const SlabRay ray = bare(turned({-2, Real(0.5), Real(0.25)}, axis),
                                 turned({1, Real(0.125), Real(0.125)}, axis));
        check_part(unit, ray, ahead, {2, 3}, "return the latest entry and the earliest exit");
        check_part(unit, ray, {0, Real(2.5)}, {2, Real(2.5)},
                   "the part ends with the interval, if that comes before the exit");
        check_part(unit, ray, {Real(2.5), 9}, {Real(2.5), 3},
                   "the part begins with the interval, if that comes after the entry");
    }
}

// Small whole numbers, so that nothing is rounded, not even in float.
TEST_CASE("07.1 eight boxes at once give the same as one by one", "[07.1]") {
    rt::Rng rng{71, 3};
    const auto whole = [&] { return static_cast<Real>(rng() % 17) - 8; };
    const auto anywhere = [&] {
        const Real x = whole(), y = whole(), z = whole();
        return Vec3{x, y, z};
    };
    const auto way = [&] {
        return std::ldexp(rng() % 2 ? Real(1) : Real(-1), static_cast<int>(rng() % 3));
    };
    for (int i = 0; i < 1000; ++i) {
        rt::Lanes<Box> boxes;
        for (Box& box : boxes) {
            const Vec3 corner = anywhere();
            box = {corner, corner + abs(anywhere())};
        }
        const Real x = way(), y = way(), z = way();
        const SlabRay ray = bare(anywhere(), {x, y, z}, static_cast<Real>(i % 2));
        const Interval within = i % 3 ? ahead : Interval{1, 4};
        const auto parts = answer::hit_eight(boxes, ray, within),
                   in_float = answer::hit_eight_in_float(boxes, ray, within);
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            const Interval alone = hit_box(boxes[k], ray, within);
            if (alone == parts[k] && alone == in_float[k]) continue;
            const Interval part = alone == parts[k] ? in_float[k] : parts[k];
            INFO("box " << k << " of eight: alone from " << checkpoint::text(alone.min) << " to "
                        << checkpoint::text(alone.max) << ", with the others from "
                        << checkpoint::text(part.min) << " to " << checkpoint::text(part.max));
            INFO(
                "Hint: a pack has a number of each box. Compute all of them in the same way: what "
                "the function does may depend on the ray, but not on one of the boxes");
            REQUIRE(alone == part);
        }
    }
    SUCCEED();
}

TEST_CASE("07.1 the box grows by the margin on all sides", "[07.1]") {
    const char* const hint =
        "the ray passes 1/2 beside the box: a margin of 1 reaches it, one of 1/4 does not. Move "
        "each low plane down and each high plane up by ray.margin";
    for (int axis = 0; axis < 3; ++axis)
        for (const Real side : {Real(1), Real(-1)}) {
            const Vec3 from = turned({-1, Real(0.5) + side, Real(0.5)}, axis),
                       along = turned({1, side / 16, Real(0.125)}, axis);
            check(unit, from, along, ahead, true, hint, 1);
            check(unit, from, along, ahead, false, hint, Real(0.25));
        }
}

TEST_CASE("07.1 directions with zero components of either sign are handled correctly",
          "[07.1][hard]") {
    for (int axis = 0; axis < 3; ++axis)
        for (const Real a : {Real(0), -Real(0)})
            for (const Real b : {Real(0), -Real(0)})
                for (const Real way : {Real(1), Real(-1)}) {
                    const Vec3 d = turned({way, a, b}, axis);
                    const auto from = [&](Real y, Real z) {
                        return turned({Real(0.5) - 2 * way, y, z}, axis);
                    };
                    check(unit, from(Real(0.5), Real(0.5)), d, ahead, true,
                          "the ray runs along an axis, through the box: it meets the planes of the "
                          "other two slabs at infinity, one in front and one behind");
                    check(unit, from(2, Real(0.5)), d, ahead, false,
                          "the ray runs along an axis, beside the box: there is one slab that it "
                          "never enters");
                    check(unit, from(Real(0.5), -1), d, ahead, false,
                          "the ray runs along an axis, beside the box: there is one slab that it "
                          "never enters");
                }
}

TEST_CASE("07.1 rays in a face or an edge count as hits", "[07.1][hard]") {
    for (int axis = 0; axis < 3; ++axis)
        for (const Real a : {Real(0), -Real(0)})
            for (const Real way : {Real(1), Real(-1)})
                for (const Real face : {Real(0), Real(1)}) {
                    const char* const hint =
                        "0 * infinity is NaN: ignore this plane, whether it is the nearer or the "
                        "farther one. min(a, b) and max(a, b) return a if their "
                        "comparison is false";
                    const Real before = Real(0.5) - 2 * way;
                    check(unit, turned({before, face, Real(0.5)}, axis),
                          turned({way, a, Real(0.125) * way}, axis), ahead, true, hint);
                    check(unit, turned({before, Real(0.5), face}, axis), turned({way, -a, a}, axis),
                          ahead, true, hint);
                    check(unit, turned({before, face, face}, axis), turned({way, a, -a}, axis),
                          ahead, true, hint);
                    check(unit, turned({before, face, 2}, axis), turned({way, a, a}, axis), ahead,
                          false, "the ray lies in the plane of a face, but passes beside the box");
                }
}

TEST_CASE("07.1 flat boxes and corners can be hit", "[07.1][hard]") {
    const Box flat{{0, 0, 0}, {1, 0, 1}};
    check(flat, {Real(0.5), 1, Real(0.5)}, {0, -1, 0}, ahead, true,
          "a box without height is entered and left at the same t");
    check(flat, {-1, 0, Real(0.5)}, {1, 0, 0}, ahead, true, "a ray within a flat box");
    check(flat, {-1, 1, Real(0.5)}, {1, 0, 0}, ahead, false, "a ray above a flat box");
    const Box point{{1, 1, 1}, {1, 1, 1}};
    check(point, {0, 0, 0}, {1, 1, 1}, ahead, true, "a box of one point, hit exactly");
    check(unit, {-1, 0, 0}, {1, 1, -1}, ahead, false, "the ray passes the corner at a distance");
    check(unit, {-1, 2, Real(0.5)}, {1, -1, 0}, ahead, true, "the ray touches one edge, at t = 1");
    check(unit, {2, -1, 2}, {-1, 1, -1}, ahead, true,
          "the ray enters at one corner and goes on inside");
}

TEST_CASE("07.1 empty boxes and empty intervals are never hit", "[07.1][hard]") {
    for (const Vec3 d : {Vec3{1, 1, 1}, Vec3{-1, 1, 0}, Vec3{0, -Real(0), 1}})
        check(Box{}, {0, 0, 0}, d, ahead, false,
              "the empty box extends from infinity to -infinity: it is left before it is entered");
    check(unit, {Real(0.5), Real(0.5), Real(0.5)}, {1, 2, 4}, {1, 0}, false,
          "no t lies between 1 and 0");
}

TEST_CASE("07.1 the margin makes the box larger", "[07.1][hard]") {
    const Vec3 above{-1, Real(1.5), Real(0.5)}, flat{1, Real(0.0625), 0};
    const char* const hint =
        "the ray passes a little more than 1/2 above the box: a margin of 1 reaches it, one of 1/2 "
        "does not. Move each low plane down and each high plane up by the margin, once, before you "
        "exchange them";
    check(unit, above, flat, ahead, false, hint, 0);
    check(unit, above, flat, ahead, false, hint, Real(0.25));
    check(unit, above, flat, ahead, false, hint, Real(0.5));
    check(unit, above, flat, ahead, true, hint, 1);
    for (const Real way : {Real(1), Real(-1)}) {
        const Vec3 from{Real(0.5), Real(0.5) - 2 * way, Real(-0.5)};
        const char* const in_face =
            "the ray runs straight up or down in a face of the enlarged box, which begins at t = "
            "1: the low plane moves down and the high one up, whichever of them the ray meets "
            "first";
        check(unit, from, {0, way, 0}, ahead, true, in_face, Real(0.5));
        check(unit, from, {0, way, 0}, {0, 1}, true, in_face, Real(0.5));
    }
}

// Everything is a whole number times a power of two, so nothing is rounded: near misses from afar,
// at all scales, with a different one for each axis.
TEST_CASE("07.1 the result is exact for any small whole numbers", "[07.1][hard]") {
    rt::Rng rng{71, 1};
    const auto whole = [&](Whole low, Whole high) {
        return low + static_cast<Whole>(rng() % static_cast<std::uint64_t>(high - low + 1));
    };
    const Whole always = Whole{1} << 60;  // stands for infinity
    const int count = 30000;
    int right = 0;
    for (int i = 0; i < count; ++i) {
        const int t_power = static_cast<int>(whole(-60, 60)) * (i % 2);
        const bool same_scale = i % 4 < 2;
        const int power = static_cast<int>(whole(-30, 30)) * (i % 2);
        const Whole margin = same_scale ? std::max(Whole{0}, whole(-4, 4)) : 0;
        const Whole size = Whole{1} << whole(2, for_this_precision(16, 38));
        const Whole far = Whole{1} << whole(2, for_this_precision(16, 38));
        const Whole t = whole(-far / 4, far);  // of a point near the box
        const auto near_t = [&] {              // in quarters
            const Whole kind = whole(0, 5);
            return kind == 0   ? always * (whole(0, 1) * 2 - 1)
                   : kind == 1 ? 0
                               : 4 * t + whole(-8, 8);
        };
        const auto end_of = [&](Whole quarters) {
            if (std::abs(quarters) == always) return quarters < 0 ? -infinity : infinity;
            return std::ldexp(static_cast<Real>(quarters), t_power - 2);
        };
        const bool empty = i % 32 == 0;
        const int axis = static_cast<int>(whole(0, 2));  // the direction is not 0 along this one
        bool expected = !empty, zero = false;
        Whole first = -always, last = always;  // quarters of t
        Real origin[3], direction[3], low[3], high[3];
        for (int k = 0; k < 3; ++k) {
            const Whole l = whole(-size, size), h = l + whole(0, 2) * whole(0, size / 2);
            const Whole kind = whole(0, 3), near = whole(-2, 2);
            const Whole place = kind == 0   ? l - margin + near
                                : kind == 1 ? h + margin + near
                                            : whole(l, std::max(l, h));
            const Whole way = whole(0, 1) * 2 - 1;
            const Whole d = k != axis && whole(0, 2) == 0 ? 0 : way * (Whole{1} << whole(0, 2));
            const Whole o = place - t * d;
            if (d == 0) {
                expected = expected && l - margin <= o && o <= h + margin;
            } else {
                const Whole a = 4 * (l - margin - o) / d, b = 4 * (h + margin - o) / d;
                first = std::max(first, std::min(a, b));
                last = std::min(last, std::max(a, b));
            }
            const int own = same_scale ? power : static_cast<int>(whole(-30, 30));
            const auto scaled = [&](Whole x) { return std::ldexp(static_cast<Real>(x), own); };
            origin[k] = scaled(o);
            low[k] = scaled(l);
            high[k] = scaled(h);
            direction[k] = std::ldexp(static_cast<Real>(d), own - t_power);
            if (d == 0 && i % 3 == 0) direction[k] = -Real(0);
            zero = zero || d == 0;
        }
        const Whole min = near_t(), max = near_t();
        expected = expected && std::max(first, min) <= std::min(last, max);
        const auto vec = [](const Real(&v)[3]) { return Vec3{v[0], v[1], v[2]}; };
        const Box box = empty ? Box{} : Box{vec(low), vec(high)};
        const Interval within{end_of(min), end_of(max)};
        const Real grown = std::ldexp(static_cast<Real>(margin), power);
        const SlabRay ray = bare(vec(origin), vec(direction), grown);
        if (is_hit(box, ray, within) == expected) {
            ++right;
            if (expected)
                check_part(box, ray, within,
                           {end_of(std::max(first, min)), end_of(std::min(last, max))},
                           "nothing is rounded here");
            continue;
        }
        check(box, vec(origin), vec(direction), within, expected,
              empty    ? "this is the empty box, Box{}: it is left before it is entered"
              : zero   ? "a component of the direction is 0: see the cases with zeros and faces"
              : margin ? "each low plane goes down by the margin and each high one up"
                       : "nothing is rounded here: a ray that just touches the box hits it, and so "
                         "does one that meets it exactly at an end of the interval; a ray that "
                         "misses by any amount, however small, does not",
              grown);
        return;
    }
    CHECK(right == count);
}

// Rays in any direction that leave one slab just before or just after they enter another: they pass
// an edge of the box, or just cut it.
TEST_CASE("07.1 a near miss counts as a miss in any direction", "[07.1][hard]") {
    rt::Rng rng{71, 2};
    int right = 0;
    for (int i = 0; i < 4000; ++i) {
        const Real size = any_size(rng, -9, 9);
        const Vec3 low = size * any_size(rng, -1, 1) * in_cube(rng);
        const Vec3 high = low + size * (abs(in_cube(rng)) + Vec3{1, 1, 1} * Real(0.01));
        const Vec3 d = any_size(rng, -9, 9) * any_direction(rng);
        const Real margin = i % 2 ? size * any_size(rng, -3, 0) : 0;
        const int left = static_cast<int>(rng() % 3),
                  entered = (left + 1 + static_cast<int>(rng() % 2)) % 3;
        const Real way = size * any_size(rng, -1, 2);
        const Real by = size * any_size(rng, for_this_precision(Real(-5), Real(-13)), -2);
        const bool over = rng() % 2 == 0;
        Real place[3];
        for (int k = 0; k < 3; ++k) {
            const Real l = rt::along(low, k) - margin, h = rt::along(high, k) + margin;
            const bool forward = rt::along(d, k) > 0;
            const Real outward = (forward == over ? -by : by);
            place[k] = k == left      ? (forward ? h : l) + outward
                       : k == entered ? (forward ? l : h)
                                      : (l + h) / 2;
        }
        const Vec3 edge{place[0], place[1], place[2]}, origin = edge - way / max_component(d) * d;
        const Real rounding =
            32 * rt::epsilon *
            (max_component(low) + max_component(high) + max_component(origin) + margin);
        if (by < rounding || max_component(low - high) < 4 * by) continue;
        const SlabRay ray = bare(origin, d, margin);
        if (is_hit({low, high}, ray, ahead) == over) {
            ++right;
            continue;
        }
        check({low, high}, origin, d, ahead, over,
              over ? "the ray just cuts an edge of the box: it is inside for a short distance"
                   : "the ray passes close to an edge of the box and misses: add nothing but the "
                     "margin",
              margin);
        return;
    }
    INFO("the test itself is wrong if it tries only a few rays");
    CHECK(right > 2000);
}
