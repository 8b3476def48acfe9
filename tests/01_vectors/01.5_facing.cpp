#include <rt/facing.hpp>

#include "checkpoint.hpp"
#include "random_inputs.hpp"

using namespace checkpoint;

namespace {

Vec3 scaled(Vec3 v, int exponent) {
    return {std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)};
}

// Checks for the exact sign, with the normal and its opposite. Within the rounding of edge-on, any
// answer is right.
void check_side(Vec3 normal, Vec3 to_viewer, int exponent, int other_exponent) {
    const ExactVec3 a = exact_vector(normal), b = exact_vector(to_viewer);
    const double product = dot(a, b).high;
    if (std::abs(product) <= static_cast<double>(rt::rounding_bound(3)) * size_of_terms(a, b))
        return;
    const int side = product > 0 ? 1 : -1;
    const Vec3 n = scaled(normal, exponent), v = scaled(to_viewer, other_exponent);
    INFO("facing(" << text(n) << ", " << text(v) << "), which are "
                   << std::acos(std::clamp(product / exact_length(a).high / exact_length(b).high,
                                           -1.0, 1.0)) *
                          180 / 3.14159265358979
                   << " degrees apart.\nHint: even an angle this close to 90 degrees is not "
                      "edge-on, however short or long the vectors are: scale them with "
                      "split_scale, and then let only the sign decide");
    const int computed = rt::facing(n, v), from_behind = rt::facing(-n, v);
    REQUIRE(computed == side);
    REQUIRE(from_behind == -side);
}

}  // namespace

TEST_CASE("01.5 facing returns the sign of the cosine", "[01.5]") {
    const Vec3 normal{0, 1, 0};
    for (const auto& [to_viewer, expected] : {std::pair{Vec3{real(0.5), 1, 0}, 1},
                                              {Vec3{5, real(-0.25), 3}, -1},
                                              {Vec3{1, 0, -2}, 0}}) {
        const int side = rt::facing(normal, to_viewer);
        INFO("facing(" << text(normal) << ", " << text(to_viewer) << "): " EXPECTED << expected
                       << ", " ACTUAL << side << ".\nHint: the dot product, " << text(to_viewer.y)
                       << ", is positive for angles below 90 degrees and negative above");
        CHECK(side == expected);
    }
}

TEST_CASE("01.5 the lengths of the vectors do not matter", "[01.5]") {
    INFO("Hint: compare the dot product with 0, not with 1");
    CHECK(rt::facing({0, 0, 20}, {0, 3, 100}) == 1);
    CHECK(rt::facing({0, 0, real(0.125)}, {0, 3, real(-0.5)}) == -1);
    CHECK(rt::facing({1, 2, 3}, {3, 0, -1}) == 0);
}

TEST_CASE("01.5 facing is correct for any two directions", "[01.5]") {
    rt::Rng rng{4, 1};
    for (int i = 0; i < 2000; ++i) check_side(any_vector(rng, -2, 2), any_vector(rng, -2, 2), 0, 0);
}

TEST_CASE("01.5 a vector that is nearly edge-on does not count as edge-on", "[01.5][hard]") {
    rt::Rng rng{4, 2};
    for (int i = 0; i < 4000; ++i) {
        const Vec3 a = any_vector(rng, -1, 1), b = any_vector(rng, -1, 1);
        const Real tilt = 1 + any_number(rng, -16, -1);
        if (a.z != 0) check_side(a, {b.x, b.y, -tilt * (a.x * b.x + a.y * b.y) / a.z}, 0, 0);
    }
}

TEST_CASE("01.5 facing returns 0 for edge-on vectors of any length", "[01.5][hard]") {
    INFO("Hint: scaling by a power of two, as split_scale does, loses no digit of these vectors");
    rt::Rng rng{4, 3};
    const auto whole = [&] { return std::floor(rng.uniform(-9, 10)); };
    for (int i = 0; i < 500; ++i) {
        const Vec3 a{whole(), whole(), whole()}, b{whole(), whole(), whole()};
        const Vec3 edge_on{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
        const int far = for_this_precision(100, 900);
        const Vec3 n = scaled(a, far / 2 - static_cast<int>(rng() % static_cast<unsigned>(far)));
        INFO("facing(" << text(n) << ", " << text(edge_on) << ")");
        REQUIRE(rt::facing(n, edge_on) == 0);
        REQUIRE(rt::facing(edge_on, n) == 0);
    }
}

TEST_CASE("01.5 facing is correct for tiny and huge vectors", "[01.5][hard]") {
    constexpr int digits = std::numeric_limits<Real>::digits,
                  lowest = std::numeric_limits<Real>::min_exponent - digits,
                  highest = std::numeric_limits<Real>::max_exponent - 1;
    rt::Rng rng{4, 4};
    const auto exponent = [&] {
        if (rng() % 4 == 0) return highest;
        return lowest + digits + 4 + static_cast<int>(rng() % (highest - lowest - digits - 4));
    };
    const auto whole = [&] { return std::floor(rng.uniform(-9, 10)); };
    for (int i = 0; i < 3000; ++i) {
        const Vec3 a = any_vector(rng, -1, 0), b = any_vector(rng, -1, 0);
        const Vec3 smallest{whole(), whole(), whole()};
        check_side(a, b, exponent(), exponent());
        // Multiples of the smallest number.
        check_side(a, smallest, exponent(), lowest);
        check_side(smallest, a, lowest, exponent());
        // Components so different that the smaller ones vanish beside the larger ones.
        const Real apart = for_this_precision<Real>(15, 60);
        check_side(any_vector(rng, -apart, apart), any_vector(rng, -apart, apart), 0, 0);
    }
}

TEST_CASE("01.5 even angles extremely close to 90 degrees do not count as edge-on",
          "[01.5][hard]") {
    INFO("Hint: use the sign of the dot product, because the angle itself is rounded");
    // The two vectors share one component, which is small: the cosine is its square.
    const int smallest = for_this_precision(-60, -500), far = for_this_precision(60, 500);
    for (int power = -1; power >= smallest; --power)
        for (const int size : {-far, 0, far}) {
            const Real little = std::scalbn(Real(1), power);
            const Vec3 n = scaled({1, 0, little}, size), v = scaled({0, -1, little}, -size / 2);
            INFO("facing(" << text(n) << ", " << text(v) << ")");
            REQUIRE(rt::facing(n, v) == 1);
            REQUIRE(rt::facing(v, -n) == -1);
        }
}

TEST_CASE("01.5 facing returns 0 for a zero vector", "[01.5][hard]") {
    const Real huge = std::numeric_limits<Real>::max();
    for (const Real zero : {Real(0), Real(-0.0)})
        for (const Vec3 other : {Vec3{1, 2, 3}, Vec3{-huge, huge, huge}, Vec3{0, 0, 0}}) {
            INFO("a zero vector and " << text(other));
            CHECK(rt::facing({zero, zero, zero}, other) == 0);
            CHECK(rt::facing(other, {zero, zero, zero}) == 0);
        }
}
