#pragma once
// The one scale on which the errors of all chapters are compared: what they do to a pixel.

#include <cmath>
#include <rt/color.hpp>
#include <span>
#include <string>
#include <study/report.hpp>

namespace study {

// The root mean square error of a picture, in linear light where white is 1.
inline double root_mean_square_error(std::span<const rt::Color> pixels,
                                     std::span<const rt::Color> truth) {
    double sum = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const rt::Color off = pixels[i] - truth[i];
        for (const rt::Real channel : {off.r, off.g, off.b})
            sum += static_cast<double>(channel) * static_cast<double>(channel);
    }
    return std::sqrt(sum / (3 * static_cast<double>(pixels.size())));
}

// A row of a report, with an error on that scale.
inline Row pixel_error(const std::string& variant, double x, const std::string& x_name,
                       double error) {
    return {.study = "Error in a pixel",
            .variant = variant,
            .x = x,
            .x_name = x_name,
            .error = error,
            .error_name = "RMSE in a pixel"};
}

}  // namespace study
