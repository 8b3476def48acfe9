#pragma once
// What was measured in the Cornell box, and the colors that it makes.
//
// Source: Cornell University Program of Computer Graphics, "Cornell Box Data",
// https://www.graphics.cornell.edu/online/box/data.html

#include <array>
#include <cstddef>
#include <rt/color.hpp>
#include <rt/portable.hpp>
#include <rt/tone_curve.hpp>

namespace light {

// Reflectances at 400, 404, ..., 700 nm.
using Spectrum = std::array<double, 76>;

inline constexpr Spectrum white_paint{
    0.343, 0.445, 0.551, 0.624, 0.665, 0.687, 0.708, 0.723, 0.715, 0.710, 0.745, 0.758, 0.739,
    0.767, 0.777, 0.765, 0.751, 0.745, 0.748, 0.729, 0.745, 0.757, 0.753, 0.750, 0.746, 0.747,
    0.735, 0.732, 0.739, 0.734, 0.725, 0.721, 0.733, 0.725, 0.732, 0.743, 0.744, 0.748, 0.728,
    0.716, 0.733, 0.726, 0.713, 0.740, 0.754, 0.764, 0.752, 0.736, 0.734, 0.741, 0.740, 0.732,
    0.745, 0.755, 0.751, 0.744, 0.731, 0.733, 0.744, 0.731, 0.712, 0.708, 0.729, 0.730, 0.727,
    0.707, 0.703, 0.729, 0.750, 0.760, 0.751, 0.739, 0.724, 0.730, 0.740, 0.737};
inline constexpr Spectrum green_paint{
    0.092, 0.096, 0.098, 0.097, 0.098, 0.095, 0.095, 0.097, 0.095, 0.094, 0.097, 0.098, 0.096,
    0.101, 0.103, 0.104, 0.107, 0.109, 0.112, 0.115, 0.125, 0.140, 0.160, 0.187, 0.229, 0.285,
    0.343, 0.390, 0.435, 0.464, 0.472, 0.476, 0.481, 0.462, 0.447, 0.441, 0.426, 0.406, 0.373,
    0.347, 0.337, 0.314, 0.285, 0.277, 0.266, 0.250, 0.230, 0.207, 0.186, 0.171, 0.160, 0.148,
    0.141, 0.136, 0.130, 0.126, 0.123, 0.121, 0.122, 0.119, 0.114, 0.115, 0.117, 0.117, 0.118,
    0.120, 0.122, 0.128, 0.132, 0.139, 0.144, 0.146, 0.150, 0.152, 0.157, 0.159};
inline constexpr Spectrum red_paint{
    0.040, 0.046, 0.048, 0.053, 0.049, 0.050, 0.053, 0.055, 0.057, 0.056, 0.059, 0.057, 0.061,
    0.061, 0.060, 0.062, 0.062, 0.062, 0.061, 0.062, 0.060, 0.059, 0.057, 0.058, 0.058, 0.058,
    0.056, 0.055, 0.056, 0.059, 0.057, 0.055, 0.059, 0.059, 0.058, 0.059, 0.061, 0.061, 0.063,
    0.063, 0.067, 0.068, 0.072, 0.080, 0.090, 0.099, 0.124, 0.154, 0.192, 0.255, 0.287, 0.349,
    0.402, 0.443, 0.487, 0.513, 0.558, 0.584, 0.620, 0.606, 0.609, 0.651, 0.612, 0.610, 0.650,
    0.638, 0.627, 0.620, 0.630, 0.628, 0.642, 0.639, 0.657, 0.639, 0.635, 0.642};

// The lamp's light at 400, 500, 600 and 700 nm; in between, the value changes evenly.
inline double lamp_at(double wavelength) {
    constexpr std::array measured{0.0, 8.0, 15.6, 18.4};
    const double place = (wavelength - 400) / 100;
    const auto before = place < 2 ? static_cast<std::size_t>(place) : std::size_t{2};
    const double share = place - static_cast<double>(before);
    return (1 - share) * measured[before] + share * measured[before + 1];
}

// How strongly the eye's three color matching functions respond to a wavelength, in nanometers.
// Source: Wyman, Sloan and Shirley, "Simple analytic approximations to the CIE XYZ color matching
// functions", Journal of Computer Graphics Techniques 2(2), 2013.
inline std::array<double, 3> matching(double wavelength) {
    const auto bump = [&](double middle, double below, double above) {
        const double off = (wavelength - middle) / (wavelength < middle ? below : above);
        return rt::portable::exp(-off * off / 2);
    };
    return {1.056 * bump(599.8, 37.9, 31.0) + 0.362 * bump(442.0, 16.0, 26.7) -
                0.065 * bump(501.1, 20.4, 26.2),
            0.821 * bump(568.8, 46.9, 40.5) + 0.286 * bump(530.9, 16.3, 31.1),
            1.217 * bump(437.0, 11.8, 36.0) + 0.681 * bump(459.0, 26.0, 13.8)};
}

// The linear color of the lamp's light after it was reflected by a paint: a sum over the
// wavelengths. A light that has the value 1 at each wavelength has the luminance 1.
inline rt::Color color_under_lamp(const Spectrum& paint) {
    std::array<double, 3> xyz{};
    double whole = 0;
    for (std::size_t i = 0; i < paint.size(); ++i) {
        const double wavelength = 400 + 4 * static_cast<double>(i);
        const auto match = matching(wavelength);
        for (std::size_t k = 0; k < 3; ++k) xyz[k] += paint[i] * lamp_at(wavelength) * match[k];
        whole += match[1];
    }
    const double x = xyz[0], y = xyz[1], z = xyz[2];
    const auto channel = [&](double of_x, double of_y, double of_z) {
        return static_cast<rt::Real>((of_x * x + of_y * y + of_z * z) / whole);
    };
    // From CIE XYZ to the red, green and blue of sRGB: IEC 61966-2-1.
    return {channel(3.2404542, -1.5371385, -0.4985314), channel(-0.9692660, 1.8760108, 0.0415560),
            channel(0.0556434, -0.2040259, 1.0572252)};
}

// The lamp's own color.
inline rt::Color lamp_color() {
    Spectrum all;
    all.fill(1);
    return color_under_lamp(all);
}

// The red, green and blue that a paint reflects of the lamp's light. With these, the light that
// comes straight from the lamp has exactly the color that the spectra give it.
inline rt::Color paint_color(const Spectrum& paint) {
    const rt::Color seen = color_under_lamp(paint), lamp = lamp_color();
    return {seen.r / lamp.r, seen.g / lamp.g, seen.b / lamp.b};
}

// The lamp as a camera shows it that is balanced for its light: white, and as bright as before.
inline rt::Color balanced_lamp() {
    return rt::luminance(lamp_color()) * rt::Color{1, 1, 1};
}

}  // namespace light
