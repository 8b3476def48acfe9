#pragma once
// The error budget: what each error of a picture does to a pixel, all on one scale.

#include <rt/color.hpp>
#include <rt/far_view.hpp>
#include <string>
#include <study/pixel_error.hpp>
#include <type_traits>

#include "any_precision.hpp"
#include "stage.hpp"

namespace normals_aa {

// A small picture of the group, with as many bounces as in the chapter's picture.
constexpr int budget_width = 48, budget_height = 27, budget_depth = 16;

// The view of the group from this distance.
inline View view_from(Real distance) {
    const View view = group_view();
    return study::from_afar(view, distance / length(view.from - view.at));
}

// The effect of rounding: the picture in Real with each formula, compared with the picture in the
// widest number type with the stable formula. All pictures use the same random numbers.
struct RoundingErrors {
    double stable = 0, textbook = 0;
};
inline RoundingErrors rounding_errors(const View& view, int samples) {
    const any_precision::Picture<Real> rounded{view, budget_width, budget_height};
    const any_precision::Picture<long double> exact{view, budget_width, budget_height};
    const auto squared = [](const auto& a, const any_precision::Vector<long double>& b) {
        const auto d = any_precision::as<long double>(a) - b;
        return static_cast<double>(dot(d, d)) / (3.0 * budget_width * budget_height);
    };
    RoundingErrors sum;
    for (int y = 0; y < budget_height; ++y)
        for (int x = 0; x < budget_width; ++x) {
            const auto draw = [&](const auto& picture, const auto& formula) {
                return picture.pixel(x, y, samples, budget_depth, formula);
            };
            const auto truth = draw(exact, any_precision::StableFormula{});
            sum.stable += squared(draw(rounded, any_precision::StableFormula{}), truth);
            sum.textbook += squared(draw(rounded, any_precision::TextbookFormula{}), truth);
        }
    return {std::sqrt(sum.stable), std::sqrt(sum.textbook)};
}

// This color as an image file stores it.
inline Color stored(Color c) {
    const auto channel = [](Real light) { return srgb_decode(Real(to_byte(light)) / 255); };
    return {channel(c.r), channel(c.g), channel(c.b)};
}

inline void study_budget(study::Report& report) {
    const auto add = [&](const std::string& variant, int samples, double error) {
        study::Row row = study::pixel_error(variant, samples, "samples per pixel", error);
        row.study = "Error budget";
        report.add(std::move(row));
    };
    const auto add_rounding = [&](const std::string& where, const View& view) {
        const RoundingErrors errors = rounding_errors(view, 100);
        add("rounding" + where, 100, errors.stable);
        add("textbook formula" + where, 100, errors.textbook);
    };
    add_rounding("", group_view());
    add_rounding(", 1000 radii away", view_from(Real(1e3)));
    add_rounding(", 10^7 radii away", view_from(Real(1e7)));
    add("rounding, 400 samples", 400, rounding_errors(group_view(), 400).stable);
    if (std::is_same_v<Real, float>) return;  // the rest is the same in every precision

    const Stage stage{.camera = make_camera(group_view(), budget_width, budget_height)};
    const auto add_picture = [&](const std::string& variant, int samples, const Pixels& pixels,
                                 const Pixels& truth) {
        add(variant, samples, study::root_mean_square_error(pixels, truth));
    };
    constexpr int many = 1 << 12;
    const Pixels truth = draw_low_discrepancy(stage, many, budget_depth, 1, SkyEnding{});
    Pixels file = truth;
    for (Color& c : file) c = stored(c);
    add_picture("8 bits a channel", many, file, truth);
    const auto add_noise = [&](const std::string& variant, const Quality& quality,
                               const auto& ending) {
        add_picture(variant, quality.samples_per_pixel, draw_jittered(stage, quality, ending),
                    truth);
    };
    add_noise("noise, 1 sample", {1, budget_depth, 2}, SkyEnding{});
    add_noise("noise, 100 samples", {100, budget_depth, 2}, SkyEnding{});
    add_noise("noise, 100 samples, roulette after 4 bounces", {100, 4, 2}, RouletteEnding{});

    // With every ending, the paths are the same up to the depth limit.
    constexpr int enough = 1 << 10;
    const auto draw = [&](int depth, const auto& ending) {
        return draw_low_discrepancy(stage, enough, depth, 1, ending);
    };
    const Pixels deep = draw(64, SkyEnding{});
    for (const int depth : {4, 16}) {
        const std::string after = " after " + std::to_string(depth) + " bounces";
        add_picture("black" + after, enough, draw(depth, BlackEnding{}), deep);
        add_picture("sky" + after, enough, draw(depth, SkyEnding{}), deep);
    }
}

}  // namespace normals_aa
