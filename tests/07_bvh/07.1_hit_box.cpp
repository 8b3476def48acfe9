#include <rt/hit_box.hpp>

#include "scenes.hpp"

using namespace checkpoint;
using rt::hit_box;
using rt::infinity;
using rt::SlabRay;

namespace {

const Box unit{{0, 0, 0}, {1, 1, 1}};
constexpr Interval ahead{0, infinity};

// A ray with a margin of its own, mostly none: for small whole numbers all is exact.
SlabRay bare(Vec3 origin, Vec3 direction, Real margin = 0) {
    return {origin, {1 / direction.x, 1 / direction.y, 1 / direction.z}, margin};
}

void check(const Box& box, Vec3 origin, Vec3 direction, Interval within, bool expected,
           const char* hint, Real margin = 0) {
    const bool met = hit_box(box, bare(origin, direction, margin), within);
    INFO(checkpoint::text(box) << ", " << checkpoint::text(Ray{origin, direction}) << ", t from "
                               << within.min << " to " << within.max << ", margin " << margin);
    INFO("expected " << (expected ? "a hit" : "no hit") << ", but yours gives "
                     << (met ? "a hit" : "no hit") << ".\nHint: " << hint);
    CHECK(met == expected);
}

Vec3 turned(Vec3 v, int times) {
    for (int i = 0; i < times; ++i) v = {v.z, v.x, v.y};
    return v;
}

}  // namespace

TEST_CASE("07.1 a ray through the box hits it", "[07.1]") {
    check(unit, {-1, Real(0.5), Real(0.25)}, {1, Real(0.125), Real(0.125)}, ahead, true,
          "it passes all three slabs at once from t = 1 to 2");
    check(unit, {-1, -1, -1}, {1, 1, 1}, ahead, true, "along the diagonal");
    check(unit, {Real(0.5), Real(0.5), Real(0.5)}, {1, 2, -4}, ahead, true,
          "it starts inside: the box begins at a negative t and ends at a positive one");
}

TEST_CASE("07.1 a ray past the box misses it", "[07.1]") {
    check(unit, {-1, 3, Real(0.5)}, {1, Real(0.5), Real(0.25)}, ahead, false, "far above the box");
    check(unit, {-1, Real(0.5), Real(0.5)}, {1, 2, Real(0.125)}, ahead, false,
          "in the slab of x from t = 1 on, but of y only until 1/4: all three must overlap");
    check(unit, {2, Real(0.5), Real(0.5)}, {1, Real(0.125), Real(0.125)}, ahead, false,
          "the box is behind the ray");
}

TEST_CASE("07.1 a ray may run backwards along each axis", "[07.1]") {
    for (int axis = 0; axis < 3; ++axis) {
        const char* const hint = "with a negative component the higher plane comes first";
        const Vec3 origin = turned({2, Real(0.5), Real(0.25)}, axis);
        check(unit, origin, turned({-1, Real(0.125), Real(0.125)}, axis), ahead, true, hint);
        check(unit, origin, turned({-1, 2, Real(0.125)}, axis), ahead, false,
              "it leaves the slab of another axis before it gets there");
    }
    check(unit, {2, 2, 2}, {-1, -1, -1}, ahead, true, "backwards along the diagonal");
}

TEST_CASE("07.1 only what lies within the interval counts", "[07.1]") {
    const Vec3 o{-2, Real(0.5), Real(0.25)}, d{1, Real(0.125), Real(0.125)};  // from t = 2 to 3
    check(unit, o, d, {0, 1}, false, "the box begins behind the end of the interval");
    check(unit, o, d, {4, 9}, false, "the box ends before the interval begins");
    check(unit, o, d, {0, Real(2.5)}, true, "they overlap from 2 to 2.5");
    check(unit, o, d, {Real(2.25), Real(2.5)}, true, "the interval lies within the box");
    check(unit, o, d, {0, 2}, true, "the ends of the interval belong to it: a hit at 2 counts");
    check(unit, o, d, {3, 9}, true, "the ends of the interval belong to it");
    check(unit, {2, Real(0.5), Real(0.25)}, d, {-9, 0}, true, "an interval may begin below 0");
}

TEST_CASE("07.1 zero components of either sign", "[07.1][hard]") {
    for (int axis = 0; axis < 3; ++axis)
        for (const Real a : {Real(0), -Real(0)})
            for (const Real b : {Real(0), -Real(0)})
                for (const Real way : {Real(1), Real(-1)}) {
                    const Vec3 d = turned({way, a, b}, axis);
                    const auto from = [&](Real y, Real z) {
                        return turned({Real(0.5) - 2 * way, y, z}, axis);
                    };
                    check(unit, from(Real(0.5), Real(0.5)), d, ahead, true,
                          "along an axis, through the middle: both planes of the other slabs are "
                          "at infinity, one in front and one behind");
                    check(unit, from(2, Real(0.5)), d, ahead, false,
                          "along an axis, beside the box: it is never within the other slab");
                    check(unit, from(Real(0.5), -1), d, ahead, false,
                          "along an axis, beside the box: it is never within the other slab");
                }
}

TEST_CASE("07.1 rays in a face or an edge count as hits", "[07.1][hard]") {
    for (int axis = 0; axis < 3; ++axis)
        for (const Real a : {Real(0), -Real(0)})
            for (const Real way : {Real(1), Real(-1)})
                for (const Real face : {Real(0), Real(1)}) {
                    const char* const hint =
                        "0 * infinity is not a number: this plane must not decide, whether it is "
                        "the nearer or the farther one. std::min(a, b) and std::max(a, b) return a "
                        "where a comparison with b fails";
                    const Real before = Real(0.5) - 2 * way;
                    check(unit, turned({before, face, Real(0.5)}, axis),
                          turned({way, a, Real(0.125) * way}, axis), ahead, true, hint);
                    check(unit, turned({before, Real(0.5), face}, axis), turned({way, -a, a}, axis),
                          ahead, true, hint);
                    check(unit, turned({before, face, face}, axis), turned({way, a, -a}, axis),
                          ahead, true, hint);
                    check(unit, turned({before, face, 2}, axis), turned({way, a, a}, axis), ahead,
                          false, "in one face's plane, but beside the box");
                }
}

TEST_CASE("07.1 flat boxes and corners count", "[07.1][hard]") {
    const Box flat{{0, 0, 0}, {1, 0, 1}};
    check(flat, {Real(0.5), 1, Real(0.5)}, {0, -1, 0}, ahead, true,
          "a box without height is entered and left at the same t");
    check(flat, {-1, 0, Real(0.5)}, {1, 0, 0}, ahead, true, "a ray within a flat box");
    check(flat, {-1, 1, Real(0.5)}, {1, 0, 0}, ahead, false, "a ray above a flat box");
    const Box point{{1, 1, 1}, {1, 1, 1}};
    check(point, {0, 0, 0}, {1, 1, 1}, ahead, true, "a box of one point, hit exactly");
    check(unit, {-1, 0, 0}, {1, 1, -1}, ahead, false, "it passes the corner at a distance");
    check(unit, {-1, 2, Real(0.5)}, {1, -1, 0}, ahead, true, "it touches one edge, at t = 1");
    check(unit, {2, -1, 2}, {-1, 1, -1}, ahead, true, "it touches one corner and goes on inside");
}

TEST_CASE("07.1 empty boxes and empty intervals are never hit", "[07.1][hard]") {
    for (const Vec3 d : {Vec3{1, 1, 1}, Vec3{-1, 1, 0}, Vec3{0, -Real(0), 1}})
        check(Box{}, {0, 0, 0}, d, ahead, false,
              "the empty box reaches from infinity to -infinity: it is left before it is entered");
    check(unit, {Real(0.5), Real(0.5), Real(0.5)}, {1, 2, 4}, {1, 0}, false,
          "no t lies between 1 and 0");
}

TEST_CASE("07.1 the margin makes the box larger", "[07.1][hard]") {
    const Vec3 above{-1, Real(1.5), Real(0.5)}, flat{1, Real(0.0625), 0};
    const char* const hint =
        "the ray passes a little more than 1/2 above the box: a margin of 1 reaches it, of 1/2 "
        "not. The low plane goes down by the margin and the high one up, once";
    check(unit, above, flat, ahead, false, hint, 0);
    check(unit, above, flat, ahead, false, hint, Real(0.25));
    check(unit, above, flat, ahead, false, hint, Real(0.5));
    check(unit, above, flat, ahead, true, hint, 1);
    for (const Real way : {Real(1), Real(-1)}) {
        const Vec3 from{Real(0.5), Real(0.5) - 2 * way, Real(-0.5)};
        const char* const in_face =
            "straight up or down in a face of the grown box, which begins at t = 1: the low plane "
            "goes down and the high one up, whichever of them the ray comes to first";
        check(unit, from, {0, way, 0}, ahead, true, in_face, Real(0.5));
        check(unit, from, {0, way, 0}, {0, 1}, true, in_face, Real(0.5));
    }
}

// Whole numbers from -8 to 8, directions of -2, -1, 0, 1, 2: all t are multiples of 1/2.
TEST_CASE("07.1 right for all kinds of whole numbers", "[07.1][hard]") {
    rt::Rng rng{71, 1};
    const auto whole = [&](int low, int high) {
        return low + static_cast<int>(rng() % static_cast<unsigned>(high - low + 1));
    };
    for (int i = 0; i < 20000; ++i) {
        int o[3], d[3], low[3], high[3];
        long first = -1000, last = 1000;  // halves of t
        bool expected = true;
        for (int k = 0; k < 3; ++k) {
            o[k] = whole(-4, 4);
            d[k] = whole(-2, 2);
            low[k] = whole(-4, 4);
            high[k] = low[k] + whole(0, 4);
            if (d[k] == 0) {
                expected = expected && low[k] <= o[k] && o[k] <= high[k];
            } else {
                const long a = 2L * (low[k] - o[k]) / d[k], b = 2L * (high[k] - o[k]) / d[k];
                first = std::max(first, std::min(a, b));
                last = std::min(last, std::max(a, b));
            }
        }
        const long min = whole(-4, 4), max = whole(-4, 12);
        expected = expected && std::max(first, min) <= std::min(last, max);
        const auto point = [](const int(&p)[3]) {
            return Vec3{static_cast<Real>(p[0]), static_cast<Real>(p[1]), static_cast<Real>(p[2])};
        };
        const Box box{point(low), point(high)};
        const Interval within{static_cast<Real>(min) / 2, static_cast<Real>(max) / 2};
        if (hit_box(box, bare(point(o), point(d)), within) != expected) {
            const bool zero = d[0] == 0 || d[1] == 0 || d[2] == 0;
            check(box, point(o), point(d), within, expected,
                  zero ? "a component of the direction is 0: see the cases with zeros and faces"
                       : "all numbers here are exact: touching counts, and so do both ends");
            return;
        }
    }
}
