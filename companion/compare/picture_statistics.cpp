#include <algorithm>
#include <companion/compare/permutation.hpp>
#include <companion/compare/picture_statistics.hpp>
#include <companion/compare/student_t.hpp>
#include <cstdlib>

namespace companion {
namespace {

using Pictures = std::vector<Picture>;

// Both programs' pictures, and the light that each byte stands for.
struct Both {
    const Pictures& mine;
    const Pictures& solution;

    std::size_t count() const { return mine.size() + solution.size(); }
    std::uint8_t byte(std::size_t picture, std::size_t i) const {
        return picture < mine.size() ? mine[picture].bytes[i]
                                     : solution[picture - mine.size()].bytes[i];
    }
    int width() const { return mine.front().width; }
};

bool is_constant(const Pictures& pictures, std::size_t pixel) {
    const auto at = [&](const Picture& picture) { return picture.bytes.data() + 3 * pixel; };
    return std::all_of(pictures.begin() + 1, pictures.end(), [&](const Picture& picture) {
        return std::equal(at(picture), at(picture) + 3, at(pictures.front()));
    });
}

// The indices of a tile's pixels.
std::vector<std::size_t> pixels_of(const Tile& tile, int width) {
    std::vector<std::size_t> pixels;
    for (int y = tile.top; y < tile.top + tile.height; ++y)
        for (int x = tile.left; x < tile.left + tile.width; ++x)
            pixels.push_back(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(x));
    return pixels;
}

Sample mine_of(const Both& both, const std::vector<double>& values) {
    return describe({values.begin(), values.begin() + static_cast<long>(both.mine.size())});
}
Sample solution_of(const Both& both, const std::vector<double>& values) {
    return describe({values.begin() + static_cast<long>(both.mine.size()), values.end()});
}

// How much each picture differs from the mean of all, summed over the pixels that are added.
class Variation {
  public:
    explicit Variation(std::size_t pictures) : of_picture_(pictures) {}

    // Adds squared distances from the mean, one per picture. Dark and bright, calm and noisy
    // regions count the same: what matters is how the variance is divided among the pictures.
    void add(const std::vector<double>& squares) {
        double sum = 0;
        for (const double square : squares) sum += square;
        if (sum == 0) return;
        for (std::size_t i = 0; i < squares.size(); ++i) of_picture_[i] += squares[i] / sum;
        ++count_;
    }
    NoiseStatistics test(const Both& both) const {
        if (count_ == 0) return {};
        const Sample mine = mine_of(both, of_picture_), solution = solution_of(both, of_picture_);
        return {mine.mean / solution.mean, welch_p(mine, solution)};
    }

  private:
    std::vector<double> of_picture_;
    long count_ = 0;
};

std::vector<double> squared_distances(const std::vector<double>& values) {
    const double mean = describe(values).mean;
    std::vector<double> squares;
    for (const double value : values) squares.push_back((value - mean) * (value - mean));
    return squares;
}

// Handles the tile's still pixels: counts those that differ, and returns the other pixels of the
// tile, which are noisy.
std::vector<std::size_t> sort_out_still(const Both& both, TileStatistics& test,
                                        PictureStatistics& all) {
    std::vector<std::size_t> noisy;
    for (const std::size_t pixel : pixels_of(test.tile, both.width())) {
        if (!is_constant(both.mine, pixel) || !is_constant(both.solution, pixel)) {
            noisy.push_back(pixel);
            continue;
        }
        int step = 0;
        for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
            step = std::max(step, std::abs(both.mine[0].bytes[i] - both.solution[0].bytes[i]));
        all.largest_step = std::max(all.largest_step, step);
        test.still_differing += step > 1;
    }
    return noisy;
}

// For each channel, sums over the noisy pixels of a tile or block.
struct Sums {
    struct Channel {
        std::vector<double> light, squares;  // for each picture; squares: distances from the mean
        double rounding = 0;                 // the part of the variance that rounding causes
    };
    std::array<Channel, 3> channels;
    Products products;

    explicit Sums(std::size_t pictures) : products{pictures} {
        for (Channel& channel : channels) {
            channel.light.resize(pictures);
            channel.squares.resize(pictures);
        }
    }
    void add(const Both& both, std::size_t pixel) {
        const std::size_t count = both.count();
        for (std::size_t c = 0; c < 3; ++c) {
            Channel& channel = channels[c];
            std::vector<double> light(count);
            double mean = 0;
            for (std::size_t k = 0; k < count; ++k) {
                light[k] = light_of(both.byte(k, 3 * pixel + c));
                mean += light[k] / static_cast<double>(count);
            }
            for (std::size_t k = 0; k < count; ++k) {
                channel.light[k] += light[k];
                light[k] -= mean;
                channel.squares[k] += light[k] * light[k];
            }
            products.add(light);
            const int byte = std::clamp<int>(both.byte(0, 3 * pixel + c), 1, 254);
            const double two_steps = light_of(static_cast<std::uint8_t>(byte + 1)) -
                                     light_of(static_cast<std::uint8_t>(byte - 1));
            channel.rounding += two_steps * two_steps / 48;
        }
    }
    void add(const Sums& other) {
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t k = 0; k < channels[c].light.size(); ++k) {
                channels[c].light[k] += other.channels[c].light[k];
                channels[c].squares[k] += other.channels[c].squares[k];
            }
            channels[c].rounding += other.channels[c].rounding;
        }
    }
};

void test_sums(const Both& both, const Sums& sums, TileStatistics& test) {
    for (std::size_t c = 0; c < 3; ++c) {
        const Sums::Channel& channel = sums.channels[c];
        test.p[c] = welch_p(mine_of(both, channel.light), solution_of(both, channel.light),
                            channel.rounding / static_cast<double>(both.count()));
        const Sample mine = mine_of(both, channel.squares),
                     solution = solution_of(both, channel.squares);
        test.noise_p[c] = welch_p(mine, solution, channel.rounding * channel.rounding);
    }
}

double excess(const Both& both, const Products& products) {
    std::vector<bool> mine(both.count());
    std::fill(mine.begin(), mine.begin() + static_cast<long>(both.mine.size()), true);
    const double between = products.between(mine);
    // The variance within the two sets is the total variance minus that between them; the mean of n
    // pictures has 1/n of it.
    const auto a = static_cast<double>(both.mine.size()),
               b = static_cast<double>(both.solution.size());
    const double within = (products.total() - between * a * b / (a + b)) / (a + b - 2);
    return within > 0 ? between / within - (1 / a + 1 / b) : 0;
}

double mean_light(const Pictures& pictures, const Tile& tile, std::size_t channel) {
    const auto pixels = pixels_of(tile, pictures.front().width);
    double sum = 0;
    for (const Picture& picture : pictures)
        for (const std::size_t pixel : pixels) sum += light_of(picture.bytes[3 * pixel + channel]);
    return sum / static_cast<double>(pixels.size() * pictures.size());
}

double mean_byte(const Pictures& pictures, std::size_t i) {
    double sum = 0;
    for (const Picture& picture : pictures) sum += picture.bytes[i];
    return sum / static_cast<double>(pictures.size());
}

TileStatistics untested(const Both& both, const Tile& tile) {
    TileStatistics test;
    test.tile = tile;
    for (const std::size_t pixel : pixels_of(tile, both.width()))
        for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
            test.largest_step = std::max(
                test.largest_step, std::abs(mean_byte(both.mine, i) - mean_byte(both.solution, i)));
    for (std::size_t channel = 0; channel < 3; ++channel) {
        test.mine[channel] = mean_light(both.mine, tile, channel);
        test.solution[channel] = mean_light(both.solution, tile, channel);
    }
    return test;
}

}  // namespace

std::vector<Tile> tiles_of(int width, int height, int side) {
    std::vector<Tile> tiles;
    for (int top = 0; top < height; top += side)
        for (int left = 0; left < width; left += side)
            tiles.push_back(
                {left, top, std::min(side, width - left), std::min(side, height - top)});
    return tiles;
}

PictureStatistics statistics_of(const Pictures& mine, const Pictures& solution) {
    const Both both{mine, solution};
    const int width = both.width(), height = mine.front().height;
    PictureStatistics all;
    all.pixels = mine.front().pixels();
    for (const Tile& block : tiles_of(width, height, block_side))
        all.blocks.push_back(untested(both, block));
    std::vector<Sums> block_sums(all.blocks.size(), Sums{both.count()});
    const int blocks_a_row = (width + block_side - 1) / block_side;

    Variation pixel_variation{both.count()}, tile_variation{both.count()};
    Products products{both.count()};
    for (const Tile& tile : tiles_of(width, height)) {
        TileStatistics test = untested(both, tile);
        Sums sums{both.count()};
        const auto noisy = sort_out_still(both, test, all);
        for (const std::size_t pixel : noisy) sums.add(both, pixel);
        if (!noisy.empty() && mine.size() > 1) {
            test_sums(both, sums, test);
            for (const Sums::Channel& channel : sums.channels) {
                pixel_variation.add(channel.squares);
                tile_variation.add(squared_distances(channel.light));
            }
            products.add_scaled(sums.products);
            test.pixel_excess = excess(both, sums.products);
            const int block = tile.top / block_side * blocks_a_row + tile.left / block_side;
            block_sums[static_cast<std::size_t>(block)].add(sums);
        }
        all.still_differing += test.still_differing;
        all.tiles.push_back(test);
    }
    if (mine.size() < 2) return all;
    for (std::size_t i = 0; i < all.blocks.size(); ++i)
        test_sums(both, block_sums[i], all.blocks[i]);
    all.pixels_p = permutation_p(products, mine.size(), both.count());
    all.pixel_noise = pixel_variation.test(both);
    all.tile_noise = tile_variation.test(both);
    return all;
}

}  // namespace companion
