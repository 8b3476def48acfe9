#pragma once
// Do two programs draw the same picture? From pictures of each with different random numbers.
// Nothing is assumed of the noise but that right programs have the same.
//
// A pixel that shows one value in all pictures of a program, for both programs, is still: there the
// two values must be the same but for rounding. All others are noisy. Of them each 16 x 16 tile has
// a mean of linear light in each picture, and Welch's t-test compares the two programs' means. A
// byte is a coarse measure of light, but the same for both programs, so that rounding makes no
// false alarm; and the noise takes a pixel across many bytes, so that the mean is finer than a
// byte.
//
// Means alone would not see a program whose samples all take the same path: its light is right on
// average. So the noise is compared, too.

#include <array>
#include <course/picture.hpp>

namespace course {

constexpr int tile_side = 16;

struct Tile {
    int left = 0, top = 0, width = 0, height = 0;
};

// The tiles of a picture, row by row; those at the right and lower rim are smaller.
std::vector<Tile> tiles_of(int width, int height);

// What was found in a tile, for red, green and blue.
struct TileTest {
    Tile tile;
    std::array<double, 3> p{1, 1, 1};          // Welch's
    std::array<double, 3> mine{}, solution{};  // linear light over the whole tile
    long still_differing = 0;                  // pixels

    double least_p() const { return std::min({p[0], p[1], p[2]}); }
};

// How much a program's pictures vary, against the other's: 1 is as much, 4 is four times the
// variance.
struct NoiseTest {
    double ratio = 1, p = 1;
};

struct PictureTest {
    std::vector<TileTest> tiles;
    long pixels = 0, still_differing = 0;  // by more than one step of 255
    int largest_step = 0;                  // of a still pixel
    NoiseTest pixel_noise;                 // of each pixel by itself
    NoiseTest tile_noise;                  // of the tiles' means: neighbours that vary together

    // As for pictures without chance: at most one pixel in a thousand.
    bool still_differs() const { return 1000 * still_differing > pixels; }
};

// Compares pictures, all of one size; of each program one, or at least two with other random
// numbers.
PictureTest test_pictures(const std::vector<Picture>& mine, const std::vector<Picture>& solution);

}  // namespace course
