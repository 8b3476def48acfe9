#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <rt/light_sample.hpp>
#include <rt/portable.hpp>
#include <rt/running_shares.hpp>
#include <rt/sine_cosine.hpp>
#include <rt/sky_table.hpp>
#include <rt/tone_curve.hpp>
#include <rt/vec2.hpp>

namespace rt {

// The number of rows between a row and the nearer of the two poles. Both halves of the sky are
// computed by this number, so that the lower one is as accurate as the upper one.
inline int rows_from_pole(const Image& picture, int row) {
    return std::min(row, picture.height() - 1 - row);
}

// The pixel of a picture of the whole sky that is seen in a direction of length 1. Rows are bands
// of equal angle from straight up, (0, 1, 0), to straight down; columns are slices of equal angle.
// The middle of the picture is seen along -z, and what lies to the right there, along +x, is in its
// right half. The left edge and the right edge meet at +z.
inline SkyPixel sky_pixel(const Image& picture, Vec3 direction) {
    const auto [x, y, z] = direction;
    const Real turn = portable::atan2(-x, z) / (2 * pi);
    const Real from_pole = portable::atan2(portable::hypot(x, z), std::abs(y)) / pi;
    const auto part = [](Real share, int count) {
        return std::min(static_cast<int>(share * static_cast<Real>(count)), count - 1);
    };
    const int row = part(from_pole, picture.height());
    return {part(turn < 0 ? turn + 1 : turn, picture.width()),
            y < 0 ? picture.height() - 1 - row : row};
}

// The solid angle, in steradians, of each pixel in a row. By Archimedes, it is the share of a turn
// times the difference of the heights of the row's edges, cos a - cos b. That is written as
// 2 sin((a + b) / 2) sin((b - a) / 2), which does not cancel near the poles.
inline Real sky_solid_angle(const Image& picture, int row) {
    const Real step = pi / static_cast<Real>(picture.height());
    const Real middle = step * (static_cast<Real>(rows_from_pole(picture, row)) + Real(0.5));
    return 4 * pi / static_cast<Real>(picture.width()) * portable::sin(middle) *
           portable::sin(step / 2);
}

// The table of a picture whose colors are 0 or more and finite. A pixel is as likely as the light
// that comes from it is bright: luminance times solid angle.
inline SkyTable make_sky_table(const Image& picture) {
    SkyTable table{&picture, {}, {}};
    std::vector<Real> rows, row(static_cast<std::size_t>(picture.width()));
    for (int y = 0; y < picture.height(); ++y) {
        double sum = 0;  // of a row that may have thousands of pixels
        for (int x = 0; x < picture.width(); ++x) {
            const Real bright = luminance(picture.at(x, y));
            row[static_cast<std::size_t>(x)] = bright;
            sum += static_cast<double>(bright);
        }
        table.columns.push_back(running_shares(row));
        rows.push_back(static_cast<Real>(sum) * sky_solid_angle(picture, y));
    }
    table.rows = running_shares(rows);
    return table;
}

// The probability density, per solid angle, with which sample_sky takes a direction: that of its
// pixel, spread evenly over the pixel's solid angle.
inline Real sky_density(const SkyTable& table, Vec3 direction) {
    const SkyPixel pixel = sky_pixel(*table.picture, direction);
    const auto row = static_cast<std::size_t>(pixel.row);
    return probability_of(table.rows, row) *
           probability_of(table.columns[row], static_cast<std::size_t>(pixel.column)) /
           sky_solid_angle(*table.picture, pixel.row);
}

// The direction to a place within a pixel: within.x says how far it is from the pixel's left edge,
// and within.y which share of the pixel's solid angle is above it.
inline Vec3 sky_direction(const Image& picture, SkyPixel pixel, Vec2 within) {
    const int from_pole = rows_from_pole(picture, pixel.row);
    const bool is_up = from_pole == pixel.row;
    // 1 - cos a = 2 sin^2(a / 2): how far below the pole an edge of the row is.
    const auto depth = [&](int edge) {
        const Real half =
            portable::sin(pi / 2 * static_cast<Real>(edge) / static_cast<Real>(picture.height()));
        return 2 * half * half;
    };
    const Real near = depth(from_pole), far = depth(from_pole + 1);
    const Real below = near + (is_up ? within.y : 1 - within.y) * (far - near);
    const Real radius = std::sqrt(below * (2 - below)), height = 1 - below;
    const auto turn = sine_cosine_of_turn((static_cast<Real>(pixel.column) + within.x) /
                                          static_cast<Real>(picture.width()));
    return {-radius * turn.sine, is_up ? height : -height, radius * turn.cosine};
}

// A direction to the sky, with its density and an infinite distance: place.y chooses a row, and
// place.x a pixel in it. 0 <= x, y < 1. None if the sky is black.
inline std::optional<LightSample> sample_sky(const SkyTable& table, Vec2 place) {
    const Pick row = pick(table.rows, place.y);
    if (!(row.probability > 0)) return {};
    const Pick column = pick(table.columns[row.index], place.x);
    const SkyPixel pixel{static_cast<int>(column.index), static_cast<int>(row.index)};
    Vec3 direction = sky_direction(*table.picture, pixel, {column.rest, row.rest});
    // At the very edge of a pixel, rounding can lead into the next one, which may be black.
    if (sky_pixel(*table.picture, direction) != pixel)
        direction = sky_direction(*table.picture, pixel, {Real(0.5), Real(0.5)});
    return LightSample{direction, infinity, sky_density(table, direction)};
}

}  // namespace rt
