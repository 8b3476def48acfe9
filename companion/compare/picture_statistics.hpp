#pragma once
// Do two programs draw the same picture? Judged from pictures of each with different random
// numbers. The only assumption about the noise is that right programs have the same.
//
// A pixel that shows one value in all pictures of a program, for both programs, is still: there the
// two values must be the same except for rounding. All other pixels are noisy. Over them, each 16 x
// 16 tile has a mean of linear light in each picture, and Welch's t-test compares the two programs'
// means. The same is done for blocks of 4 x 4 tiles. A byte is a coarse measure of light, but the
// same for both programs, so rounding causes no false alarm; and the noise takes a pixel across
// many bytes, so that the mean is finer than a byte.
//
// Where light and dark pixels balance each other in a tile, a test that looks at each pixel sees
// it: it asks how far apart the programs' mean pictures are, and how far apart they would be if the
// same pictures had been dealt out to the two programs in another way.
//
// Means alone would not reveal a program whose samples all take the same path: its light is right
// on average. So the noise is compared, too.

#include <array>
#include <companion/compare/picture.hpp>

namespace companion {

constexpr int tile_side = 16, block_side = 4 * tile_side;

struct Tile {
    int left = 0, top = 0, width = 0, height = 0;
};

// The tiles of a picture, row by row; those at the right and lower edges may be smaller.
std::vector<Tile> tiles_of(int width, int height, int side = tile_side);

// What was found in a tile, for red, green and blue.
struct TileStatistics {
    Tile tile;
    std::array<double, 3> mine{}, solution{};  // mean linear light of all its pixels
    std::array<double, 3> p{1, 1, 1};          // of Welch's test on the light
    // Welch's test on how far the pixels are from their means; and the variance
    // relative to the solution's.
    std::array<double, 3> noise_p{1, 1, 1}, noise_ratio{1, 1, 1};
    long still_differing = 0;  // pixels
    // The mean square difference between the programs' mean pictures, pixel by pixel, beyond what
    // the noise explains, relative to the noise of one picture. About 0 for right programs.
    double pixel_excess = 0;
};

// How much a program's pictures vary, compared with the other's: 1 is as much, 4 is
// four times the variance.
struct NoiseStatistics {
    double ratio = 1, p = 1;
};

struct PictureStatistics {
    std::vector<TileStatistics> tiles;
    std::vector<TileStatistics> blocks;    // of 4 x 4 tiles: for what is too faint in a tile
    long pixels = 0, still_differing = 0;  // by more than one step of 255
    int largest_step = 0;                  // of a still pixel
    NoiseStatistics pixel_noise;           // of each pixel by itself
    NoiseStatistics tile_noise;            // of the tiles' means: neighbors that vary together
    double pixels_p = 1;                   // of the mean pictures, pixel by pixel

    // As for pictures without randomness: at most one pixel in a thousand.
    bool still_differs() const { return 1000 * still_differing > pixels; }
};

// Compares pictures, all of one size: one of each program, or at least two of each with
// different random numbers.
PictureStatistics statistics_of(const std::vector<Picture>& mine,
                                const std::vector<Picture>& solution);

}  // namespace companion
