#include <rt/rng.hpp>
#include <rt/vec3.hpp>
#include <sstream>

#include "checkpoint.hpp"

using checkpoint::Real;
using rt::Vec3;

TEST_CASE("vectors compute by component", "[vec3]") {
    const Vec3 a{1, 2, 3}, b{4, 6, 8};
    CHECK(-a == Vec3{-1, -2, -3});
    CHECK(a + b == Vec3{5, 8, 11});
    CHECK(b - a == Vec3{3, 4, 5});
    CHECK(a * b == Vec3{4, 12, 24});
    CHECK(a * 2 == Vec3{2, 4, 6});
    CHECK(2 * a == Vec3{2, 4, 6});
    CHECK(b / 2 == Vec3{2, 3, 4});
    Vec3 c = a;
    c += b;
    c -= Vec3{1, 1, 1};
    c *= 3;
    c /= 2;
    CHECK(c == Vec3{6, Real(10.5), 15});
    CHECK(Vec3{} == Vec3{0, 0, 0});
}

TEST_CASE("dividing a vector rounds once", "[vec3]") {
    const Vec3 v{1, 5, 7};
    CHECK(v / 49 == Vec3{Real(1) / 49, Real(5) / 49, Real(7) / 49});
}

TEST_CASE("a vector prints as a person writes it", "[vec3]") {
    std::ostringstream out;
    out << Vec3{1, Real(-2.5), 3};
    CHECK(out.str() == "(1, -2.5, 3)");
}

TEST_CASE("is_finite looks at every component", "[vec3]") {
    CHECK(rt::is_finite(Vec3{1, 2, 3}));
    for (const Real bad : {std::numeric_limits<Real>::quiet_NaN(), rt::infinity, -rt::infinity}) {
        CHECK_FALSE(rt::is_finite(Vec3{bad, 0, 0}));
        CHECK_FALSE(rt::is_finite(Vec3{0, bad, 0}));
        CHECK_FALSE(rt::is_finite(Vec3{0, 0, bad}));
    }
}

TEST_CASE("max_component goes by absolute value", "[vec3]") {
    CHECK(rt::max_component({1, -5, 3}) == 5);
    CHECK(rt::max_component({-1, 0, 0}) == 1);
    CHECK(rt::max_component({}) == 0);
}

TEST_CASE("split_scale is exact at every scale, subnormal numbers too", "[vec3]") {
    using Limits = std::numeric_limits<Real>;
    rt::Rng rng{1, 2};
    for (int e = Limits::min_exponent - Limits::digits; e < Limits::max_exponent; ++e) {
        const auto component = [&] { return std::scalbn(rng.uniform(-1, 1), e + 1); };
        const Vec3 v{component(), component(), component()};
        if (rt::max_component(v) == 0) continue;
        const auto [scaled, exponent] = rt::split_scale(v);
        INFO(checkpoint::text(v));
        CHECK(rt::max_component(scaled) >= 1);
        CHECK(rt::max_component(scaled) < 2);
        CHECK(Vec3{std::scalbn(scaled.x, exponent), std::scalbn(scaled.y, exponent),
                   std::scalbn(scaled.z, exponent)} == v);
    }
}

TEST_CASE("split_scale reaches the largest and the smallest numbers", "[vec3]") {
    using Limits = std::numeric_limits<Real>;
    const auto largest = rt::split_scale({Limits::max(), 0, 0});
    CHECK(largest.v == Vec3{2 - rt::epsilon, 0, 0});
    CHECK(largest.exponent == Limits::max_exponent - 1);
    const auto smallest = rt::split_scale({0, -Limits::denorm_min(), 0});
    CHECK(smallest.v == Vec3{0, -1, 0});
    CHECK(smallest.exponent == Limits::min_exponent - Limits::digits);
}

TEST_CASE("split_scale leaves alone what has no scale", "[vec3]") {
    CHECK(rt::split_scale({0, 0, 0}).v == Vec3{});
    CHECK(rt::split_scale({0, 0, 0}).exponent == 0);
    CHECK(rt::split_scale({rt::infinity, 1, 0}).v == Vec3{rt::infinity, 1, 0});
    CHECK(rt::split_scale({rt::infinity, 1, 0}).exponent == 0);
}
