#include <cstdint>
#include <limits>
#include <rt/denoise.hpp>
#include <rt/rng.hpp>
#include <string>

#include "checkpoint.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Canvas, rt::Color, rt::DenoiseWidths, rt::Features, rt::Image;

namespace {

using Wide = long double;

constexpr Wide wide(Real x) {
    return static_cast<Wide>(x);
}

std::string text(const Color& c) {
    return "rgb(" + checkpoint::text(c.r) + ", " + checkpoint::text(c.g) + ", " +
           checkpoint::text(c.b) + ')';
}

Wide squared(Wide x) {
    return x * x;
}

// The squares of three distances, each divided by its width.
struct Distances {
    Wide space, albedo, normal;
    Wide sum() const { return space + albedo + normal; }
};

Distances distances(int across, int down, const Features& a, const Features& b,
                    const DenoiseWidths& widths) {
    const auto square = [](Real p, Real q, Real width) {
        return squared((wide(p) - wide(q)) / wide(width));
    };
    return {squared(across / wide(widths.space)) + squared(down / wide(widths.space)),
            square(a.albedo.r, b.albedo.r, widths.albedo) +
                square(a.albedo.g, b.albedo.g, widths.albedo) +
                square(a.albedo.b, b.albedo.b, widths.albedo),
            square(a.normal.x, b.normal.x, widths.normal) +
                square(a.normal.y, b.normal.y, widths.normal) +
                square(a.normal.z, b.normal.z, widths.normal)};
}

Color floored(const Color& albedo, Real darkest) {
    return {std::max(albedo.r, darkest), std::max(albedo.g, darkest), std::max(albedo.b, darkest)};
}

const char* const weight_hint =
    "the weight is exp(-d / 2), where d is the sum of (distance / width)^2 for three distances: "
    "across and down, the albedo with its three channels, the normal with x, y and z";

void check_weight(int across, int down, const Features& a, const Features& b,
                  const DenoiseWidths& widths, const char* hint = weight_hint) {
    const Real actual = rt::bilateral_weight(across, down, a, b, widths);
    const Distances d = distances(across, down, a, b, widths);
    const auto is = [&](Wide exponent) {
        const Wide expected = std::exp(-exponent);
        // An error of the exponent grows with its size.
        const int roundings = 20 + static_cast<int>(std::min<Wide>(10 * exponent, 1e5L));
        return std::abs(wide(actual) - expected) <= wide(rt::rounding_bound(roundings)) * expected +
                                                        wide(std::numeric_limits<Real>::min());
    };
    const bool is_right = is(d.sum() / 2);
    if (!is_right) {
        const Features floored_a{floored(a.albedo, widths.darkest), a.normal};
        const Features floored_b{floored(b.albedo, widths.darkest), b.normal};
        if (!(actual >= 0))
            hint =
                "your result is NaN, from 0 / 0 or infinity - infinity: divide each difference by "
                "its width first, and then square the quotient; the square of a small width is 0";
        else if (is(d.sum()))
            hint = "the factor of a half is missing: the weight is exp(-d / 2)";
        else if (hint == weight_hint && is((d.albedo + d.normal) / 2))
            hint = "in your result, the distance across and down does not count";
        else if (hint == weight_hint && is((d.space + d.normal) / 2))
            hint = "in your result, the albedo does not count";
        else if (hint == weight_hint && is((d.space + d.albedo) / 2))
            hint = "in your result, the normal does not count";
        else if (is(distances(across, down, floored_a, floored_b, widths).sum() / 2))
            hint =
                "the weights use the unchanged albedo, even where it is less than widths.darkest";
        const Real expected = static_cast<Real>(std::exp(-d.sum() / 2));
        INFO("the weight of a pixel "
             << across << " across and " << down
             << " down, squares of the distances in widths: position " << static_cast<Real>(d.space)
             << ", albedo " << static_cast<Real>(d.albedo) << ", normal "
             << static_cast<Real>(d.normal) << ". Expected " << checkpoint::text(expected)
             << ", " ACTUAL << checkpoint::text(actual));
        INFO("Hint: " << hint);
        REQUIRE(checkpoint::text(actual) == checkpoint::text(expected));
    }
    CHECK(is_right);
}

// A picture and what is known of its pixels.
struct Scene {
    Image picture;
    Canvas<Features> features;

    Scene(int width, int height, const Features& surface = {{1, 1, 1}, {0, 1, 0}})
        : picture(width, height), features(width, height, surface) {}
    int width() const { return picture.width(); }
    int height() const { return picture.height(); }
};

// What the result may be by mistake.
enum class Slip {
    none,
    in_place,
    not_normalized,
    narrow,
    broad,
    albedo_stays,
    albedo_lost,
    no_darkest,
    circle,
    floored_weight
};

// Without the weights that are less than `least_weight`.
Image reference(const Scene& scene, const DenoiseWidths& widths, Slip slip, Wide least_weight = 0) {
    const auto radius =
        std::int64_t{widths.radius} + (slip == Slip::broad) - (slip == Slip::narrow);
    const Wide darkest = slip == Slip::no_darkest ? 0 : wide(widths.darkest);
    Image result(scene.width(), scene.height());
    Image source = scene.picture;
    for (int y = 0; y < scene.height(); ++y)
        for (int x = 0; x < scene.width(); ++x) {
            const auto features = [&](int i, int j) {
                const Features& f = scene.features.at(i, j);
                return slip == Slip::floored_weight
                           ? Features{floored(f.albedo, widths.darkest), f.normal}
                           : f;
            };
            const Features a = features(x, y);
            Wide sum[3] = {}, weights = 0;
            for (int j = 0; j < scene.height(); ++j)
                for (int i = 0; i < scene.width(); ++i) {
                    if (std::abs(i - x) > radius || std::abs(j - y) > radius) continue;
                    if (slip == Slip::circle &&
                        (i - x) * (i - x) + (j - y) * (j - y) > radius * radius)
                        continue;
                    const Features b = features(i, j);
                    const Wide weight = std::exp(-distances(i - x, j - y, a, b, widths).sum() / 2);
                    if (weight < least_weight) continue;
                    const auto light = [&](Real color, Real albedo) {
                        return slip == Slip::albedo_stays
                                   ? wide(color)
                                   : wide(color) / std::max(wide(albedo), darkest);
                    };
                    const Color& color = source.at(i, j);
                    sum[0] += weight * light(color.r, b.albedo.r);
                    sum[1] += weight * light(color.g, b.albedo.g);
                    sum[2] += weight * light(color.b, b.albedo.b);
                    weights += weight;
                }
            const auto shown = [&](Wide light, Real albedo) {
                if (slip != Slip::not_normalized) light /= weights;
                if (slip != Slip::albedo_stays && slip != Slip::albedo_lost)
                    light *= std::max(wide(albedo), darkest);
                return static_cast<Real>(light);
            };
            result.at(x, y) = {shown(sum[0], a.albedo.r), shown(sum[1], a.albedo.g),
                               shown(sum[2], a.albedo.b)};
            if (slip == Slip::in_place) source.at(x, y) = result.at(x, y);
        }
    return result;
}

bool is_near(Real actual, Real expected, int roundings) {
    return std::abs(actual - expected) <= rt::rounding_bound(roundings) * std::abs(expected);
}
bool is_near(const Color& actual, const Color& expected, int roundings) {
    return is_near(actual.r, expected.r, roundings) && is_near(actual.g, expected.g, roundings) &&
           is_near(actual.b, expected.b, roundings);
}

// The index of the first pixel that is not as expected, or the number of pixels if all are.
int first_difference(const Image& actual, const Image& expected, int roundings) {
    int i = 0;
    for (; i < expected.width() * expected.height(); ++i) {
        const int x = i % expected.width(), y = i / expected.width();
        if (!is_near(actual.at(x, y), expected.at(x, y), roundings)) break;
    }
    return i;
}

// In words, if the picture is one of these.
std::string suggestion(const Image& actual, const Scene& scene, const DenoiseWidths& widths,
                       int roundings) {
    const std::pair<Slip, const char*> slips[] = {
        {Slip::in_place,
         "pixels that are already smoothed are averaged again: read from the given picture, and "
         "write to another one"},
        {Slip::not_normalized,
         "divide the sum by the sum of the weights, which is different at each pixel"},
        {Slip::narrow, "the last column or row within the radius is left out, on all sides"},
        {Slip::broad, "one column or row beyond the radius counts, on all sides"},
        {Slip::albedo_stays,
         "you averaged the picture itself: divide each pixel by its albedo first"},
        {Slip::albedo_lost,
         "your result is the light alone: multiply it by the albedo of the pixel"},
        {Slip::no_darkest, "an albedo less than widths.darkest counts as widths.darkest"},
        {Slip::circle,
         "the pixels that count are at most radius columns and at most radius rows away: a square, "
         "with its corners"},
        {Slip::floored_weight,
         "the weights use the unchanged albedo, even where it is less than widths.darkest"}};
    const int all = scene.width() * scene.height();
    for (const auto& [slip, words] : slips)
        if (first_difference(actual, reference(scene, widths, slip), roundings) == all)
            return words;
    for (const Wide least_weight :
         {0.5L, 0.1L, 0.05L, 0.01L, 0.005L, 1e-3L, 1e-4L, 1e-5L, 1e-6L, 1e-8L, 1e-10L, 1e-12L})
        if (first_difference(actual, reference(scene, widths, Slip::none, least_weight),
                             roundings) == all)
            return "do not leave out small weights: a small weight may belong to a bright pixel";
    return {};
}

void check_denoised(const Scene& scene, const DenoiseWidths& widths, const char* hint) {
    const Image actual = rt::denoised(scene.picture, scene.features, widths);
    const Image expected = reference(scene, widths, Slip::none);
    INFO("a picture of " << scene.width() << " x " << scene.height() << " pixels, radius "
                         << widths.radius);
    {
        INFO("Hint: the result is as large as the picture");
        REQUIRE(actual.width() == expected.width());
        REQUIRE(actual.height() == expected.height());
    }
    // Enough for all terms, and for what is left of the weights' errors.
    const int roundings = 200 + 2 * scene.width() * scene.height();
    const int i = first_difference(actual, expected, roundings);
    if (i == scene.width() * scene.height()) return;
    const int x = i % scene.width(), y = i / scene.width();
    std::string words = suggestion(actual, scene, widths, roundings);
    if (words.empty()) words = hint;
    INFO("pixel (" << x << ", " << y << ") was " << text(scene.picture.at(x, y)) << ": " EXPECTED
                   << text(expected.at(x, y)) << ", " ACTUAL << text(actual.at(x, y)));
    INFO("Hint: " << words);
    REQUIRE(text(actual.at(x, y)) == text(expected.at(x, y)));
}

constexpr const char* general_hint =
    "divide the sum of weight times light over the pixels within the radius by the sum of the "
    "weights. Columns end at the width, rows at the height, and features.at(i, j) belongs to "
    "picture.at(i, j)";

Color any_color(rt::Rng& rng, Real low, Real high) {
    return {rng.uniform(low, high), rng.uniform(low, high), rng.uniform(low, high)};
}

DenoiseWidths any_widths(rt::Rng& rng, int radius) {
    return {radius, rng.uniform(1, 4), rng.uniform(real(0.2), 1), rng.uniform(real(0.5), 2),
            rng.uniform(real(0.01), real(0.2))};
}

// With an albedo that is nowhere too dark.
Scene any_scene(rt::Rng& rng, int width, int height) {
    Scene scene{width, height};
    for (Features& f : scene.features)
        f = {any_color(rng, real(0.25), 1), rng() % 8 == 0 ? Vec3{} : any_direction(rng)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) scene.picture.at(x, y) = any_color(rng, 0, 2);
    return scene;
}

}  // namespace

TEST_CASE("11.6 a pixel's weight depends on position and albedo and normal", "[11.6]") {
    const Features surface{{real(0.5), real(0.3), real(0.2)}, {0, 0, 1}};
    const DenoiseWidths widths{5, 2, real(0.25), real(0.5)};
    check_weight(0, 0, surface, surface, widths);
    check_weight(2, 0, surface, surface, widths);
    check_weight(0, -2, surface, surface, widths);
    check_weight(-3, 1, surface, surface, widths);
    for (const Vec3& step : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{-1, 2, -2}}) {
        Features other = surface;
        other.albedo = other.albedo + real(0.25) * Color{step.x, step.y, step.z};
        check_weight(0, 0, surface, other, widths);
        check_weight(0, 0, other, surface, widths);
        other = surface;
        other.normal = other.normal + step * real(0.5);
        check_weight(0, 0, surface, other, widths);
        check_weight(0, 0, other, surface, widths);
    }
    rt::Rng rng{116, 1};
    for (int i = 0; i < 200; ++i) {
        const Features a{any_color(rng, 0, 1), any_direction(rng)};
        const Features b{any_color(rng, 0, 1), i % 5 == 0 ? Vec3{} : any_direction(rng)};
        const int across = static_cast<int>(rng() % 9) - 4, down = static_cast<int>(rng() % 9) - 4;
        check_weight(across, down, a, b, any_widths(rng, 4));
    }
}

TEST_CASE("11.6 one bright pixel spreads over its neighbors", "[11.6]") {
    for (const auto& [x, y] : {std::pair{4, 3}, {0, 0}, {8, 5}, {8, 2}, {1, 5}}) {
        Scene scene{9, 6};
        scene.picture.at(x, y) = {1, real(0.5), 0};
        check_denoised(scene, {2, 2}, general_hint);
    }
}

TEST_CASE("11.6 a picture of a single color does not change", "[11.6]") {
    Scene scene{5, 8, {{real(0.5), real(0.25), real(0.75)}, {0, 1, 0}}};
    scene.picture = Image(5, 8, {3, 2, 1});
    check_denoised(scene, {3, 2}, general_hint);
}

TEST_CASE("11.6 a texture stays sharp", "[11.6]") {
    rt::Rng rng{116, 2};
    Scene scene{8, 5};
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 8; ++x) {
            const Color albedo = any_color(rng, real(0.1), 1);
            scene.features.at(x, y).albedo = albedo;
            scene.picture.at(x, y) = Real(3) * albedo;
        }
    check_denoised(
        scene, {2, 2, real(0.5)},
        "the same light falls on all pixels here, and only the albedo differs. In each channel, "
        "divide by the neighbor's albedo, and multiply by the pixel's own albedo");
}

TEST_CASE("11.6 light does not cross an edge", "[11.6]") {
    const char* const hint =
        "the weight depends on the features of both pixels: this pixel and its neighbor";
    for (const bool is_turned : {false, true}) {
        // Dark light on the left side, bright light on the right side.
        Scene scene{10, 4};
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 10; ++x) {
                const bool is_right = x >= 6;
                if (is_right && is_turned) scene.features.at(x, y).normal = {1, 0, 0};
                if (!is_right && !is_turned)
                    scene.features.at(x, y).albedo = {real(0.2), real(0.3), 1};
                scene.picture.at(x, y) = is_right ? Color{5, 6, 7} : Color{1, 2, 3};
            }
        check_denoised(scene, {3, 2, real(0.1), real(0.2)}, hint);
        check_denoised(scene, {3, 2, 1, 1}, hint);
    }
}

TEST_CASE("11.6 the variance falls by the factor that the weights give", "[11.6]") {
    rt::Rng rng{116, 3};
    Scene scene{60, 40};
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x) scene.picture.at(x, y) = any_color(rng, 0, 1);
    const DenoiseWidths widths{2, real(1.2)};
    const Image smooth = rt::denoised(scene.picture, scene.features, widths);
    double weights = 0, squares = 0;
    for (int down = -2; down <= 2; ++down)
        for (int across = -2; across <= 2; ++across) {
            const double w = std::exp(-(across * across + down * down) / (2 * 1.2 * 1.2));
            weights += w;
            squares += w * w;
        }
    const double expected = squares / (weights * weights) / 12;  // that of rng.uniform() is 1/12
    Mean mean;
    for (int y = 2; y < 38; ++y)
        for (int x = 2; x < 58; ++x) {
            const Color& c = smooth.at(x, y);
            for (const Real channel : {c.r, c.g, c.b}) mean.add(static_cast<double>(channel));
        }
    INFO("a flat surface with noise of variance "
         << 1.0 / 12 << ": " EXPECTED "a variance of about " << expected
         << " afterward, but your filter leaves " << mean.variance());
    INFO(
        "Hint: a sum of weights times noise has the variance times the sum of the squared weights; "
        "all pixels within the radius must take part, each with its weight");
    // Neighbors are smoothed together, so these are about 700 independent numbers: right code is
    // off by more once in ten million times.
    CHECK(std::abs(mean.variance() / expected - 1) < 0.3);
}

TEST_CASE("11.6 any picture is filtered correctly", "[11.6]") {
    rt::Rng rng{116, 4};
    for (const auto& [width, height] : {std::pair{7, 5}, {4, 9}, {11, 2}, {3, 3}, {2, 8}})
        for (int radius = 1; radius <= 3; ++radius) {
            check_denoised(any_scene(rng, width, height), any_widths(rng, radius), general_hint);
        }
}

TEST_CASE("11.6 pictures of one pixel or row work with any radius", "[11.6][hard]") {
    rt::Rng rng{116, 5};
    for (const auto& [width, height] :
         {std::pair{1, 1}, {20, 1}, {1, 17}, {3, 4}, {300, 1}, {1, 40}})
        for (const int radius : {0, 1, 9, 200, std::numeric_limits<int>::max()}) {
            DenoiseWidths widths = any_widths(rng, radius);
            if (width + height > 21) widths.space = 100;  // pixels far away count, too
            check_denoised(
                any_scene(rng, width, height), widths,
                "all pixels within the radius count, however large it is, and the box around the "
                "pixel ends at the border of the picture. Compare the radius with the distance to "
                "the border, width - 1 - x: x + radius may overflow");
        }
}

TEST_CASE("11.6 pictures with an albedo of 0 or nearly 0 are filtered correctly", "[11.6][hard]") {
    const char* const hint =
        "a channel of the albedo may be 0: do not divide by it, and do not lose its light";
    rt::Rng rng{116, 6};
    const Real tiny = std::numeric_limits<Real>::min();
    for (int i = 0; i < 5; ++i) {
        Scene scene = any_scene(rng, 6, 5);
        for (Features& f : scene.features) {
            if (rng() % 2) f.albedo.r = i == 0 ? 0 : tiny;
            if (rng() % 2) f.albedo.g = real(0.001);
            if (rng() % 4 == 0) f.albedo = {};
        }
        check_denoised(scene, any_widths(rng, 2), hint);
        check_denoised(scene, {2, 2, 1, 2}, hint);
    }
    check_denoised(Scene{4, 3, {}}, {}, hint);
}

TEST_CASE("11.6 an albedo of more than 1 is used as it is", "[11.6][hard]") {
    rt::Rng rng{116, 8};
    for (int i = 0; i < 5; ++i) {
        Scene scene = any_scene(rng, 6, 5);
        for (Features& f : scene.features)
            if (rng() % 2) f.albedo = any_color(rng, real(0.5), 3);
        check_denoised(
            scene, any_widths(rng, 2),
            "an albedo has no upper limit: only an albedo less than widths.darkest is replaced");
    }
}

TEST_CASE("11.6 very bright and very dark light is filtered correctly", "[11.6][hard]") {
    rt::Rng rng{116, 7};
    const Real power = for_this_precision(30, 200);
    for (const Real size : {-power, power}) {
        Scene scene = any_scene(rng, 5, 4);
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 5; ++x) scene.picture.at(x, y) *= std::pow(Real(10), size);
        scene.picture.at(2, 2) *= 1000;
        check_denoised(scene, any_widths(rng, 2),
                       "do not square the light, limit it or add anything to it");
    }
    // A lamp that still counts at a distance where its weight is 10^-15.
    Scene scene{7, 5};
    scene.picture = Image(7, 5, {1, 2, 3});
    scene.picture.at(0, 2) = {real(1e20), real(2e20), 0};
    check_denoised(scene, {5, real(0.6)},
                   "do not leave out small weights: a small weight may belong to a bright pixel");
}

TEST_CASE("11.6 weights are accurate for extreme widths and distant pixels", "[11.6][hard]") {
    const Features surface{{real(0.5), real(0.3), real(0.2)}, {0, 0, 1}};
    const Features other{{real(0.4), real(0.3), real(0.2)}, {0, 1, 0}};
    const Real narrow = for_this_precision(1e-30, 1e-200), off = rt::infinity;
    for (const DenoiseWidths& widths :
         {DenoiseWidths{2, 2, narrow, 1}, DenoiseWidths{2, 2, 1, narrow},
          DenoiseWidths{2, narrow, 1, 1}, DenoiseWidths{2, off, real(0.1), 1},
          DenoiseWidths{2, 2, off, 1}, DenoiseWidths{2, 2, 1, off},
          DenoiseWidths{2, off, off, off}})
        for (const Features& b : {surface, other}) {
            check_weight(0, 0, surface, b, widths);
            check_weight(-1, 2, surface, b, widths);
        }
    // Almost equal, and as narrow a width.
    const char* const hint =
        "subtract first, then square: if two vectors are almost equal, the sum of their squares "
        "and twice their product cancel";
    rt::Rng rng{116, 9};
    const auto near = real(for_this_precision(1e-4, 1e-9));
    for (int i = 0; i < 50; ++i) {
        const Features a{any_color(rng, real(0.2), 1), any_direction(rng)};
        const Features b{a.albedo + near * any_color(rng, -1, 1),
                         a.normal + near * any_direction(rng)};
        check_weight(1, -1, a, b, {2, 2, 1, near}, hint);
        check_weight(1, -1, a, b, {2, 2, near, 1}, hint);
    }
    check_weight(50000, -70000, surface, surface, {100000, real(50000), 1, 1});
}
