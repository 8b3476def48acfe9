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

// If the learner's function is not the one that was declared, the linker takes the one that throws.
// Catch2 shows this hint with the exception and nowhere else.
Color gradient_at(const Corners& corners, Real across, Real down) {
    try {
        return rt::gradient(corners, across, down);
    } catch (const rt::NotImplemented&) {
        UNSCOPED_INFO(
            "Hint: if you wrote it, without rt::todo, the linker found no function that is exactly "
            "rt::gradient(const Corners&, Real, Real).\nCompare your function with gradient.hpp: "
            "it must be in namespace rt, and have the same name and every const and &. It must be "
            "neither static (known in its own file only) nor inline");
        throw;
    }
}

void check_exactly(const Corners& corners, Real across, Real down, Color expected_color,
                   const char* hint) {
    const Color color = gradient_at(corners, across, down);
    INFO("across = " << checkpoint::text(across) << ", down = " << checkpoint::text(down)
                     << ".\nHint: " << hint);
    const std::string expected = text(expected_color);
    const std::string actual = color == expected_color ? expected : text(color);
    CHECK(actual == expected);
}

// Four colors that share no component.
constexpr Corners four{{1, 2, 3}, {5, 7, 11}, {13, 17, 19}, {23, 29, 31}};

}  // namespace

TEST_CASE("00.2 at each corner the result is that corner's color", "[00.2]") {
    const char* const hint =
        "across = 0 is the left edge, across = 1 is the right edge, and down = 0 is the top. Mix "
        "by across along the top "
        "edge and along the bottom edge, then mix these two by down";
    check_exactly(four, 0, 0, four.top_left, hint);
    check_exactly(four, 1, 0, four.top_right, hint);
    check_exactly(four, 0, 1, four.bottom_left, hint);
    check_exactly(four, 1, 1, four.bottom_right, hint);
}

TEST_CASE("00.2 halfway between two corners the color is their mean", "[00.2]") {
    const char* const hint = "mix(a, b, t) goes evenly from a to b; note that 1 / 2 is 0 in C++";
    const Real half = Real(0.5);
    check_exactly(four, half, 0, {3, Real(4.5), 7}, hint);
    check_exactly(four, half, 1, {18, 23, 25}, hint);
    check_exactly(four, 0, half, {7, Real(9.5), 11}, hint);
    check_exactly(four, 1, half, {14, 18, 21}, hint);
    check_exactly(four, half, half, {Real(10.5), Real(13.75), 16}, hint);
}

TEST_CASE("00.2 across and down determine the share of each corner's color", "[00.2]") {
    const Corners corners{{0, 0, 0}, {16, 0, 0}, {0, 16, 0}, {0, 0, 16}};
    check_exactly(corners, Real(0.75), Real(0.25), {9, 1, 3},
                  "mix the two upper corners and the two lower corners by across, then mix the "
                  "results by down");
}

TEST_CASE("00.2 the color at a corner is exact whatever the other colors are", "[00.2][hard]") {
    const char* const hint =
        "(1 - t) a + t b is exactly b at t = 1; a + t (b - a) is not, because b - a is rounded";
    const Color sun{Real(1e6), Real(3e6), Real(7e6)}, dark{Real(0.1), Real(0.2), Real(0.7)};
    const Corners corners{sun, dark, dark, sun};
    check_exactly(corners, 1, 0, dark, hint);
    check_exactly(corners, 0, 1, dark, hint);
    check_exactly(corners, 1, 1, sun, hint);
    check_exactly(corners, 0, 0, sun, hint);
}

TEST_CASE("00.2 the color at every point is accurate to the last digits", "[00.2][hard]") {
    rt::Rng rng{1, 1};
    const auto one_in = [&](int n) { return rng.uniform() * static_cast<Real>(n) < 1; };
    // Near either end, at an end, the same number as before, or anywhere.
    const auto place = [&](Real before) {
        if (one_in(4)) return before;
        if (one_in(8)) return Real(one_in(2));
        const int nearness =
            one_in(2) ? 0 : static_cast<int>(rng() % std::numeric_limits<Real>::digits);
        const Real distance = std::scalbn(rng.uniform(), -nearness);
        return one_in(2) ? distance : 1 - distance;
    };
    Real across = 0, down = 0;
    std::string actual, expected, where;  // of the first that is wrong
    for (int i = 0; i < 3000 && where.empty(); ++i) {
        // Light of any strength. Beside it is light that is up to a million million times as
        // strong, or black, or the same.
        const int largest = std::numeric_limits<Real>::max_exponent / 4;
        const int strength = static_cast<int>(rng() % static_cast<unsigned>(2 * largest)) - largest;
        const auto light = [&] {
            const int power = strength + static_cast<int>(rng() % 41) - 20;
            return one_in(20) ? Real(0) : std::scalbn(rng.uniform(), power);
        };
        Color colors[4];
        for (Color& color : colors)
            color = one_in(4) ? colors[rng() % 4] : Color{light(), light(), light()};
        const Corners corners{colors[0], colors[1], colors[2], colors[3]};
        across = place(across);
        down = one_in(8) ? across : place(down);
        const Color color = gradient_at(corners, across, down);
        for (Real Color::*channel : {&Color::r, &Color::g, &Color::b}) {
            const auto exact = [](Real x) { return Exact(static_cast<double>(x)); };
            const auto mixed = [&](Exact from, Exact to, Real t) {
                return (Exact(1) - exact(t)) * from + exact(t) * to;
            };
            const Exact sum =
                mixed(mixed(exact(colors[0].*channel), exact(colors[1].*channel), across),
                      mixed(exact(colors[2].*channel), exact(colors[3].*channel), across), down);
            // Each corner's color is rounded eight times on its way. No term is negative, so the
            // bound is relative to the sum. Each mix may add the smallest number that exists.
            const double error = std::abs((exact(color.*channel) - sum).high);
            const double smallest = double(std::numeric_limits<Real>::denorm_min());
            if (error <= static_cast<double>(rt::rounding_bound(8)) * sum.high + 4 * smallest)
                continue;
            where = "a color channel at across = " + checkpoint::text(across) +
                    ", down = " + checkpoint::text(down) +
                    "; in the four corners, the channel is " +
                    checkpoint::text(colors[0].*channel) + " and " +
                    checkpoint::text(colors[1].*channel) + " above, " +
                    checkpoint::text(colors[2].*channel) + " and " +
                    checkpoint::text(colors[3].*channel) + " below";
            actual = checkpoint::text(color.*channel);
            expected = checkpoint::text(sum);
            break;
        }
    }
    INFO(
        where
        << ".\nHint: mix three times, along the top, along the bottom, and then these two results, "
           "each time as (1 - t) a + t b. Use Real for each number: a float has only 7 digits");
    CHECK(actual == expected);
}
