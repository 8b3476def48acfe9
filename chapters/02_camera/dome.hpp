#pragma once
// What the cameras of this chapter look at: a dome with lines every 10 degrees, a tint for each
// quarter of the compass, the sun in the south, and a plain with a grid of squares.

#include <algorithm>
#include <app/lettering.hpp>
#include <array>
#include <cmath>
#include <limits>
#include <rt/color.hpp>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/portable.hpp>
#include <rt/ray.hpp>
#include <string_view>

namespace dome {

using rt::Color;
using rt::Real;
using rt::Vec3;

// The direction with this elevation above the horizon, and this azimuth clockwise from north (-z)
// through east (+x), in degrees.
inline Vec3 toward(Real azimuth_deg, Real elevation_deg) {
    const Real a = rt::radians(azimuth_deg), e = rt::radians(elevation_deg);
    return {rt::portable::sin(a) * rt::portable::cos(e), rt::portable::sin(e),
            -rt::portable::cos(a) * rt::portable::cos(e)};
}

// The rays through the middle of a pixel and of its neighbors to the right and below. Their
// differences tell how large the pixel is on whatever it shows, so that lines can be one pixel wide
// everywhere and have soft edges.
struct Beam {
    rt::Ray here, right, below;

    // How much a function of a pixel's ray changes from this pixel to the next.
    template <class F>
    Real change(F f) const {
        return rt::portable::hypot(f(right) - f(here), f(below) - f(here));
    }
};

// The share of a pixel of size `pixel` that a line of this width covers, if the middle of the line
// is at this distance from the middle of the pixel.
inline Real coverage(Real distance, Real width, Real pixel) {
    return std::clamp(((width + pixel) / 2 - distance) / pixel, Real(0),
                      std::min(width / pixel, Real(1)));
}

// The share of a pixel that a line covers. The line is one pixel wide, and runs where f is 0; the
// next line runs where f is `next`. Lines fade where they are less than 10 pixels apart.
template <class F>
Real line(const Beam& beam, F f, Real next) {
    const Real pixel = beam.change(f);
    if (!(0 < pixel && pixel < rt::infinity)) return 0;
    return coverage(std::abs(f(beam.here)), pixel, pixel) *
           std::clamp(next / pixel / 10, Real(0), Real(1));
}

// The same for lines wherever f is a multiple of `spacing`.
template <class F>
Real lines(const Beam& beam, F f, Real spacing) {
    const Real nearest = spacing * std::round(f(beam.here) / spacing);
    return line(
        beam, [&](const rt::Ray& r) { return f(r) - nearest; }, spacing);
}

inline Real azimuth(Vec3 d) {
    return d.x == 0 && d.z == 0 ? 0 : rt::portable::atan2(d.x, -d.z);
}
inline Real elevation(Vec3 d) {
    return rt::portable::atan2(d.y, rt::portable::hypot(d.x, d.z));
}

// The tint of a direction: the tints of north, east, south and west blend into each other.
inline Color quarter(Vec3 d) {
    static const std::array tints{rt::from_hex(0x8ec9d6), rt::from_hex(0xf09a7c),
                                  rt::from_hex(0xfbd38a), rt::from_hex(0xb795d2)};
    const Real a = azimuth(d), north = rt::portable::cos(a), east = rt::portable::sin(a);
    return north * north * tints[north > 0 ? 0 : 2] + east * east * tints[east > 0 ? 1 : 3];
}

inline Color ground(const Beam& beam) {
    static const Color earth = rt::from_hex(0x25303c), line = rt::from_hex(0x9fb4bd);
    const auto distance = [](const rt::Ray& r) { return -r.origin.y / r.direction.y; };
    const auto x = [&](const rt::Ray& r) { return r.at(distance(r)).x; };
    const auto z = [&](const rt::Ray& r) { return r.at(distance(r)).z; };
    const Color haze = quarter(beam.here.direction);
    const bool all_below = beam.right.direction.y < 0 && beam.below.direction.y < 0;
    Color color = mix(earth, haze, Real(0.05));
    if (all_below) {
        const Real fine = std::max(lines(beam, x, 2), lines(beam, z, 2));
        color = mix(color, line, Real(0.55) * fine);
    }
    return mix(haze, color, 1 - rt::portable::exp(Real(14) * beam.here.direction.y));
}

inline Color sky(const Beam& beam, Real pixel_deg) {
    static const Color zenith = rt::from_hex(0x10224d), middle = rt::from_hex(0x4f82c2);
    static const Color sunlight = rt::from_hex(0xfff3cf);
    const Vec3 d = beam.here.direction;
    const Real height = elevation(d) / (rt::pi / 2);
    Color color = mix(mix(quarter(d), middle, height), mix(middle, zenith, height), height);

    // Meridians: the meridian nearest to this direction lies in the plane with this normal. (The
    // azimuth itself jumps in the south, and changes ever faster toward the zenith.)
    const Real ten = rt::radians(10);
    const Real meridian = ten * std::round(azimuth(d) / ten);
    const Vec3 normal{rt::portable::cos(meridian), 0, rt::portable::sin(meridian)};
    const Real gap = ten * rt::portable::cos(elevation(d));  // to the next meridian
    const Real along = line(
        beam, [&](const rt::Ray& r) { return dot(r.direction, normal); }, gap);
    const Real around = lines(
        beam, [](const rt::Ray& r) { return elevation(r.direction); }, ten);
    color = mix(color, {1, 1, 1}, Real(0.5) * std::max(along, around));

    // The sun: a disk of 2 degrees' radius in a glow.
    const Vec3 sun = toward(174, 13);
    const Real from_sun =
        rt::portable::atan2(length(cross(sun, d)), dot(sun, d)) * 180 / rt::pi;  // degrees
    color = mix(color, sunlight, Real(0.75) * rt::portable::exp(-from_sun / 5));
    return mix(color, sunlight, coverage(from_sun, 4, pixel_deg));
}

// The share of a pixel that the letters N, E, S and W cover. They stand on the horizon and are 6
// degrees high.
inline Real compass(Vec3 d, Real pixel_deg) {
    const Real degree = 180 / rt::pi, unit = Real(1.5);  // 4 units are a letter's height
    const Real a = azimuth(d) * degree, quarter_turn = std::round(a / 90);
    const int i = (static_cast<int>(quarter_turn) + 4) % 4;
    const rt::Vec2 p{(a - 90 * quarter_turn) / unit + 1, 4 + (4 - elevation(d) * degree) / unit};
    const Real distance = unit * app::distance_to_text(p, std::string_view("NESW").substr(
                                                              static_cast<std::size_t>(i), 1));
    return coverage(distance, Real(0.9), pixel_deg);
}

// The color that a beam shows.
inline Color look(const Beam& beam) {
    const Vec3 d = beam.here.direction;
    const Real across = length(beam.right.direction - d), down = length(beam.below.direction - d);
    // Greater than 0 even if a mistake in the camera makes the pixel's size 0.
    const Real pixel_deg =
        std::max(std::numeric_limits<Real>::min(), std::sqrt(across * down) * 180 / rt::pi);
    const Color color = d.y < 0 ? ground(beam) : sky(beam, pixel_deg);
    return mix(color, rt::from_hex(0x1b2233), compass(d, pixel_deg));
}

}  // namespace dome
