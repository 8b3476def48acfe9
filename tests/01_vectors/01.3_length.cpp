#include <rt/length.hpp>

#include "checkpoint.hpp"
#include "exact_lengths.hpp"

using namespace checkpoint;

namespace {

// Whether the squares of the components can be added without overflow or underflow.
bool is_ordinary(const exact::Length& row) {
    return 1e-9 < row.length.high && row.length.high < 1e9;
}

// Errors of the sum of three squares: 3 roundings, halved by the root, and the root's own: 2.5
// units.
void check_length(const exact::Length& row) {
    const Vec3 v = vec3(row.v);
    const Real computed = rt::length(v);
    INFO("length(" << text(v) << ")");
    HINT(row.length, computed,
         is_ordinary(row) ? "the length is the square root of v . v"
                          : "v . v overflows or loses digits to underflow here: scale v first by "
                            "split_scale, and scale the result back by std::scalbn");
    REQUIRE(error_in_ulp(computed, row.length) <= 2.5);
}

// The same, and one division more.
void check_normalize(const exact::Length& row) {
    const Vec3 v = vec3(row.v);
    const Vec3 computed = rt::normalize(v);
    INFO("normalize(" << text(v) << ")");
    HINT(row.unit, computed,
         is_ordinary(row) ? "divide each component by the length, once"
                          : "v . v overflows or underflows here: scale v first by split_scale; its "
                            "direction stays the same");
    REQUIRE(error_in_ulp(computed, row.unit) <= 3.5);
}

}  // namespace

TEST_CASE("01.3 the length follows from Pythagoras", "[01.3]") {
    for (const auto& row : exact::lengths())
        if (is_ordinary(row)) check_length(row);
}

TEST_CASE("01.3 normalize keeps the direction and makes the length 1", "[01.3]") {
    for (const auto& row : exact::lengths())
        if (is_ordinary(row)) check_normalize(row);
}

TEST_CASE("01.3 the length of huge and tiny vectors is right", "[01.3][hard]") {
    for (const auto& row : exact::lengths())
        if (!is_ordinary(row)) check_length(row);
}

TEST_CASE("01.3 normalize works on huge and tiny vectors", "[01.3][hard]") {
    for (const auto& row : exact::lengths())
        if (!is_ordinary(row)) check_normalize(row);
}

TEST_CASE("01.3 the smallest and the largest numbers have a length", "[01.3][hard]") {
    const Real smallest = std::numeric_limits<Real>::denorm_min();
    const Real largest = std::numeric_limits<Real>::max();
    for (const Real size : {Real(0), smallest, largest})
        for (const Vec3 v : {Vec3{size, 0, 0}, Vec3{0, size, 0}, Vec3{0, 0, -size}}) {
            const Real computed = rt::length(v);
            INFO("length(" << text(v) << ")");
            HINT(size, computed, "scale v first by split_scale, and scale the result back");
            CHECK((computed == size));
            if (size == 0) continue;
            const Vec3 expected{v.x / size, v.y / size, v.z / size}, unit = rt::normalize(v);
            INFO("normalize(" << text(v) << ")");
            HINT(expected, unit, "scale v first by split_scale; its direction stays the same");
            CHECK((unit == expected));
        }
}

TEST_CASE("01.3 a vector without direction is refused", "[01.3][hard]") {
    INFO(
        "Hint: throw std::domain_error(\"why\") where the vector is zero, infinite or not a "
        "number; "
        "is_finite(v) tells");
    CHECK_THROWS_AS(rt::normalize({0, 0, 0}), std::domain_error);
    CHECK_THROWS_AS(rt::normalize({1, rt::infinity, 0}), std::domain_error);
    CHECK_THROWS_AS(rt::normalize({1, std::numeric_limits<Real>::quiet_NaN(), 0}),
                    std::domain_error);
}
