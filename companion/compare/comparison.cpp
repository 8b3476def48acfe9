#include <algorithm>
#include <companion/compare/comparison.hpp>
#include <companion/compare/difference_text.hpp>
#include <cstdio>
#include <future>
#include <rt/rng.hpp>

namespace companion {
namespace {

// How many pictures of each program a step draws. If many tests look suspicious, the short second
// step is enough.
constexpr int first_step = 8, second_step = 16, short_second_step = 8;
constexpr double screening = 1.0 / 1000;  // for each test of the first step
constexpr double wronged = 1.0 / 1000;  // the share of right programs that the second step rejects

// Unrelated seeds: however simply a program uses its seed, no two pictures become alike.
class Seeds {
  public:
    explicit Seeds(std::uint64_t start) : next_{start << 20} {}
    std::uint64_t operator()() { return rt::mix_bits(next_++) >> 1; }

  private:
    std::uint64_t next_;
};

// A test of a tile or block, of its light or its noise, in one channel. local_tests() lists all of
// them in a fixed order.
struct LocalTest {
    const TileStatistics* tile;
    bool of_noise;
    double p;
};

std::vector<LocalTest> local_tests(const PictureStatistics& statistics) {
    std::vector<LocalTest> tests;
    for (const auto* tiles : {&statistics.tiles, &statistics.blocks})
        for (const TileStatistics& tile : *tiles)
            for (std::size_t c = 0; c < 3; ++c) {
                tests.push_back({&tile, false, tile.p[c]});
                tests.push_back({&tile, true, tile.noise_p[c]});
            }
    return tests;
}

// What the first step suspects.
struct Suspects {
    std::vector<std::size_t> tests;  // indices into local_tests()
    bool many = false;               // whether more than a tenth of all tests are suspected
    bool pixels = false, pixel_noise = false, tile_noise = false;

    bool any() const { return !tests.empty() || pixels || pixel_noise || tile_noise; }
};

Suspects suspects(const PictureStatistics& statistics) {
    Suspects found;
    const auto tests = local_tests(statistics);
    for (std::size_t i = 0; i < tests.size(); ++i)
        if (tests[i].p < screening) found.tests.push_back(i);
    found.many = 10 * found.tests.size() > tests.size();
    found.pixels = statistics.pixels_p < screening;
    found.pixel_noise = statistics.pixel_noise.p < screening;
    found.tile_noise = statistics.tile_noise.p < screening;
    return found;
}

bool contains(const Tile& outer, const Tile& inner) {
    return outer.left <= inner.left && inner.left < outer.left + outer.width &&
           outer.top <= inner.top && inner.top < outer.top + outer.height;
}

// Adds a tile that differs, unless it contains a tile that is already in the list: the same tile,
// or one of this block's tiles, which says more.
void add_tile(std::vector<TileStatistics>& tiles, const TileStatistics& tile) {
    for (const TileStatistics& other : tiles)
        if (contains(tile.tile, other.tile)) return;
    tiles.push_back(tile);
}

// The allowed probability of a false alarm is divided: four tenths are for the tiles, and two
// tenths for each of the three tests of the whole picture.
void confirm(Comparison& comparison, const Suspects& suspected) {
    const PictureStatistics& statistics = comparison.statistics;
    const auto tests = local_tests(statistics);
    const double bar =
        wronged * 0.4 / static_cast<double>(std::max<std::size_t>(1, suspected.tests.size()));
    for (const std::size_t i : suspected.tests)
        if (tests[i].p < bar)
            add_tile(tests[i].of_noise ? comparison.noise_differs_in : comparison.light_differs_in,
                     *tests[i].tile);
    const auto sure = [](bool suspect, double p) { return suspect && p < wronged * 0.2; };
    comparison.pixels_differ = sure(suspected.pixels, statistics.pixels_p);
    comparison.pixel_noise_differs = sure(suspected.pixel_noise, statistics.pixel_noise.p);
    comparison.tile_noise_differs = sure(suspected.tile_noise, statistics.tile_noise.p);
}

void add_still_tiles(Comparison& comparison) {
    for (const TileStatistics& tile : comparison.statistics.tiles)
        if (tile.still_differing > 0) comparison.light_differs_in.push_back(tile);
}

// Draws with both programs at the same time, because most programs use a single core.
std::pair<Picture, Picture> draw_both(const TwoPrograms& programs, std::uint64_t my_seed,
                                      std::uint64_t solutions_seed) {
    auto solution = std::async(std::launch::async, programs.solution, solutions_seed);
    Picture mine = programs.mine(my_seed);
    return {std::move(mine), solution.get()};
}

// Draws both programs' pictures for one step and appends them. False if their sizes differ.
bool draw_step(const TwoPrograms& programs, Seeds& seeds, int pictures, Comparison& comparison) {
    comparison.pictures = pictures;
    for (int i = 0; i < pictures; ++i) {
        const auto [mine, solution] = draw_both(programs, seeds(), seeds());
        comparison.mine.push_back(mine);
        comparison.solution.push_back(solution);
        if (!same_size(comparison.mine.back(), comparison.solution.back())) return false;
    }
    return true;
}

PictureStatistics test_last_step(const Comparison& comparison) {
    return statistics_of(
        {comparison.mine.end() - comparison.pictures, comparison.mine.end()},
        {comparison.solution.end() - comparison.pictures, comparison.solution.end()});
}

// Whether both programs draw the same pictures, bit for bit, from the same random numbers.
bool bit_for_bit(const TwoPrograms& programs, Seeds& seeds, Comparison& comparison) {
    for (int i = 0; i < 2; ++i) {
        const std::uint64_t seed = seeds();
        const auto [mine, solution] = draw_both(programs, seed, seed);
        if (mine != solution) return false;
        comparison.mine.push_back(mine);
        comparison.solution.push_back(solution);
    }
    return true;
}

// The region whose pixels differ most, beyond what the noise explains.
std::vector<std::string> pixel_regions(const Comparison& comparison) {
    const auto& tiles = comparison.statistics.tiles;
    const auto most = std::max_element(
        tiles.begin(), tiles.end(),
        [](const auto& a, const auto& b) { return a.pixel_excess < b.pixel_excess; });
    return regions_of({*most}, comparison.mine.front().width, comparison.mine.front().height);
}

}  // namespace

Comparison compare_still(const Picture& mine, const Picture& solution) {
    Comparison comparison;
    comparison.mine = {mine};
    comparison.solution = {solution};
    comparison.sizes_differ = !same_size(mine, solution);
    if (comparison.sizes_differ) return comparison;
    comparison.bit_for_bit = mine == solution;
    comparison.statistics = statistics_of(comparison.mine, comparison.solution);
    comparison.same = !comparison.statistics.still_differs();
    if (!comparison.same) add_still_tiles(comparison);
    return comparison;
}

Comparison compare(const TwoPrograms& programs, std::uint64_t start) {
    Seeds seeds{start};
    if (!programs.random) {
        const auto [mine, solution] = draw_both(programs, start, start);
        return compare_still(mine, solution);
    }

    Comparison comparison;
    if (bit_for_bit(programs, seeds, comparison)) {
        comparison.pictures = 2;
        comparison.statistics = statistics_of(comparison.mine, comparison.solution);
        comparison.same = comparison.bit_for_bit = true;
        return comparison;
    }
    comparison.mine.clear();
    comparison.solution.clear();
    if (!draw_step(programs, seeds, first_step, comparison)) {
        comparison.sizes_differ = true;
        return comparison;
    }
    comparison.statistics = test_last_step(comparison);
    if (comparison.statistics.still_differs()) {
        add_still_tiles(comparison);
        for (const TileStatistics& tile : comparison.statistics.tiles)
            if (tile.still_differing == 0 &&
                *std::min_element(tile.p.begin(), tile.p.end()) < wronged / 1'000'000)
                comparison.light_differs_in.push_back(tile);
        return comparison;
    }
    const Suspects suspected = suspects(comparison.statistics);
    if (suspected.any()) {
        if (!draw_step(programs, seeds, suspected.many ? short_second_step : second_step,
                       comparison)) {
            comparison.sizes_differ = true;
            return comparison;
        }
        comparison.statistics = test_last_step(comparison);
        confirm(comparison, suspected);
    }
    comparison.same = comparison.light_differs_in.empty() && comparison.noise_differs_in.empty() &&
                      !comparison.pixels_differ && !comparison.pixel_noise_differs &&
                      !comparison.tile_noise_differs;
    return comparison;
}

std::string Comparison::regions() const {
    std::vector<TileStatistics> tiles = light_differs_in;
    tiles.insert(tiles.end(), noise_differs_in.begin(), noise_differs_in.end());
    std::string text;
    for (const std::string& region : regions_of(tiles, mine.front().width, mine.front().height))
        text += (text.empty() ? "" : ", ") + region;
    return text;
}

std::vector<std::string> Comparison::words() const {
    const auto number = [](const char* format, auto... values) {
        char text[200];
        std::snprintf(text, sizeof text, format, values...);
        return std::string(text);
    };
    if (sizes_differ)
        return {number("Your picture has %dx%d pixels, the solution's %dx%d.", mine.back().width,
                       mine.back().height, solution.back().width, solution.back().height)};
    if (bit_for_bit) return {"The same as the solution's, bit for bit."};
    if (same && pictures == 1)
        return {
            number("The same: %ld of %ld pixels differ by more than 1 of 255 steps; up to %ld are "
                   "allowed.",
                   statistics.still_differing, statistics.pixels, statistics.pixels / 1000)};
    if (same)
        return {
            number("The same within the noise: %zu pictures of each were drawn, with different "
                   "random numbers.",
                   mine.size())};

    std::vector<std::string> lines{"It differs from the solution's."};
    if (statistics.still_differs())
        lines.push_back(
            number("%ld of %ld pixels differ by more than 1 of 255 steps; up to %ld are allowed.",
                   statistics.still_differing, statistics.pixels, statistics.pixels / 1000));
    for (const std::string& line : describe_by_region(light_differs_in, statistics.tiles,
                                                      mine.front().width, mine.front().height))
        lines.push_back(line);
    if (light_differs_in.empty()) lines.push_back("The light of every tile is right on average.");
    if (light_differs_in.empty() && pixels_differ)
        for (const std::string& region : pixel_regions(*this))
            lines.push_back(region +
                            ": single pixels differ, as if their samples lay at other points");
    if (pixel_noise_differs)
        lines.push_back(number("noise: a pixel's variance is %.2g times the solution's",
                               statistics.pixel_noise.ratio));
    if (tile_noise_differs)
        lines.push_back(
            number("noise: the variance of a tile of %dx%d pixels is %.2g times the solution's",
                   tile_side, tile_side, statistics.tile_noise.ratio));
    if (light_differs_in.empty() && !pixels_differ && !pixel_noise_differs && !tile_noise_differs)
        for (const std::string& region :
             regions_of(noise_differs_in, mine.front().width, mine.front().height))
            lines.push_back(region + ": noisier or smoother than the solution's");
    return lines;
}

}  // namespace companion
