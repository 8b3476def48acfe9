#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <rt/portable.hpp>
#include <rt/real.hpp>
#include <rt/rng.hpp>
#include <string_view>

#include "checkpoint.hpp"
#include "exact_values.hpp"

using checkpoint::Real;
namespace portable = rt::portable;

namespace {

struct Bits {
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a
    void add(Real number) {
        using Word = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
        hash = (hash ^ std::bit_cast<Word>(number)) * 1099511628211u;
    }
};

// Units in the last place between a result and that of the system's library in double, which is
// within about one of the true number itself.
double units_apart(Real actual, double expected) {
    const auto near = static_cast<Real>(expected);
    const Real next = std::nextafter(near, 2 * near);
    return std::abs((static_cast<double>(actual) - expected) / static_cast<double>(next - near));
}

// Functions of one number leave out the second one.
struct Function {
    std::string_view name;
    double (*portable)(double, double);
    float (*in_float)(float, float);
    double (*library)(double, double);
};
// clang-format off
#define ONE(f) {#f, [](double x, double) { return portable::f(x); }, \
                [](float x, float) { return portable::f(x); }, [](double x, double) { return std::f(x); }}
#define TWO(f) {#f, [](double x, double y) { return portable::f(x, y); }, \
                [](float x, float y) { return portable::f(x, y); }, [](double x, double y) { return std::f(x, y); }}
// clang-format on
constexpr Function functions[] = {ONE(sin),  ONE(cos),   ONE(tan),   ONE(asin),  ONE(acos),
                                  ONE(atan), TWO(atan2), ONE(exp),   ONE(exp2),  TWO(pow),
                                  ONE(cbrt), ONE(log2),  ONE(log10), ONE(log1p), TWO(hypot)};
#undef ONE
#undef TWO

// What the header allows, in units in the last place.
double allowed(std::string_view name, double x, double y) {
    if (name != "pow" || !(x > 0) || !std::isfinite(x) || !std::isfinite(y)) return 5;
    return 5 + std::abs(y * std::log(x)) / 10;
}

constexpr int numbers = 20000;

// Evenly spread from low to high.
void every(Real low, Real high, auto&& visit) {
    for (int i = 0; i < numbers; ++i) visit(low + (high - low) * static_cast<Real>(i) / numbers);
}

// Of all magnitudes.
void every_magnitude(auto&& visit) {
    using Limits = std::numeric_limits<Real>;
    rt::Rng rng{1, 1};
    for (int i = 0; i < numbers; ++i)
        visit(std::ldexp(1 + static_cast<Real>(rng.uniform()),
                         Limits::min_exponent + i % (Limits::max_exponent - Limits::min_exponent)));
}

}  // namespace

TEST_CASE("portable functions are within 4 units of the library's", "[portable]") {
    double worst = 0;
    // clang-format off
#define COMPARE(function)                                                                      \
    [&](Real x) {                                                                              \
        const double expected = std::function(static_cast<double>(x));                         \
        if (std::abs(expected) < 1e-300) return;                                               \
        worst = std::max(worst, units_apart(portable::function(x), expected));                 \
        if (worst > 4) FAIL(#function << " of " << x << ": " << portable::function(x));        \
    }
    // clang-format on
    every(-10, 10, COMPARE(sin));
    every(-10, 10, COMPARE(cos));
    // Far out, that of Windows may be off by more. Volatile: the compiler knows the sine itself.
    const volatile double far_out = 1000000;
    if (std::filesystem::path::preferred_separator == '/' ||
        std::sin(far_out) == -0x1.6664b2568d867p-2)
        every(-1000000, 1000000, COMPARE(sin));
    every(-1, Real(1.5), COMPARE(tan));
    every(-1, 1, COMPARE(asin));
    every(-1, 1, COMPARE(acos));
    every(-5, 5, COMPARE(atan));
    every_magnitude(COMPARE(atan));
    every(-80, 80, COMPARE(exp));
    every(-100, 100, COMPARE(exp2));
    every(Real(-0.9), 10, COMPARE(log1p));
    every_magnitude(COMPARE(log1p));
    every_magnitude(COMPARE(log2));
    every_magnitude(COMPARE(log10));
    every(Real(0.5), 2, COMPARE(log2));
    every_magnitude(COMPARE(cbrt));
#undef COMPARE
    every(0, 1, [&](Real x) {
        for (const Real y : {1 / Real(2.4), Real(2.4), Real(-3)})
            if (x > 0)
                CHECK(units_apart(portable::pow(x, y),
                                  std::pow(static_cast<double>(x), static_cast<double>(y))) <= 4);
    });
    every(-3, 3, [&](Real x) {
        for (const Real y : {Real(-1), Real(0.001), Real(7)}) {
            const auto a = static_cast<double>(x), b = static_cast<double>(y);
            CHECK(units_apart(portable::atan2(y, x), std::atan2(b, a)) <= 4);
            CHECK(units_apart(portable::hypot(x, y), std::hypot(a, b)) <= 4);
        }
    });
}

TEST_CASE("portable functions are right to 5 units where they are farthest off", "[portable]") {
    for (const auto& f : functions) {
        int rows = 0;
        for (const auto& [name, x, y, value] : exact::functions) {
            if (name != f.name) continue;
            ++rows;
            const double actual = f.portable(x, y);
            INFO(name << " of " << x << ", " << y << ": " << actual);
            CHECK(checkpoint::error_in_ulp(actual, value) <= allowed(name, x, y));
        }
        INFO(f.name);
        CHECK(rows > 0);
    }
}

TEST_CASE("portable functions return what their namesakes do for special numbers", "[portable]") {
    using Limits = std::numeric_limits<double>;
    const double special[] = {0,
                              0.5,
                              1,
                              1 + Limits::epsilon(),
                              1 - Limits::epsilon() / 2,
                              2,
                              3,
                              1e308,
                              Limits::max(),
                              Limits::min(),
                              Limits::denorm_min(),
                              Limits::infinity(),
                              Limits::quiet_NaN()};
    const auto is_one_of = [](std::string_view name,
                              std::initializer_list<std::string_view> names) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const auto& f : functions)
        for (const double a : special)
            for (const double b : special)
                for (const int signs : {0, 1, 2, 3}) {
                    const double x = signs & 1 ? -a : a, y = signs & 2 ? -b : b;
                    if (f.name == "pow" && std::signbit(x)) continue;
                    const bool is_angle = is_one_of(f.name, {"sin", "cos", "tan"});
                    if (is_angle && 0x1p20 <= a && std::isfinite(a)) continue;
                    const double expected = f.library(x, y), actual = f.portable(x, y);
                    INFO(f.name << " of " << x << ", " << y << ": " EXPECTED << expected
                                << ", " ACTUAL << actual);
                    bool is_right = std::isnan(expected) ? std::isnan(actual) : actual == expected;
                    if (std::isfinite(expected) && expected != 0)
                        is_right =
                            checkpoint::error_in_ulp(actual, expected) <= allowed(f.name, x, y) + 1;
                    if (expected == 0 && is_one_of(f.name, {"atan2", "atan", "asin", "cbrt"}))
                        is_right = is_right && std::signbit(actual) == std::signbit(expected);
                    REQUIRE(is_right);
                }
}

TEST_CASE("portable functions in float are those in double and then rounded", "[portable]") {
    rt::Rng rng{1, 2};
    const auto any = [&] { return std::ldexp(static_cast<float>(rng.uniform(-1, 1)), rng() % 9); };
    for (const auto& f : functions)
        for (int i = 0; i < 2000; ++i) {
            const float x = f.name == "pow" ? std::abs(any()) : any(), y = any();
            const auto expected =
                static_cast<float>(f.portable(static_cast<double>(x), static_cast<double>(y)));
            const bool same = f.in_float(x, y) == expected || std::isnan(expected);
            INFO(f.name << " of " << x << ", " << y);
            REQUIRE(same);
        }
}

TEST_CASE("portable functions where a result is exact or there is none", "[portable]") {
    const auto nan = std::numeric_limits<Real>::quiet_NaN();
    const Real inf = rt::infinity, zero = 0;
    for (const auto f : {&portable::sin<Real>, &portable::cos<Real>, &portable::tan<Real>}) {
        CHECK(std::isnan(f(inf)));
        CHECK(std::isnan(f(nan)));
    }
    CHECK(portable::exp(zero) == 1);
    CHECK(portable::log2(zero) == -inf);
    CHECK(portable::log1p(Real(-1)) == -inf);
    CHECK(portable::log1p(zero) == 0);
    CHECK(portable::pow(zero, Real(2)) == 0);
    CHECK(portable::pow(zero, Real(-2)) == inf);
    CHECK(portable::pow(zero, zero) == 1);
    CHECK(portable::log10(Real(1000)) == 3);
    CHECK(portable::cbrt(Real(-8)) == -2);
    CHECK(portable::cbrt(zero) == 0);
    CHECK(portable::hypot(std::numeric_limits<Real>::max() / 2, Real(1)) ==
          std::numeric_limits<Real>::max() / 2);
    CHECK(portable::acos(Real(1)) == 0);
    CHECK(portable::asin(Real(1)) == rt::pi / 2);
    using Limits = std::numeric_limits<Real>;
    for (int k = Limits::min_exponent; k < Limits::max_exponent; ++k) {
        const Real power = std::ldexp(Real(1), k);
        CHECK(portable::exp2(static_cast<Real>(k)) == power);
        CHECK(portable::log2(power) == static_cast<Real>(k));
    }
    for (const Real y : {zero, -zero, Real(1), Real(-1), inf, -inf})
        for (const Real x : {zero, -zero, Real(1), Real(-1), inf, -inf}) {
            CHECK(portable::atan2(y, x) == std::atan2(y, x));
            CHECK(std::signbit(portable::atan2(y, x)) == std::signbit(y));
        }
}

TEST_CASE("portable functions have the same bits everywhere", "[portable]") {
    Bits bits;
    for (int i = 0; i < 2000; ++i) {
        const Real x = static_cast<Real>(i) / 777;
        for (const auto f : {&portable::sin<Real>, &portable::cos<Real>, &portable::tan<Real>,
                             &portable::atan<Real>, &portable::exp<Real>, &portable::exp2<Real>,
                             &portable::log1p<Real>, &portable::cbrt<Real>})
            bits.add(f(x));
        for (const auto f : {&portable::log2<Real>, &portable::log10<Real>}) bits.add(f(x + 1));
        for (const auto f : {&portable::asin<Real>, &portable::acos<Real>}) bits.add(f(x / 4));
        for (const auto f : {&portable::atan2<Real>, &portable::pow<Real>, &portable::hypot<Real>})
            bits.add(f(x, Real(2.4)));
    }
    CHECK(bits.hash ==
          checkpoint::for_this_precision<std::uint64_t>(0xfab7160a87f17df9, 0xfa38fb369cba8c0a));
}
