#include <algorithm>
#include <cmath>
#include <companion/compare/difference_text.hpp>
#include <cstdio>
#include <map>
#include <rt/counted.hpp>
#include <set>

namespace companion {
namespace {

constexpr const char* channels[] = {"red", "green", "blue"};

std::string percent(double part) {
    char text[32];
    const double value = 100 * std::abs(part);
    std::snprintf(text, sizeof text, value < 9.95 ? "%.1f %%" : "%.0f %%", value);
    return text;
}

// The total light of some tiles, in each program.
struct Light {
    std::array<double, 3> mine{}, solution{};
    double apart = 0;  // sum of the tiles' absolute differences
    long still_differing = 0;
    double largest_step = 0;  // as in TileStatistics

    explicit Light(const std::vector<TileStatistics>& tiles) {
        for (const TileStatistics& tile : tiles) {
            still_differing += tile.still_differing;
            largest_step = std::max(largest_step, tile.largest_step);
            for (std::size_t i = 0; i < 3; ++i) {
                const double pixels = tile.tile.width * tile.tile.height;
                mine[i] += tile.mine[i] * pixels;
                solution[i] += tile.solution[i] * pixels;
                apart += std::abs(tile.mine[i] - tile.solution[i]) * pixels;
            }
        }
    }
    static double sum(const std::array<double, 3>& light) { return light[0] + light[1] + light[2]; }
    double relative() const { return sum(mine) / sum(solution) - 1; }
    double relative(std::size_t i) const { return solution[i] > 0 ? mine[i] / solution[i] - 1 : 0; }
};

std::string brightness(const Light& light) {
    const double relative = light.relative();
    if (!(Light::sum(light.solution) > 0)) return "bright where it should be black";
    if (relative >= 1) {
        char text[48];
        std::snprintf(text, sizeof text, "%.2g times as bright", relative + 1);
        return text;
    }
    return percent(relative) + (relative < 0 ? " too dark" : " too bright");
}

// The channel that differs from both others, if there is one, in words.
std::string cast(const Light& light) {
    for (std::size_t i = 0; i < 3; ++i) {
        const double own = light.relative(i), next = light.relative((i + 1) % 3),
                     last = light.relative((i + 2) % 3);
        const double apart = own - (next + last) / 2;
        if (std::abs(apart) < 0.02 || std::abs(apart) < 3 * std::abs(next - last)) continue;
        if (std::abs(apart) < std::abs(light.relative()) / 4) continue;
        return percent(apart) + (apart > 0 ? " too " : " too little ") + channels[i];
    }
    return {};
}

// What differs where the light of each tile is the same but for less than 0.1 %.
std::string faint_difference(const Light& light) {
    char text[120];
    if (light.still_differing > 0)
        std::snprintf(text, sizeof text, "%s without noise %s, by up to %.0f of 255 steps",
                      rt::counted(light.still_differing, "pixel").c_str(),
                      light.still_differing == 1 ? "differs" : "differ", light.largest_step);
    else
        std::snprintf(text, sizeof text,
                      "the light differs by less than 0.1 %%, but by more than noise explains; a "
                      "pixel's mean by up to %.1f of 255 steps",
                      light.largest_step);
    return text;
}

}  // namespace

std::string region_of(const Tile& tile, int width, int height) {
    constexpr const char* names[3][3] = {{"upper left", "top", "upper right"},
                                         {"left", "middle", "right"},
                                         {"lower left", "bottom", "lower right"}};
    const auto third = [](int start, int size, int all) {
        return std::clamp((2 * start + size) * 3 / (2 * all), 0, 2);
    };
    return names[third(tile.top, tile.height, height)][third(tile.left, tile.width, width)];
}

std::vector<std::string> regions_of(const std::vector<TileStatistics>& tiles, int width,
                                    int height) {
    std::set<std::string> regions;
    for (const TileStatistics& tile : tiles) regions.insert(region_of(tile.tile, width, height));
    return {regions.begin(), regions.end()};
}

std::string describe_difference(const std::vector<TileStatistics>& tiles) {
    const Light light{tiles};
    const double all = Light::sum(light.solution);
    const double apart = all > 0 ? light.apart / all : 1;
    const std::string color = cast(light);
    if (apart < 0.001 && color.empty()) return faint_difference(light);
    // Too bright and too dark tiles balance each other, so shapes have moved.
    if (std::abs(Light::sum(light.mine) - all) < light.apart / 3 && color.empty())
        return "drawn differently, by " + percent(apart) + " on average";
    std::string text;
    if (std::abs(light.relative()) >= 1.0 / 1000 || color.empty()) text = brightness(light);
    if (!color.empty()) text += (text.empty() ? "" : ", ") + color;
    return text;
}

std::vector<std::string> describe_by_region(const std::vector<TileStatistics>& differing,
                                            const std::vector<TileStatistics>& all, int width,
                                            int height) {
    std::map<std::string, std::vector<TileStatistics>> by_region;
    for (const TileStatistics& tile : differing)
        by_region[region_of(tile.tile, width, height)].push_back(tile);
    if (by_region.size() >= 7 && 2 * differing.size() > all.size())
        return {"everywhere: " + describe_difference(differing)};
    std::vector<std::pair<double, std::string>> lines;
    for (const auto& [region, tiles] : by_region)
        lines.push_back({-Light{tiles}.apart, region + ": " + describe_difference(tiles)});
    std::sort(lines.begin(), lines.end());
    std::vector<std::string> words;
    for (const auto& [apart, line] : lines) words.push_back(line);
    constexpr std::size_t shown = 4;
    if (words.size() > shown) {
        const auto more = words.size() - shown;
        words.resize(shown);
        words.push_back("and in " + rt::counted(more, "more region"));
    }
    return words;
}

}  // namespace companion
