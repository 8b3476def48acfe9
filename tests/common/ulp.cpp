#include <study/ulp.hpp>

#include "checkpoint.hpp"

using checkpoint::Real;
using study::DoubleDouble;
using study::error_in_ulp;
using study::ulp;
using Limits = std::numeric_limits<Real>;

namespace {

constexpr double epsilon = static_cast<double>(rt::epsilon);

}  // namespace

TEST_CASE("a unit in the last place is the distance to the next number", "[ulp]") {
    CHECK(ulp(Real(1)) == rt::epsilon);
    CHECK(ulp(Real(-1)) == rt::epsilon);
    CHECK(ulp(Real(1.75)) == rt::epsilon);
    CHECK(ulp(Real(2)) == 2 * rt::epsilon);
    CHECK(ulp(std::nextafter(Real(1), Real(0))) == rt::epsilon / 2);
}

TEST_CASE("the ends of the numbers have a unit, too", "[ulp]") {
    CHECK(ulp(Real(0)) == Limits::denorm_min());
    CHECK(ulp(Limits::denorm_min()) == Limits::denorm_min());
    CHECK(ulp(Limits::min()) == Limits::denorm_min());
    CHECK(ulp(Limits::max()) == Limits::max() - std::nextafter(Limits::max(), Real(0)));
    CHECK(ulp(rt::infinity) == ulp(Limits::max()));
}

TEST_CASE("an error counts in units of the exact value", "[ulp]") {
    CHECK(error_in_ulp(Real(1), DoubleDouble{1}) == 0);
    CHECK(error_in_ulp(1 + rt::epsilon, DoubleDouble{1}) == 1);
    CHECK(error_in_ulp(1 - rt::epsilon, DoubleDouble{1}) == 1);
    CHECK(error_in_ulp(Real(1), DoubleDouble{1, epsilon / 2}) == 0.5);
    CHECK(error_in_ulp(Real(1), DoubleDouble{1, -epsilon * 0x1p-20}) == 0x1p-20);
    CHECK(error_in_ulp(Real(-2), DoubleDouble{-2, 5 * epsilon}) == 2.5);
    CHECK(error_in_ulp(3 * Limits::denorm_min(), DoubleDouble{0}) == 3);
}

TEST_CASE("what is not finite is infinitely wrong", "[ulp]") {
    CHECK(std::isinf(error_in_ulp(rt::infinity, DoubleDouble{1})));
    CHECK(std::isinf(error_in_ulp(Limits::quiet_NaN(), DoubleDouble{1})));
}

TEST_CASE("an exact value beyond the largest number has an error, not none", "[ulp]") {
    if (sizeof(Real) < sizeof(double)) CHECK(error_in_ulp(Limits::max(), DoubleDouble{1e39}) > 1e6);
}
