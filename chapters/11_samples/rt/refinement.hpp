#pragma once
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <rt/canvas.hpp>
#include <rt/color_sum.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/image.hpp>
#include <rt/portable.hpp>
#include <rt/render_tiles.hpp>
#include <rt/rng.hpp>
#include <rt/running_variance.hpp>
#include <rt/twin_halves.hpp>
#include <vector>

namespace rt {

// A pass: a few samples of each pixel (given). Each seed has passes 0, 1, 2 ...
struct Pass {
    std::uint64_t seed = 1;
    int number = 0;
};

// A seed for a pass, so that no two passes share samples.
inline std::uint64_t seed_of(const Pass& pass) {
    return mix_bits(pass.seed) + static_cast<std::uint64_t>(pass.number);
}

// Draws a pass of a tile's pixels into the image, and adds the number of rays to `rays`.
using DrawPass = std::function<void(const Tile&, const Pass&, Image& image, std::uint64_t& rays)>;

// How a picture is refined (given).
struct RefinementPlan {
    TileGrid grid;
    int threads = 1;
    std::uint64_t seed = 1;
    std::function<DrawPass()> make_worker;  // one for each thread
    // Says whether to stop early; called before each pass of a tile.
    std::function<bool()> is_over = [] { return false; };
    // Called before each round, with the number of its passes, summed over all tiles.
    std::function<void(std::int64_t passes)> on_round = [](std::int64_t) {};
};

// A picture in two independent halves (given). Each half takes more samples where the other half
// found more noise. The picture depends on what the plan draws, on its seed and on the calls, but
// never on the number of threads.
//
// Each half decides how many samples every tile gets in the other half, which keeps each tile
// unbiased. But both halves together decide the total number of samples in refine_to, which stops
// according to the error estimated from both. If the error is spread over many pixels, this does no
// harm. But if samples that are rare and very bright cause nearly all of the error, refine_to stops
// early if no such sample has come, and goes on if one has: it loses up to half of the light of
// such samples. refine_with loses none, because its number of passes is fixed in advance.
class Refinement {
  public:
    explicit Refinement(RefinementPlan plan)
        : plan_{std::move(plan)},
          sums_(plan_.grid.width, plan_.grid.height),
          pass_{Canvas<Color>{plan_.grid.width, plan_.grid.height}},
          tiles_(static_cast<std::size_t>(tile_count(plan_.grid))),
          workers_(static_cast<std::size_t>(plan_.threads)) {}

    // Draws the first passes of all tiles, `passes` in each half. With 2 or more, they tell where
    // there is noise. A tile's share of all later passes depends on these passes alone.
    void draw_pilot(int passes) {
        least_ = passes;
        // One pass of all tiles comes first, so that there is a picture soon.
        draw([](const TileState&) { return Halves<int>{1, 1}; });
        draw([passes](const TileState&) { return Halves<int>{passes, passes}; });
        Halves<double> sum;
        for (const TileState& tile : tiles_) {
            sum.first += static_cast<double>(tile.spread.first);
            sum.second += static_cast<double>(tile.spread.second);
        }
        const auto count = static_cast<double>(tiles_.size());
        mean_spread_ = {static_cast<Real>(sum.first / count),
                        static_cast<Real>(sum.second / count)};
    }

    // Refines until error() is at most `target`. Each round aims 3 % below the target, corrected by
    // how far the last round missed its aim, but at half of the previous round's aim if that is
    // larger (in the first round, at half of the present error).
    void refine_to(Real target) {
        Real aim = infinity;  // the error for which the last counts were computed
        while (!plan_.is_over()) {
            const Real now = error();
            if (now <= target) return;
            // The actual error differs from the one that the counts were computed for: Sobol's
            // points do better, and a pilot may have missed something.
            const Real promise = aim < infinity ? target * (aim / now) : target;
            aim = std::max(Real(0.97) * promise, (aim < infinity ? aim : now) / 2);
            draw([&](const TileState& tile) { return counts(tile, aim); });
        }
    }

    // Refines until this many passes are drawn, summed over all tiles, give or take one pass per
    // tile. Each half of the picture gets half of the passes. So that no half judges itself, each
    // half aims at an error of its own, which follows from what the other half has seen.
    void refine_with(std::int64_t passes) {
        const Halves<Real> aim{aim_of<&Halves<int>::first>(passes / 2),
                               aim_of<&Halves<int>::second>(passes - passes / 2)};
        draw([&](const TileState& tile) {
            return Halves<int>{counts(tile, aim.first).first, counts(tile, aim.second).second};
        });
    }

    // The root mean square error of the picture's channels, estimated from the difference of the
    // halves. Infinite until each half has a pass of every tile.
    Real error() const {
        double sum = 0;
        bool is_known = true;
        each_pixel([&](int x, int y, const TileState& tile) {
            is_known = is_known && tile.drawn.first > 0 && tile.drawn.second > 0;
            if (!is_known) return;
            const Halves<Color> half = means(x, y, tile);
            for (const auto channel : {&Color::r, &Color::g, &Color::b})
                sum += static_cast<double>(
                    twin_square_error({half.first.*channel, half.second.*channel}));
        });
        if (!is_known) return infinity;
        return static_cast<Real>(std::sqrt(sum / (3 * static_cast<double>(sums_.size()))));
    }

    // The picture as it is now. Where nothing has been drawn yet, it shows the
    // pixels of `unfinished`.
    Image picture(Image unfinished) const {
        each_pixel([&](int x, int y, const TileState& tile) {
            if (tile.drawn.first == 0) return;
            const Halves<Color> half = means(x, y, tile);
            for (const auto channel : {&Color::r, &Color::g, &Color::b})
                unfinished.at(x, y).*channel =
                    tile.drawn.second == 0 ? half.first.*channel
                                           : twin_mean({half.first.*channel, half.second.*channel});
        });
        return unfinished;
    }

    // The pictures of the halves. A half is black where it has not been drawn.
    Halves<Image> halves() const {
        Halves<Image> half{Canvas<Color>{sums_.width(), sums_.height()},
                           Canvas<Color>{sums_.width(), sums_.height()}};
        each_pixel([&](int x, int y, const TileState& tile) {
            const Halves<Color> mean = means(x, y, tile);
            half.first.at(x, y) = mean.first;
            half.second.at(x, y) = mean.second;
        });
        return half;
    }

    // How many passes both halves together have at a pixel.
    int passes_at(int x, int y) const {
        const Halves<int> drawn = tile_of(x, y).drawn;
        return drawn.first + drawn.second;
    }
    // The number of passes in both halves, summed over all tiles.
    std::int64_t passes() const {
        return std::accumulate(tiles_.begin(), tiles_.end(), std::int64_t{0},
                               [](std::int64_t sum, const TileState& tile) {
                                   return sum + tile.drawn.first + tile.drawn.second;
                               });
    }
    std::uint64_t rays() const { return rays_; }
    // The share of the picture's tiles that have a pass, 0 to 1.
    double share() const {
        const auto begun = std::count_if(tiles_.begin(), tiles_.end(), [](const TileState& tile) {
            return tile.drawn.first > 0;
        });
        return static_cast<double>(begun) / static_cast<double>(tiles_.size());
    }

  private:
    struct TileState {
        Halves<int> drawn;    // passes
        Halves<Real> spread;  // the standard deviation of a pass, in one channel
    };
    static constexpr int most_passes = 1 << 24;  // nobody waits for more

    Halves<int> counts(const TileState& tile, Real aim) const {
        return crossed_counts(tile.spread, mean_spread_, aim, {least_, most_passes});
    }
    // The number of passes, summed over all tiles, that one half will have if it aims at this
    // error.
    template <int Halves<int>::*half>
    std::int64_t planned(Real aim) const {
        std::int64_t sum = 0;
        for (const TileState& tile : tiles_)
            sum += std::max(counts(tile, aim).*half, tile.drawn.*half);
        return sum;
    }
    // The smallest aim for which one half needs no more than this many passes.
    template <int Halves<int>::*half>
    Real aim_of(std::int64_t passes) const {
        // Searches for the logarithm of the error, between bounds that are wide enough
        // for any picture.
        Real low = std::numeric_limits<Real>::min_exponent / 4, high = -low;
        for (int step = 0; step < 60; ++step) {
            const Real middle = (low + high) / 2;
            (planned<half>(portable::exp2(middle)) > passes ? low : high) = middle;
        }
        return portable::exp2(high);
    }

    std::size_t index(int x, int y) const {
        const int side = plan_.grid.tile_size;
        const int columns = (plan_.grid.width - 1) / side + 1;
        return static_cast<std::size_t>(y / side) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(x / side);
    }
    const TileState& tile_of(int x, int y) const { return tiles_[index(x, y)]; }

    template <class Visit>
    void each_pixel(const Visit& visit) const {
        for (int y = 0; y < sums_.height(); ++y)
            for (int x = 0; x < sums_.width(); ++x) visit(x, y, tile_of(x, y));
    }

    // Black before the first pass.
    static Color mean(const ColorSum& sum, int passes) { return sum.mean(std::max(passes, 1)); }

    Halves<Color> means(int x, int y, const TileState& tile) const {
        const Halves<ColorSum>& sum = sums_.at(x, y);
        return {mean(sum.first, tile.drawn.first), mean(sum.second, tile.drawn.second)};
    }

    // Draws passes until each tile has as many as wanted(tile) asks for.
    template <class Wanted>
    void draw(const Wanted& wanted) {
        std::int64_t missing = 0;
        for (const TileState& tile : tiles_) {
            const Halves<int> passes = wanted(tile);
            missing += std::max(passes.first - tile.drawn.first, 0) +
                       std::max(passes.second - tile.drawn.second, 0);
        }
        plan_.on_round(missing);
        render_tiles(plan_.grid, plan_.threads, [&](const Tile& tile, int worker) {
            DrawPass& draw_pass = workers_[static_cast<std::size_t>(worker)];
            if (!draw_pass) draw_pass = plan_.make_worker();
            TileState& state = tiles_[index(tile.left, tile.top)];
            const Halves<int> passes = wanted(state);
            draw_half<&Halves<ColorSum>::first>(draw_pass, tile, plan_.seed, passes.first,
                                                state.drawn.first, state.spread.first);
            draw_half<&Halves<ColorSum>::second>(draw_pass, tile, ~plan_.seed, passes.second,
                                                 state.drawn.second, state.spread.second);
        });
    }

    // Draws one half of a tile until it has `passes` passes. If these passes are the pilot, they
    // determine the half's spread.
    template <ColorSum Halves<ColorSum>::*half>
    void draw_half(const DrawPass& draw_pass, const Tile& tile, std::uint64_t seed, int passes,
                   int& drawn, Real& spread) {
        const bool is_pilot = drawn < 2 && passes >= 2;
        std::vector<RunningVariance> channels;
        const auto learn = [&] {
            std::size_t next = 0;
            for_each_pixel(tile, [&](int x, int y) {
                const Color& color = pass_.at(x, y);
                for (const Real channel : {color.r, color.g, color.b})
                    add(channels[next++], channel);
            });
        };
        if (is_pilot) {
            channels.resize(3 * static_cast<std::size_t>(pixel_count(tile)));
            for_each_pixel(
                tile, [&](int x, int y) { pass_.at(x, y) = mean(sums_.at(x, y).*half, drawn); });
            if (drawn == 1) learn();
        }
        std::uint64_t rays = 0;
        for (; drawn < passes && !plan_.is_over(); ++drawn) {
            draw_pass(tile, {seed, drawn}, pass_, rays);
            for_each_pixel(tile, [&](int x, int y) { (sums_.at(x, y).*half).add(pass_.at(x, y)); });
            if (is_pilot) learn();
        }
        rays_ += rays;
        if (!is_pilot || drawn < 2) return;
        double sum = 0;
        for (const RunningVariance& channel : channels)
            sum += static_cast<double>(variance(channel));
        spread = static_cast<Real>(std::sqrt(sum / static_cast<double>(channels.size())));
    }

    RefinementPlan plan_;
    Canvas<Halves<ColorSum>> sums_;  // of both halves' passes
    Image pass_;                     // the pass being drawn; each worker writes its own tile
    std::vector<TileState> tiles_;
    std::vector<DrawPass> workers_;
    std::atomic<std::uint64_t> rays_ = 0;
    Halves<Real> mean_spread_;
    int least_ = 1;
};

}  // namespace rt
