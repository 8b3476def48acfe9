#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <rt/light_sample.hpp>
#include <rt/portable.hpp>
#include <rt/running_shares.hpp>
#include <rt/sky_table.hpp>
#include <rt/tone_curve.hpp>
#include <rt/vec2.hpp>

namespace rt {

inline SkyPixel sky_pixel(const Image& picture, Vec3 direction) {
    const Real turn = portable::atan2(direction.x, -direction.z) / (2 * pi) + Real(0.5);
    const Real down = portable::acos(direction.y) / pi;
    return {static_cast<int>(turn * static_cast<Real>(picture.width())),
            static_cast<int>(down * static_cast<Real>(picture.height()))};
}

inline Real sky_solid_angle(const Image& picture, int row) {
    const auto height = [&](int edge) {
        return portable::cos(pi * static_cast<Real>(edge) / static_cast<Real>(picture.height()));
    };
    return 2 * pi / static_cast<Real>(picture.width()) * (height(row) - height(row + 1));
}

inline SkyTable make_sky_table(const Image& picture) {
    SkyTable table;
    table.picture = &picture;
    std::vector<Real> rows;
    for (int y = 0; y < picture.height(); ++y) {
        std::vector<Real> row;
        Real sum = 0;
        for (int x = 0; x < picture.width(); ++x) {
            row.push_back(luminance(picture.at(x, y)));
            sum += row.back();
        }
        table.columns.push_back(running_shares(row));
        rows.push_back(sum * sky_solid_angle(picture, y));
    }
    table.rows = running_shares(rows);
    return table;
}

inline Real sky_density(const SkyTable& table, Vec3 direction) {
    const SkyPixel pixel = sky_pixel(*table.picture, direction);
    const std::size_t row = static_cast<std::size_t>(pixel.row);
    return probability_of(table.rows, row) *
           probability_of(table.columns[row], static_cast<std::size_t>(pixel.column)) /
           sky_solid_angle(*table.picture, pixel.row);
}

inline std::optional<LightSample> sample_sky(const SkyTable& table, Vec2 place) {
    const Image& picture = *table.picture;
    const Pick row = pick(table.rows, place.y);
    const Pick column = pick(table.columns[row.index], place.x);
    const auto height = [&](Real edge) {
        return portable::cos(pi * edge / static_cast<Real>(picture.height()));
    };
    const Real top = height(static_cast<Real>(row.index)),
               bottom = height(static_cast<Real>(row.index + 1));
    const Real y = top + row.rest * (bottom - top);
    const Real turn =
        2 * pi *
        ((static_cast<Real>(column.index) + column.rest) / static_cast<Real>(picture.width()) -
         Real(0.5));
    const Real radius = std::sqrt(1 - y * y);
    const Vec3 direction{radius * portable::sin(turn), y, -radius * portable::cos(turn)};
    return LightSample{direction, infinity,
                       row.probability * column.probability /
                           sky_solid_angle(picture, static_cast<int>(row.index))};
}

}  // namespace rt
