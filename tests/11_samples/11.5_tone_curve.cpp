#include <rt/rng.hpp>
#include <rt/tone_curve.hpp>
#include <string>

#include "checkpoint.hpp"
#include "single_precision.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Color;

namespace {

using Wide = long double;

constexpr Wide wide(Real x) {
    return static_cast<Wide>(x);
}

struct WideColor {
    Wide r, g, b;
};

WideColor wide(const Color& c) {
    return {wide(c.r), wide(c.g), wide(c.b)};
}
WideColor operator*(WideColor c, Wide s) {
    return {c.r * s, c.g * s, c.b * s};
}

Wide expected_luminance(const Color& c) {
    return 0.2126L * wide(c.r) + 0.7152L * wide(c.g) + 0.0722L * wide(c.b);
}

// Divides before it multiplies: a long double may be no wider than a double.
Wide expected_curve(Wide luminance, Wide white) {
    const Wide pressed = luminance / (1 + luminance);
    return pressed + pressed / white * (luminance / white);
}

std::string text(const Color& c) {
    return "rgb(" + checkpoint::text(c.r) + ", " + checkpoint::text(c.g) + ", " +
           checkpoint::text(c.b) + ')';
}
std::string text(const WideColor& c) {
    return text(Color{static_cast<Real>(c.r), static_cast<Real>(c.g), static_cast<Real>(c.b)});
}

// Equal within this many roundings.
bool is_near(Real actual, Wide expected, int roundings) {
    return std::abs(wide(actual) - expected) <=
           wide(rt::rounding_bound(roundings)) * std::abs(expected);
}
bool is_near(const Color& actual, const WideColor& expected, int roundings) {
    return is_near(actual.r, expected.r, roundings) && is_near(actual.g, expected.g, roundings) &&
           is_near(actual.b, expected.b, roundings);
}

bool is_single(const Color& actual, const WideColor& expected) {
    return only_single_precision(wide(actual.r), expected.r) ||
           only_single_precision(wide(actual.g), expected.g) ||
           only_single_precision(wide(actual.b), expected.b);
}

void check_exposed(const Color& color, Real stops) {
    const Color actual = rt::exposed(color, stops);
    const WideColor expected = wide(color) * std::exp2(wide(stops));
    // A power by exp(stops log 2) has this much error.
    const bool is_right = is_near(actual, expected, 8 + static_cast<int>(2 * std::abs(stops)));
    if (!is_right) {
        INFO("exposed(" << text(color) << ", " << checkpoint::text(stops) << "): " EXPECTED
                        << text(expected) << ", " ACTUAL << text(actual));
        const char* hint =
            "multiply the light by 2 to the power of the stops: 3 stops are a factor of 8, -1 stop "
            "is one half, and 0 stops change nothing. std::exp2 takes fractions, too";
        if (is_single(actual, expected)) hint = single_precision_hint;
        INFO("Hint: " << hint);
        REQUIRE(text(actual) == text(expected));
    }
    CHECK(is_right);
}

void check_luminance(const Color& color) {
    const Real actual = rt::luminance(color);
    const Wide expected = expected_luminance(color);
    const bool is_right = is_near(actual, expected, 12);
    if (!is_right) {
        INFO("luminance(" << text(color) << "): " EXPECTED
                          << checkpoint::text(static_cast<Real>(expected)) << ", " ACTUAL
                          << checkpoint::text(actual));
        const char* hint =
            "the luminance is 0.2126 r + 0.7152 g + 0.0722 b; the light is already linear, "
            "and has no upper limit";
        if (only_single_precision(wide(actual), expected)) hint = single_precision_hint;
        INFO("Hint: " << hint);
        REQUIRE(checkpoint::text(actual) == checkpoint::text(static_cast<Real>(expected)));
    }
    CHECK(is_right);
}

// Where the core allows it: some digits may have been lost in a difference.
constexpr int few_digits = 4000;

void check_curve(Real luminance, Real white, int roundings = 16) {
    const Real actual = rt::tone_curve(luminance, white);
    const Wide expected = expected_curve(wide(luminance), wide(white));
    const bool is_right = is_near(actual, expected, roundings);
    if (!is_right) {
        INFO("tone_curve(" << checkpoint::text(luminance) << ", white " << checkpoint::text(white)
                           << "): " EXPECTED << checkpoint::text(static_cast<Real>(expected))
                           << ", " ACTUAL << checkpoint::text(actual));
        const char* hint =
            "the two factors are L / (1 + L) and 1 + L / white^2; a luminance of `white` becomes 1";
        if (only_single_precision(wide(actual), expected))
            hint = single_precision_hint;
        else if (!std::isfinite(actual) || actual == 0 || luminance >= 1000000 ||
                 is_near(actual, expected, few_digits))
            hint =
                "an intermediate result, such as luminance * luminance or white * white, is too "
                "large or too small for a Real, or loses all digits: divide before you multiply, "
                "and start with L / (1 + L)";
        else if (is_near(actual, wide(luminance) / (1 + wide(luminance)), few_digits))
            hint =
                "this is L / (1 + L), which never becomes white: the factor 1 + L / white^2 is "
                "missing";
        INFO("Hint: " << hint);
        REQUIRE(checkpoint::text(actual) == checkpoint::text(static_cast<Real>(expected)));
    }
    CHECK(is_right);
}

void check_mapped(const Color& color, Real white, int roundings = 40) {
    const Color actual = rt::tone_mapped(color, white);
    const Wide luminance = expected_luminance(color);
    const WideColor expected =
        luminance > 0 ? wide(color) * (expected_curve(luminance, wide(white)) / luminance)
                      : WideColor{};
    const bool is_right = is_near(actual, expected, roundings);
    if (!is_right) {
        INFO("tone_mapped(" << text(color) << ", white " << checkpoint::text(white)
                            << "): " EXPECTED << text(expected) << ", " ACTUAL << text(actual));
        const char* hint =
            "multiply the whole color by one factor, tone_curve of its luminance divided by its "
            "luminance; the result then has the luminance that the curve gives";
        if (luminance == 0)
            hint = "the luminance of black is 0, and 0 / 0 is NaN: black stays black";
        else if (is_single(actual, expected))
            hint = single_precision_hint;
        else if (is_near(actual, wide(color), 1))
            hint =
                "your result is the unchanged color. The curve applies to light of any size: light "
                "is "
                "dark or bright only compared with `white`, and only 0 is black";
        else if (is_near(actual.r, expected_curve(wide(color.r), wide(white)), few_digits) &&
                 is_near(actual.g, expected_curve(wide(color.g), wide(white)), few_digits))
            hint = "you applied the curve to each channel separately, which changes the hue";
        INFO("Hint: " << hint);
        REQUIRE(text(actual) == text(expected));
    }
    CHECK(is_right);
}

Color any_color(rt::Rng& rng) {
    return {rng.uniform(), rng.uniform(), rng.uniform()};
}

}  // namespace

TEST_CASE("11.5 each stop doubles the light", "[11.5]") {
    const Color color{real(0.1), real(0.5), real(2)};
    for (const Real stops : {0, 1, 2, 3, 10, -1, -2, -7}) check_exposed(color, stops);
    for (const double stops : {0.5, -0.5, 1.25, -3.75}) check_exposed(color, real(stops));
    rt::Rng rng{115, 1};
    for (int i = 0; i < 200; ++i) check_exposed(any_color(rng), rng.uniform(-10, 10));
}

TEST_CASE("11.5 the luminance has the weights given in the text", "[11.5]") {
    check_luminance({1, 0, 0});
    check_luminance({0, 1, 0});
    check_luminance({0, 0, 1});
    check_luminance({1, 1, 1});
    check_luminance({0, 0, 0});
    rt::Rng rng{115, 2};
    for (int i = 0; i < 200; ++i) check_luminance(any_color(rng) * any_size(rng, -3, 3));
}

TEST_CASE("11.5 the curve keeps dark tones and maps white to 1", "[11.5]") {
    for (const double white : {0.5, 1.0, 1.5, 4.0, 100.0}) {
        check_curve(0, real(white), few_digits);
        check_curve(real(white), real(white), few_digits);
        for (const double luminance : {0.001, 0.18, 0.5, 1.0, 2.0, 3.0, 17.0, 250.0})
            check_curve(real(luminance), real(white), few_digits);
    }
    rt::Rng rng{115, 3};
    for (int i = 0; i < 500; ++i)
        check_curve(any_size(rng, -3, 3), any_size(rng, -1, 2), few_digits);
}

TEST_CASE("11.5 a color keeps its hue", "[11.5]") {
    check_mapped({1, 1, 1}, 4, few_digits);
    check_mapped({4, 4, 4}, 4, few_digits);
    check_mapped({real(0.8), real(0.4), real(0.2)}, 3, few_digits);
    check_mapped({real(20), real(5), real(0.1)}, 4, few_digits);
    check_mapped({real(0.1), 0, 3}, 2, few_digits);
    rt::Rng rng{115, 4};
    for (int i = 0; i < 500; ++i)
        check_mapped(any_color(rng) * any_size(rng, -1, 3), any_size(rng, -1, 2), few_digits);
}

TEST_CASE("11.5 black stays black", "[11.5][hard]") {
    for (const Real white : {Real(0.5), Real(1), Real(4), rt::infinity}) {
        check_mapped({0, 0, 0}, white);
        check_mapped({-Real(0), Real(0), -Real(0)}, white);
    }
    for (const Real stops : {-100, -1, 0, 1, 100}) check_exposed({0, 0, 0}, stops);
}

TEST_CASE("11.5 exposure is correct for a hundred stops up and down", "[11.5]") {
    for (const Real stops : {-100, -64, -40, -31, 31, 32, 40, 63, 64, 100})
        check_exposed({1, real(0.5), real(0.001)}, stops);
}

TEST_CASE("11.5 extremely bright and extremely dark light is mapped accurately", "[11.5][hard]") {
    const auto huge = real(for_this_precision(1e30, 1e200));
    const auto bright = real(for_this_precision(1e20, 1e160));
    for (const Real light : {huge, bright, real(1e10), real(1e-10), 1 / bright, 1 / huge}) {
        check_luminance({light, light, light});
        for (const Real white : {real(1), real(4), real(1e10), bright, huge}) {
            check_curve(light, white);
            check_mapped({light, light, light}, white);
            check_mapped({light, light / 4, 0}, white);
            check_mapped({0, 0, light}, white);
        }
    }
    rt::Rng rng{115, 5};
    const Real power = for_this_precision(30, 200);
    for (int i = 0; i < 500; ++i) {
        const Real light = any_size(rng, -power, power), white = any_size(rng, -1, power);
        check_curve(light, white);
        check_mapped(any_color(rng) * light, white);
    }
}

TEST_CASE("11.5 with an infinite white the curve is L / (1 + L)", "[11.5][hard]") {
    rt::Rng rng{115, 6};
    for (int i = 0; i < 200; ++i) {
        const Real light = any_size(rng, -3, 10);
        check_curve(light, rt::infinity);
        check_mapped(any_color(rng) * light, rt::infinity);
    }
}

TEST_CASE("11.5 a dark picture with an equally dark white is mapped accurately", "[11.5][hard]") {
    // Where 1 + luminance is 1, the curve is L + (L / white)^2.
    const auto tiny = real(for_this_precision(1e-25, 1e-170));
    for (const Real white : {real(0.001), real(1e-9), real(1e-17), tiny})
        for (const double part : {0.125, 0.5, 1.0, 3.0, 20.0}) {
            const Real light = white * real(part);
            check_curve(light, white);
            check_mapped({light, light, light}, white);
            check_mapped({light, light / 4, 0}, white);
        }
}
