#pragma once
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <rt/counted.hpp>
#include <rt/image.hpp>
#include <rt/vec3_type.hpp>
#include <string>
#include <variant>
#include <vector>

namespace rt {

// Colors that stand for what a program computes (given).

// What a pixel shows: nothing, a direction, the number of one of many things, or an amount.
using Shown = std::variant<std::monostate, Vec3, int, Real>;

// The words of --show, and what each stands for.
inline const std::map<std::string, std::string>& shown_words() {
    static const std::map<std::string, std::string> all{
        {"direction", "the ray's direction"},
        {"normal", "the normal"},
        {"distance", "the distance to the first hit"},
        {"sphere", "the spheres"},
        {"bounces", "how often a path bounces, on average over the samples"},
        {"samples", "how far a sample's light is from the pixel's average (standard deviation)"}};
    return all;
}

// The words of --show in a program that only makes rays, in one that also finds what the rays hit,
// and in one that follows paths.
inline std::vector<std::string> shown_of_rays() {
    return {"direction"};
}
inline std::vector<std::string> shown_of_hits() {
    return {"direction", "normal", "distance", "sphere"};
}
inline std::vector<std::string> shown_of_paths() {
    return {"direction", "normal", "distance", "sphere", "bounces", "samples"};
}

inline const Color nothing_color = from_hex(0x46565c);

// The color of a direction of length 1: components from -1 to 1 become channels from 0 to 1.
inline Color direction_color(Vec3 d) {
    return Color{d.x + 1, d.y + 1, d.z + 1} / 2;
}

// The color of the thing with this number. Neighboring numbers get hues that are far apart.
inline Color number_color(int number) {
    // Steps of sqrt(2) turns around the circle of hues never come back to the same hue, because
    // sqrt(2) is irrational. The golden ratio would not do: chapter 06 positions its spheres with
    // it, so neighboring spheres would look alike.
    const double hue = number * 1.4142135623730951;
    const auto channel = [&](double place) {
        const double turn = hue + place;
        return static_cast<Real>(
            std::clamp(std::abs(6 * (turn - std::floor(turn)) - 3) - 1, 0.0, 1.0));
    };
    const Color vivid{channel(0), channel(2 / 3.0), channel(1 / 3.0)};
    const Color mixed_in[] = {{1, 1, 1}, {0, 0, 0}, {Real(0.5), Real(0.5), Real(0.5)}};
    return mix(vivid, mixed_in[number % 3], Real(0.25));
}

// A color from black through violet and orange to white, as x goes from 0 to 1.
inline Color heat_color(Real x) {
    static const Color steps[] = {from_hex(0x07071a), from_hex(0x2b1055), from_hex(0x7b1fa2),
                                  from_hex(0xd6336c), from_hex(0xff7b39), from_hex(0xffd166),
                                  from_hex(0xfffbe6)};
    const Real place = std::clamp(x, Real(0), Real(1)) * 6;
    const int step = std::min(5, static_cast<int>(place));
    return mix(steps[step], steps[step + 1], place - static_cast<Real>(step));
}

// How the amounts are spread: a twentieth of them are below `low`, and a twentieth above `high`.
struct AmountScale {
    Real low = 0, median = 0, high = 0;

    explicit AmountScale(std::vector<Real> amounts) {
        if (amounts.empty()) return;
        std::sort(amounts.begin(), amounts.end());
        const std::size_t last = amounts.size() - 1;
        low = amounts[last / 20];
        median = amounts[last / 2];
        high = amounts[last - last / 20];
    }

    // 0 at low, 1/2 at the median, 1 at high, and linear in between.
    Real place(Real amount) const {
        if (amount < median)
            return std::clamp((amount - low) / (median - low), Real(0), Real(1)) / 2;
        if (amount > median)
            return (1 + std::clamp((amount - median) / (high - median), Real(0), Real(1))) / 2;
        return Real(0.5);
    }
};

// A picture in false colors, and lines of text that explain the colors.
struct FalseColors {
    Image image;
    std::string words;
};

// The pixels are given row by row from the top. `what` says what they show.
inline FalseColors false_colors(int width, int height, const std::vector<Shown>& pixels,
                                const std::string& what) {
    std::vector<Real> amounts;
    std::vector<int> numbers;
    for (const Shown& pixel : pixels) {
        if (const Real* const amount = std::get_if<Real>(&pixel); amount && std::isfinite(*amount))
            amounts.push_back(*amount);
        if (const int* const number = std::get_if<int>(&pixel)) numbers.push_back(*number);
    }
    const AmountScale scale{amounts};
    struct ColorOf {
        const AmountScale& scale;
        Color operator()(std::monostate) const { return nothing_color; }
        Color operator()(Vec3 direction) const { return direction_color(direction); }
        Color operator()(int number) const { return number_color(number); }
        Color operator()(Real amount) const {
            return std::isfinite(amount) ? heat_color(scale.place(amount)) : Color{amount};
        }
    };
    std::size_t next = 0, empty = 0, invalid = 0, directions = 0;
    FalseColors made{Image{width, height}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Shown& pixel = pixels[next++];
            const Color color = std::visit(ColorOf{scale}, pixel);
            // Neither NaN nor infinity reaches an image. Black and white dots stand for them, since
            // any single color might be that of a normal.
            const Color dots = (x + y) % 2 == 0 ? Color{} : Color{1, 1, 1};
            made.image.at(x, y) = is_finite(color) ? color : dots;
            empty += std::holds_alternative<std::monostate>(pixel);
            directions += std::holds_alternative<Vec3>(pixel);
            invalid += !is_finite(color);
        }

    const auto say = [&](const std::string& line) { made.words += "  " + line + '\n'; };
    const auto text = [](Real number) {
        char digits[32];
        std::snprintf(digits, sizeof digits, "%.3g", static_cast<double>(number));
        return std::string{digits};
    };
    if (directions > 0)
        say("red, green and blue are the x, y and z of " + what +
            ": none is -1, half is 0, full is 1");
    if (!amounts.empty())
        say("black is " + text(scale.low) + " or less, red the median, " + text(scale.median) +
            ", white " + text(scale.high) + " or more: " + what);
    if (!numbers.empty()) {
        std::sort(numbers.begin(), numbers.end());
        const auto end = std::unique(numbers.begin(), numbers.end());
        say("a color for each of " + what +
            ", by its number: " + std::to_string(end - numbers.begin()) +
            (end - numbers.begin() == 1 ? " is seen" : " are seen"));
    }
    if (empty > 0) say("gray: nothing but sky");
    if (invalid > 0) say("black and white dots: NaN or infinity, in " + counted(invalid, "pixel"));
    return made;
}

}  // namespace rt
