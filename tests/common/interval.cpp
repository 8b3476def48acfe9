#include <rt/interval.hpp>

#include "checkpoint.hpp"

using checkpoint::Real;
using rt::Interval;

TEST_CASE("an interval contains its ends and nothing outside", "[interval]") {
    const Interval i{1, 2};
    CHECK(i.contains(1));
    CHECK(i.contains(2));
    CHECK(i.contains(Real(1.5)));
    CHECK_FALSE(i.contains(std::nextafter(Real(1), Real(0))));
    CHECK_FALSE(i.contains(std::nextafter(Real(2), Real(3))));
    CHECK_FALSE(i.contains(std::numeric_limits<Real>::quiet_NaN()));
}

TEST_CASE("an interval goes from 0 to infinity unless told otherwise", "[interval]") {
    CHECK(Interval{}.contains(0));
    CHECK(Interval{}.contains(rt::infinity));
    CHECK_FALSE(Interval{}.contains(-std::numeric_limits<Real>::denorm_min()));
}

TEST_CASE("an interval is empty when its ends are swapped, not when they are equal", "[interval]") {
    CHECK(Interval{2, 1}.is_empty());
    CHECK(Interval{2, 1}.size() == 0);
    CHECK_FALSE(Interval{1, 1}.is_empty());
    CHECK(Interval{1, 1}.contains(1));
    CHECK(Interval{1, 4}.size() == 3);
}

TEST_CASE("clamp moves a number to the nearest end", "[interval]") {
    CHECK(Interval{1, 2}.clamp(0) == 1);
    CHECK(Interval{1, 2}.clamp(5) == 2);
    CHECK(Interval{1, 2}.clamp(Real(1.5)) == Real(1.5));
}
