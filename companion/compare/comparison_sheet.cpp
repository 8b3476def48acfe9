#include <algorithm>
#include <app/lettering.hpp>
#include <companion/compare/comparison_sheet.hpp>

namespace companion {
namespace {

using rt::Color, rt::Image, rt::Real;

const Color paper = rt::from_hex(0x14171f), ink = rt::from_hex(0xe8e4da),
            bright = rt::from_hex(0xff9f1c), dark = rt::from_hex(0x3fa7ff),
            neither = rt::from_hex(0xc77dff);
constexpr int gap = 12, head = 34;

Real sum(Color c) {
    return c.r + c.g + c.b;
}

// The color of the heat map, black where nothing differs. The hue says how the light differs, and
// the strength by how much; it is full if the difference is half of the light or more.
Color heat(Color mine, Color solution) {
    const Color d = mine - solution;
    const Real apart = std::abs(d.r) + std::abs(d.g) + std::abs(d.b);
    // Relative to the light, so that small differences in dark regions are visible, too.
    const Real relative = apart / (std::max(sum(mine), sum(solution)) + Real(0.02));
    const Real strength = std::sqrt(std::min(Real(1), 2 * relative));
    const Real way = apart > 0 ? sum(d) / apart : 0;
    return strength * (way > Real(0.3) ? bright : way < Real(-0.3) ? dark : neither);
}

Color gray(Color c) {
    const Real light = Real(0.2126) * c.r + Real(0.7152) * c.g + Real(0.0722) * c.b;
    return Real(0.18) * std::min(Real(1), light) * Color{1, 1, 1};
}

Image heat_map(const Comparison& comparison, const Image& mine, const Image& solution) {
    Image map = rt::make_image(solution.width(), solution.height(),
                               [&](int x, int y) { return gray(solution.at(x, y)); });
    const auto paint = [&](const Tile& tile, auto color_at) {
        for (int y = tile.top; y < tile.top + tile.height; ++y)
            for (int x = tile.left; x < tile.left + tile.width; ++x) map.at(x, y) += color_at(x, y);
    };
    if (comparison.mine.size() == 1) {
        paint({0, 0, map.width(), map.height()},
              [&](int x, int y) { return heat(mine.at(x, y), solution.at(x, y)); });
        return map;
    }
    // Compares the means of tiles, because the difference of a single pixel would be mostly noise.
    const auto color = [](const std::array<double, 3>& light) {
        return Color{static_cast<Real>(light[0]), static_cast<Real>(light[1]),
                     static_cast<Real>(light[2])};
    };
    for (const TileStatistics& tile : comparison.light_differs_in)
        paint(tile.tile, [&](int, int) { return heat(color(tile.mine), color(tile.solution)); });
    for (const TileStatistics& tile : comparison.noise_differs_in)
        paint(tile.tile, [&](int, int) { return Real(0.3) * neither; });
    if (comparison.light_differs_in.empty() && comparison.pixels_differ)
        for (const TileStatistics& tile : comparison.statistics.tiles)
            paint(tile.tile, [&](int, int) {
                return std::clamp(static_cast<Real>(tile.pixel_excess), Real(0), Real(1)) * neither;
            });
    return map;
}

void write(Image& sheet, int left, std::string_view text) {
    constexpr Real unit = 4;  // pixels
    for (int y = 4; y < head - 2; ++y)
        for (int x = std::max(0, left - 4); x < sheet.width(); ++x) {
            const rt::Vec2 p{(static_cast<Real>(x - left) + Real(0.5)) / unit,
                             (static_cast<Real>(y - 8) + Real(0.5)) / unit};
            if (p.x > app::width_of(text) + 1) break;
            const Real cover =
                std::clamp(Real(1.3) - unit * app::distance_to_text(p, text), Real(0), Real(1));
            sheet.at(x, y) = mix(sheet.at(x, y), ink, cover);
        }
}

}  // namespace

Image difference_map(const Picture& mine, const Picture& solution) {
    Comparison pair;
    pair.mine = {mine};
    pair.solution = {solution};
    return heat_map(pair, mean_of({mine}), mean_of({solution}));
}

Image side_by_side(const Image& mine, const Image& ours) {
    Image sheet{2 * mine.width() + 3 * gap, mine.height() + head + gap, paper};
    int left = gap;
    for (const auto& [image, name] : {std::pair{&mine, "Yours"}, {&ours, "Ours"}}) {
        for (int y = 0; y < image->height(); ++y)
            for (int x = 0; x < image->width(); ++x) sheet.at(left + x, head + y) = image->at(x, y);
        write(sheet, left, name);
        left += mine.width() + gap;
    }
    return sheet;
}

Image comparison_sheet(const Comparison& comparison) {
    // If the sizes differ, those of the last pictures do.
    const auto shown_of = [&](const std::vector<Picture>& pictures) {
        return comparison.sizes_differ ? mean_of({pictures.back()}) : mean_of(pictures);
    };
    const Image mine = shown_of(comparison.mine), solution = shown_of(comparison.solution);
    const int width = solution.width(), height = solution.height();
    const Image map = comparison.sizes_differ ? Image{width, height, neither}
                                              : heat_map(comparison, mine, solution);
    const int scale = (479 + width) / width;  // small pictures are enlarged
    const Image* const shown[] = {&mine, &solution, &map};
    const char* const names[] = {"Yours", "Solution",
                                 comparison.same ? "No difference" : "Difference"};
    Image sheet{3 * width * scale + 4 * gap, height * scale + head + gap, paper};
    for (int i = 0; i < 3; ++i) {
        const int left = gap + i * (width * scale + gap);
        for (int y = 0; y < height * scale; ++y)
            for (int x = 0; x < width * scale; ++x)
                if (x / scale < shown[i]->width() && y / scale < shown[i]->height())
                    sheet.at(left + x, head + y) = shown[i]->at(x / scale, y / scale);
        write(sheet, left, names[i]);
    }
    return sheet;
}

}  // namespace companion
