#pragma once
// Do two programs draw the same picture? This is decided from several pictures of each program,
// with different random numbers. The only assumption about the noise is that all right programs
// have the same noise.
//
// A pixel is still if it shows one value in all of a program's pictures, for both programs: then
// the two values must be the same except for rounding. All other pixels are noisy. Their mean
// linear light is computed for each 16 x 16 tile of each picture, and Welch's t-test compares the
// two programs' means. The same is done for blocks of 4 x 4 tiles. A byte is a coarse measure of
// light, but it is the same for both programs, so rounding causes no false alarm; and because the
// noise spreads a pixel over many byte values, the mean is finer than a byte.
//
// If light and dark pixels balance each other in a tile, its mean is right. Another test therefore
// looks at each pixel: it asks how far apart the programs' mean pictures are, and how far apart
// they would be if the same pictures had been divided between the two programs in a different way.
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

// What was found in a tile, in red, green and blue.
struct TileStatistics {
    Tile tile;
    std::array<double, 3> mine{}, solution{};  // mean linear light of all its pixels
    std::array<double, 3> p{1, 1, 1};          // Welch's test on the light
    std::array<double, 3> noise_p{1, 1, 1};    // on the pixels' distances from their means
    long still_differing = 0;                  // still pixels that differ
    double largest_step = 0;  // of a pixel, between the programs' mean values, 0 to 255
    // The mean square difference between the programs' mean pictures, pixel by pixel, minus what
    // the noise explains, divided by the noise of a single picture. About 0 for right programs.
    double pixel_excess = 0;
};

// The variance of a program's pictures, divided by that of the other program's; and the p-value of
// the test that compares them.
struct NoiseStatistics {
    double ratio = 1, p = 1;
};

struct PictureStatistics {
    std::vector<TileStatistics> tiles;
    std::vector<TileStatistics> blocks;    // of 4 x 4 tiles: for what is too faint in a tile
    long pixels = 0, still_differing = 0;  // by more than one step of 255
    int largest_step = 0;                  // the largest difference of a still pixel
    NoiseStatistics pixel_noise;           // of each pixel by itself
    NoiseStatistics tile_noise;            // of the tiles' means: neighbors that vary together
    double pixels_p = 1;                   // the p-value of the test pixel by pixel

    // As in pictures without randomness, one pixel in a thousand may differ.
    bool still_differs() const { return 1000 * still_differing > pixels; }
};

// Compares pictures, all of one size: one of each program, or at least two of each with
// different random numbers.
PictureStatistics statistics_of(const std::vector<Picture>& mine,
                                const std::vector<Picture>& solution);

}  // namespace companion
