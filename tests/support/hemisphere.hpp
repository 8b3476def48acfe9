#pragma once
// Are directions spread over a hemisphere as they should be? This is tested by counting them, and
// by how much of the sphere a small square of random numbers becomes.

#include <limits>
#include <rt/vec2.hpp>
#include <rt/vec3.hpp>

#include "checkpoint.hpp"
#include "statistics.hpp"

namespace checkpoint {

using rt::Vec2;

inline constexpr int samples = 200'000;
inline constexpr int turns = 20, rings = 10;  // the grid: cells around the pole, rings from it

inline const Real largest = 1 - rt::epsilon / 2;  // the largest number that uniform() gives
inline const Vec2 corners[] = {{0, 0}, {largest, 0}, {0, largest}, {largest, largest}};
inline const Vec2 edges[] = {{0, real(0.25)},         {largest, real(0.7)}, {real(0.5), 0},
                             {real(0.5), largest},    {rt::epsilon / 2, 0}, {largest, real(0.125)},
                             {real(1e-20), real(0.3)}};

// How far the length is from 1.
inline double length_error(Vec3 v) {
    const Exact squared =
        Exact(v.x) * Exact(v.x) + Exact(v.y) * Exact(v.y) + Exact(v.z) * Exact(v.z);
    return std::abs((squared - Exact(1)).high / 2);  // sqrt(1 + x) is 1 + x / 2 for tiny x
}

// Directions on a hemisphere about `pole`, counted in a grid of `turns` by `rings` cells.
struct Grid {
    Vec3 pole, x, y;
    std::vector<long> counts = std::vector<long>(turns * rings);

    explicit Grid(Vec3 p) : pole{p} {
        // Any direction across the pole will do, and a third across both.
        const Vec3 helper = std::abs(p.x) < real(0.7) ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        x = across(helper, p);
        const Real size = std::sqrt(x.x * x.x + x.y * x.y + x.z * x.z);
        x /= size;
        y = across(p, x);
    }
    static Vec3 across(Vec3 a, Vec3 b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    static double dot(Vec3 a, Vec3 b) {
        return static_cast<double>(a.x * b.x + a.y * b.y + a.z * b.z);
    }

    // ring_of(cosine) in [0, rings)
    template <class RingOf>
    void add(Vec3 d, RingOf ring_of) {
        const double turn = std::atan2(dot(d, y), dot(d, x)) / (2 * 3.141592653589793) + 0.5;
        const int column = std::clamp(static_cast<int>(turn * turns), 0, turns - 1);
        const int row = std::clamp(static_cast<int>(ring_of(dot(d, pole))), 0, rings - 1);
        ++counts[static_cast<std::size_t>(row * turns + column)];
    }
};

// Rings of 9 degrees each.
inline double ring_of_angle(double cosine) {
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * rings / (3.141592653589793 / 2);
}

// The expected count of each cell if the density is cos / pi: `samples` times the integral of
// cos sin / pi over the cell.
inline std::vector<double> expected_by_cosine() {
    std::vector<double> expected;
    for (int ring = 0; ring < rings; ++ring) {
        const auto within = [](int r) {
            const double sine = std::sin(r * 3.141592653589793 / 2 / rings);
            return sine * sine;
        };
        const double share = within(ring + 1) - within(ring);
        expected.insert(expected.end(), turns, samples * share / turns);
    }
    return expected;
}

// The points of a small rectangle in the unit square become directions in a small patch of the
// sphere. This is the patch's area divided by the rectangle's. The density of directions is 1 over
// it, whichever of the two coordinates sets the angle about the pole, and wherever that angle
// starts. The rectangle around `place` reaches `reach` of the way to the square's edges.
template <class Direction>
double area_ratio(const Direction& direction, Vec2 place, Real reach) {
    const Real h = reach * std::min(place.x, 1 - place.x),
               k = reach * std::min(place.y, 1 - place.y);
    const Vec3 along = direction({place.x + h, place.y}) - direction({place.x - h, place.y});
    const Vec3 other = direction({place.x, place.y + k}) - direction({place.x, place.y - k});
    const double rectangle = static_cast<double>((place.x + h) - (place.x - h)) *
                             static_cast<double>((place.y + k) - (place.y - k));
    const Vec3 patch = Grid::across(along, other);
    return std::sqrt(Grid::dot(patch, patch)) / rectangle;
}

// Any place of the square, or one close to an edge, with a reach and the error that it allows.
struct Spot {
    Vec2 place;
    Real reach;
    double allowed;
};

// How far the area ratio is from the expected one, relative to that. A map of the square may have
// seams, lines on which it is continuous and no more, as the diagonals of the concentric map of
// Shirley and Chiu, and points where they meet. So if the ratio is wrong around a place, it may be
// right on both sides of it instead, and in smaller rectangles.
template <class Direction, class Expected>
double area_error(const Direction& direction, const Expected& expected, const Spot& spot) {
    double least = std::numeric_limits<double>::infinity();
    for (Real reach = spot.reach; reach > spot.reach / 100; reach /= 8) {
        const auto error = [&](Real x, Real y) {
            const Vec2 place{x, y};
            return std::abs(area_ratio(direction, place, reach) / expected(place) - 1);
        };
        const auto [x, y] = spot.place;
        const Real h = 3 * reach * std::min(x, 1 - x), k = 3 * reach * std::min(y, 1 - y);
        least = std::min(least, error(x, y));
        if (least <= spot.allowed) break;
        least = std::min({least, std::max(error(x - h, y), error(x + h, y)),
                          std::max(error(x, y - k), error(x, y + k))});
    }
    return least;
}

// Requires that a small rectangle of sample points becomes a patch of the area that is expected.
template <class Direction, class Expected>
void check_area_ratio(const Direction& direction, const Expected& expected, const Spot& spot,
                      const char* hint) {
    const double error_over_allowed = area_error(direction, expected, spot) / spot.allowed;
    if (!(error_over_allowed <= 1))
        UNSCOPED_INFO("a small square of sample points around ("
                      << text(spot.place.x) << ", " << text(spot.place.y)
                      << ") becomes a patch of the sphere: " EXPECTED
                      << text(static_cast<Real>(expected(spot.place))) << " times as large, " ACTUAL
                      << text(static_cast<Real>(area_ratio(direction, spot.place, spot.reach)))
                      << " times as large.\nHint: " << hint);
    REQUIRE(error_over_allowed <= 1);
}

inline Spot any_spot(rt::Rng& rng, int i) {
    const auto inner = [&] { return rng.uniform(real(0.1), real(0.9)); };
    const auto outer = [&] {
        const Real x = any_size(rng, for_this_precision(-2, -9), -1);
        return rng() & 1 ? x : 1 - x;
    };
    const double coarse = for_this_precision(0.05, 1e-3), fine = for_this_precision(0.02, 1e-8);
    if (i % 4 == 0) return {{inner(), outer()}, for_this_precision(real(0.1), real(1e-3)), coarse};
    if (i % 4 == 1) return {{outer(), inner()}, for_this_precision(real(0.1), real(1e-3)), coarse};
    return {{inner(), inner()}, for_this_precision(real(0.05), real(1e-5)), fine};
}

// Any normal, or an axis or a diagonal, or one close to these.
inline Vec3 any_normal(rt::Rng& rng, int i) {
    const Vec3 any = any_direction(rng);
    if (i % 2) return any;
    const auto sign = [&] { return rng() & 1 ? Real(1) : Real(-1); };
    Vec3 special{sign(), sign(), sign()};
    if (i % 4) {
        const unsigned axis = rng() % 3;
        special = {axis == 0 ? special.x : 0, axis == 1 ? special.y : 0, axis == 2 ? special.z : 0};
    }
    const Vec3 v = special + (rng() % 4 ? any_size(rng, -9, -1) : 0) * any;
    return v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

}  // namespace checkpoint
