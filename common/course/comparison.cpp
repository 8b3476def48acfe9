#include <algorithm>
#include <course/comparison.hpp>
#include <course/places.hpp>
#include <cstdio>
#include <future>
#include <rt/rng.hpp>

namespace course {
namespace {

constexpr int pictures_a_step = 8;
constexpr double screening = 0.0005;  // of each test of the first step
constexpr double wronged = 0.001;     // right programs that the second step calls wrong

// Seeds that have nothing to do with each other, so that no simple way to use them makes pictures
// alike.
class Seeds {
  public:
    explicit Seeds(std::uint64_t start) : next_{start << 20} {}
    std::uint64_t operator()() { return rt::mix_bits(next_++) >> 1; }

  private:
    std::uint64_t next_;
};

bool same_size(const Picture& a, const Picture& b) {
    return a.width == b.width && a.height == b.height;
}

// What the first step suspects.
struct Suspects {
    std::vector<std::size_t> tests;  // tile and channel: 3 * tile + channel
    bool pixel_noise = false, tile_noise = false;

    bool any() const { return !tests.empty() || pixel_noise || tile_noise; }
};

Suspects suspects(const PictureTest& test) {
    Suspects found;
    for (std::size_t i = 0; i < 3 * test.tiles.size(); ++i)
        if (test.tiles[i / 3].p[i % 3] < screening) found.tests.push_back(i);
    found.pixel_noise = test.pixel_noise.p < screening;
    found.tile_noise = test.tile_noise.p < screening;
    return found;
}

// Half of the chance to err goes to the tiles, a quarter to either test of the noise.
void confirm(Comparison& comparison, const Suspects& suspected) {
    const PictureTest& test = comparison.test;
    const double bar =
        wronged / 2 / static_cast<double>(std::max<std::size_t>(1, suspected.tests.size()));
    std::vector<bool> differs(test.tiles.size());
    for (const std::size_t i : suspected.tests)
        if (test.tiles[i / 3].p[i % 3] < bar) differs[i / 3] = true;
    for (std::size_t i = 0; i < test.tiles.size(); ++i)
        if (differs[i]) comparison.places.push_back(test.tiles[i]);
    comparison.pixel_noise_differs = suspected.pixel_noise && test.pixel_noise.p < wronged / 4;
    comparison.tile_noise_differs = suspected.tile_noise && test.tile_noise.p < wronged / 4;
}

void add_still_places(Comparison& comparison) {
    for (const TileTest& tile : comparison.test.tiles)
        if (tile.still_differing > 0) comparison.places.push_back(tile);
}

// At the same time: most programs use one core.
std::pair<Picture, Picture> draw_both(const Drawn& drawn, std::uint64_t my_seed,
                                      std::uint64_t solutions_seed) {
    auto solution = std::async(std::launch::async, drawn.solution, solutions_seed);
    Picture mine = drawn.mine(my_seed);
    return {std::move(mine), solution.get()};
}

// Draws one step's pictures of both programs and appends them. False where the sizes differ.
bool draw_step(const Drawn& drawn, Seeds& seeds, Comparison& comparison) {
    for (int i = 0; i < pictures_a_step; ++i) {
        const auto [mine, solution] = draw_both(drawn, seeds(), seeds());
        comparison.mine.push_back(mine);
        comparison.solution.push_back(solution);
        if (!same_size(comparison.mine.back(), comparison.solution.back())) return false;
    }
    return true;
}

PictureTest test_last_step(const Comparison& comparison) {
    return test_pictures({comparison.mine.end() - pictures_a_step, comparison.mine.end()},
                         {comparison.solution.end() - pictures_a_step, comparison.solution.end()});
}

// With the same random numbers equal code draws equal pictures.
bool bit_for_bit(const Drawn& drawn, Seeds& seeds, Comparison& comparison) {
    for (int i = 0; i < 2; ++i) {
        const std::uint64_t seed = seeds();
        const auto [mine, solution] = draw_both(drawn, seed, seed);
        if (mine != solution) return false;
        comparison.mine.push_back(mine);
        comparison.solution.push_back(solution);
    }
    return true;
}

}  // namespace

Comparison compare_still(const Picture& mine, const Picture& solution) {
    Comparison comparison;
    comparison.mine = {mine};
    comparison.solution = {solution};
    comparison.sizes_differ = !same_size(mine, solution);
    if (comparison.sizes_differ) return comparison;
    comparison.bit_for_bit = mine == solution;
    comparison.test = test_pictures(comparison.mine, comparison.solution);
    comparison.same = !comparison.test.still_differs();
    if (!comparison.same) add_still_places(comparison);
    return comparison;
}

Comparison compare(const Drawn& drawn, std::uint64_t start) {
    Seeds seeds{start};
    if (!drawn.random) {
        const auto [mine, solution] = draw_both(drawn, start, start);
        return compare_still(mine, solution);
    }

    Comparison comparison;
    if (bit_for_bit(drawn, seeds, comparison)) {
        comparison.pictures = 2;
        comparison.test = test_pictures(comparison.mine, comparison.solution);
        comparison.same = comparison.bit_for_bit = true;
        return comparison;
    }
    comparison.mine.clear();
    comparison.solution.clear();
    comparison.pictures = pictures_a_step;
    if (!draw_step(drawn, seeds, comparison)) {
        comparison.sizes_differ = true;
        return comparison;
    }
    comparison.test = test_last_step(comparison);
    if (comparison.test.still_differs()) {
        add_still_places(comparison);
        for (const TileTest& tile : comparison.test.tiles)
            if (tile.still_differing == 0 && tile.least_p() < 1e-9)
                comparison.places.push_back(tile);
        return comparison;
    }
    const Suspects suspected = suspects(comparison.test);
    if (suspected.any()) {
        comparison.pictures += pictures_a_step;
        if (!draw_step(drawn, seeds, comparison)) {
            comparison.sizes_differ = true;
            return comparison;
        }
        comparison.test = test_last_step(comparison);
        confirm(comparison, suspected);
    }
    comparison.same = comparison.places.empty() && !comparison.pixel_noise_differs &&
                      !comparison.tile_noise_differs;
    return comparison;
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
        return {number("The same: %ld of %ld pixels differ by more than a step of 255; %ld may.",
                       test.still_differing, test.pixels, test.pixels / 1000)};
    if (same)
        return {number("The same within noise: %d pictures of each, with other random numbers.",
                       pictures)};

    std::vector<std::string> lines{"It differs from the solution's."};
    if (test.still_differs())
        lines.push_back(number("%ld of %ld pixels differ by more than a step of 255; %ld may.",
                               test.still_differing, test.pixels, test.pixels / 1000));
    for (const std::string& place :
         describe_places(places, test.tiles, mine.front().width, mine.front().height))
        lines.push_back(place);
    if (places.empty() && (pixel_noise_differs || tile_noise_differs))
        lines.push_back("The light is right on average, but not its noise:");
    if (pixel_noise_differs)
        lines.push_back(
            number("a pixel's variance is %.2g times the solution's", test.pixel_noise.ratio));
    if (tile_noise_differs)
        lines.push_back(
            number("neighbouring pixels vary together: the variance of a tile's mean is "
                   "%.2g times the solution's",
                   test.tile_noise.ratio));
    return lines;
}

}  // namespace course
