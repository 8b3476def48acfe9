#include <algorithm>
#include <course/picture_test.hpp>
#include <course/student_t.hpp>
#include <cstdlib>

namespace course {
namespace {

using Pictures = std::vector<Picture>;

// Both programs' pictures, with what each byte means.
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

// The numbers of a tile's pixels.
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

// How much each picture differs from the mean of all, in all that is added.
class Variation {
  public:
    explicit Variation(std::size_t pictures) : of_picture_(pictures) {}

    // Squared distances from the mean, a picture each. Dark and light places, calm and wild ones
    // count alike: what matters is how the pictures share the variance.
    void add(const std::vector<double>& squares) {
        double sum = 0;
        for (const double square : squares) sum += square;
        if (sum == 0) return;
        for (std::size_t i = 0; i < squares.size(); ++i) of_picture_[i] += squares[i] / sum;
        ++count_;
    }
    NoiseTest test(const Both& both) const {
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

// The tile's still pixels: counts those that differ, and returns the others, the noisy ones.
std::vector<std::size_t> sort_out_still(const Both& both, TileTest& test, PictureTest& all) {
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

// The variance that the mean of a channel has from rounding to bytes.
double rounding_variance(const Both& both, const std::vector<std::size_t>& pixels,
                         std::size_t channel) {
    double sum = 0;
    for (const std::size_t pixel : pixels) {
        const int byte = std::clamp<int>(both.byte(0, 3 * pixel + channel), 1, 254);
        const double step = (light_of(static_cast<std::uint8_t>(byte + 1)) -
                             light_of(static_cast<std::uint8_t>(byte - 1))) /
                            2;
        sum += step * step / 12;
    }
    const auto n = static_cast<double>(pixels.size());
    return sum / (n * n * static_cast<double>(both.count()));
}

void test_noisy(const Both& both, const std::vector<std::size_t>& noisy, TileTest& test,
                Variation& pixel_variation, Variation& tile_variation) {
    const std::size_t count = both.count();
    const auto n = static_cast<double>(noisy.size()), pictures = static_cast<double>(count);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        std::vector<double> light(count), means(count), squares(count);
        for (const std::size_t pixel : noisy) {
            double mean = 0;
            for (std::size_t k = 0; k < count; ++k) {
                light[k] = light_of(both.byte(k, 3 * pixel + channel));
                means[k] += light[k] / n;
                mean += light[k] / pictures;
            }
            for (std::size_t k = 0; k < count; ++k)
                squares[k] += (light[k] - mean) * (light[k] - mean);
        }
        test.p[channel] = welch_p(mine_of(both, means), solution_of(both, means),
                                  rounding_variance(both, noisy, channel));
        pixel_variation.add(squares);
        tile_variation.add(squared_distances(means));
    }
}

double mean_light(const Pictures& pictures, const Tile& tile, std::size_t channel) {
    const auto pixels = pixels_of(tile, pictures.front().width);
    double sum = 0;
    for (const Picture& picture : pictures)
        for (const std::size_t pixel : pixels) sum += light_of(picture.bytes[3 * pixel + channel]);
    return sum / static_cast<double>(pixels.size() * pictures.size());
}

}  // namespace

std::vector<Tile> tiles_of(int width, int height) {
    std::vector<Tile> tiles;
    for (int top = 0; top < height; top += tile_side)
        for (int left = 0; left < width; left += tile_side)
            tiles.push_back(
                {left, top, std::min(tile_side, width - left), std::min(tile_side, height - top)});
    return tiles;
}

PictureTest test_pictures(const Pictures& mine, const Pictures& solution) {
    const Both both{mine, solution};
    PictureTest all;
    all.pixels = mine.front().pixels();
    Variation pixel_variation{both.count()}, tile_variation{both.count()};
    for (const Tile& tile : tiles_of(both.width(), mine.front().height)) {
        TileTest test{tile};
        for (std::size_t channel = 0; channel < 3; ++channel) {
            test.mine[channel] = mean_light(mine, tile, channel);
            test.solution[channel] = mean_light(solution, tile, channel);
        }
        const auto noisy = sort_out_still(both, test, all);
        if (!noisy.empty()) test_noisy(both, noisy, test, pixel_variation, tile_variation);
        all.still_differing += test.still_differing;
        all.tiles.push_back(test);
    }
    all.pixel_noise = pixel_variation.test(both);
    all.tile_noise = tile_variation.test(both);
    return all;
}

}  // namespace course
