#include <rt/gradient.hpp>
#include <rt/rng.hpp>
#include <rt/todo.hpp>

#include "checkpoint.hpp"

using namespace checkpoint;
using rt::Color, rt::Corners;

namespace {

std::string text(Color c) {
    return '(' + checkpoint::text(c.r) + ", " + checkpoint::text(c.g) + ", " +
           checkpoint::text(c.b) + ')';
}

// Where the learner's function is not the one that was declared, the linker takes the one that
// throws. Catch2 shows this beside the exception, and nowhere else.
Color gradient_at(const Corners& corners, Real across, Real down) {
    try {
        return rt::gradient(corners, across, down);
    } catch (const rt::NotImplemented&) {
        UNSCOPED_INFO(
            "Hint: if you wrote it, without rt::todo, the linker found no function that is exactly "
            "rt::gradient(const Corners&, Real, Real).\nCompare yours with gradient.hpp: is it in "
            "namespace rt, is the name the same, is each const and & there, and is it neither "
            "static (known in its own file only) nor inline?");
        throw;
    }
}

void check_exactly(const Corners& corners, Real across, Real down, Color expected,
                   const char* hint) {
    const Color color = gradient_at(corners, across, down);
    INFO("across = " << checkpoint::text(across) << ", down = " << checkpoint::text(down)
                     << ": expected " << text(expected) << ", but yours gives " << text(color)
                     << ".\nHint: " << hint);
    const bool as_expected = color == expected;
    CHECK(as_expected);  // the colors themselves are above, with all their digits
}

// Four colors that share no component.
constexpr Corners four{{1, 2, 3}, {5, 7, 11}, {13, 17, 19}, {23, 29, 31}};

}  // namespace

TEST_CASE("00.1 each corner has its own color", "[00.1]") {
    const char* const hint =
        "across = 0 is left and 1 is right, down = 0 is the top. Across mixes along a row, the "
        "top one and the bottom one; down mixes these two";
    check_exactly(four, 0, 0, four.top_left, hint);
    check_exactly(four, 1, 0, four.top_right, hint);
    check_exactly(four, 0, 1, four.bottom_left, hint);
    check_exactly(four, 1, 1, four.bottom_right, hint);
}

TEST_CASE("00.1 halfway is the mean of both ends", "[00.1]") {
    const char* const hint = "mix(a, b, t) goes evenly from a to b; 1 / 2 is 0 in C++";
    const Real half = Real(0.5);
    check_exactly(four, half, 0, {3, Real(4.5), 7}, hint);
    check_exactly(four, half, 1, {18, 23, 25}, hint);
    check_exactly(four, 0, half, {7, Real(9.5), 11}, hint);
    check_exactly(four, 1, half, {14, 18, 21}, hint);
    check_exactly(four, half, half, {Real(10.5), Real(13.75), 16}, hint);
}

TEST_CASE("00.1 a quarter of the way down is a quarter of the way", "[00.1]") {
    const Corners corners{{0, 0, 0}, {16, 0, 0}, {0, 16, 0}, {0, 0, 16}};
    check_exactly(corners, Real(0.75), Real(0.25), {9, 1, 3},
                  "mix above and below by across, then those two by down");
}

TEST_CASE("00.1 the ends are exact whatever is on the other side", "[00.1][hard]") {
    const char* const hint =
        "(1 - t) a + t b is exactly b at t = 1; a + t (b - a) is not, since b - a was rounded";
    const Color sun{Real(1e6), Real(3e6), Real(7e6)}, dark{Real(0.1), Real(0.2), Real(0.7)};
    const Corners corners{sun, dark, dark, sun};
    check_exactly(corners, 1, 0, dark, hint);
    check_exactly(corners, 0, 1, dark, hint);
    check_exactly(corners, 1, 1, sun, hint);
    check_exactly(corners, 0, 0, sun, hint);
}

TEST_CASE("00.1 every place is right to the last digits", "[00.1][hard]") {
    // Two mixes, each with three roundings on the way of any corner (1 - t, the product, the sum).
    // No term is negative, so the bound holds relative to the sum.
    rt::Rng rng{1, 1};
    for (int i = 0; i < 1000; ++i) {
        const auto light = [&] { return std::scalbn(rng.uniform(), i % 40 - 20); };
        const Real a = light(), b = light(), c = light(), d = light();
        const Real across = rng.uniform(), down = rng.uniform();
        const Real got = gradient_at({{a, 0, 0}, {b, 0, 0}, {c, 0, 0}, {d, 0, 0}}, across, down).r;
        const auto exact = [](Real x) { return Exact(static_cast<double>(x)); };
        const auto mixed = [&](Exact from, Exact to, Real t) {
            return (Exact(1) - exact(t)) * from + exact(t) * to;
        };
        const Exact expected =
            mixed(mixed(exact(a), exact(b), across), mixed(exact(c), exact(d), across), down);
        const double error = std::abs((exact(got) - expected).high);
        const double allowed = static_cast<double>(rt::rounding_bound(6)) * expected.high;
        char digits[80];
        std::snprintf(digits, sizeof digits, "off by %.1e, allowed is %.1e", error, allowed);
        INFO(digits);
        HINT(expected, got,
             "mix three times: top, bottom, and those two. And is each number a Real? A float has "
             "7 digits only");
        const bool close = error <= allowed;  // Catch2 shows small numbers as 0.0
        REQUIRE(close);
    }
}
