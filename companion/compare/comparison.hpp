#pragma once
// The verdict on two programs' pictures.

#include <companion/compare/picture_statistics.hpp>
#include <cstdint>
#include <functional>

namespace companion {

// Two programs that draw; each seed gives different random numbers.
struct TwoPrograms {
    std::function<Picture(std::uint64_t seed)> mine, solution;
    bool random = false;  // if not, all seeds give one picture
};

struct Comparison {
    bool same = false;
    bool bit_for_bit = false;
    bool sizes_differ = false;
    int pictures = 1;              // of each program, on which the verdict is based
    PictureStatistics statistics;  // of these
    std::vector<TileStatistics>
        light_differs_in;  // tiles whose light differs, and blocks if no tile shows it
    std::vector<TileStatistics> noise_differs_in;  // the same for the noise
    bool pixels_differ = false;                    // though the light of each tile may be right
    bool pixel_noise_differs = false, tile_noise_differs = false;
    std::vector<Picture> mine, solution;  // all pictures that were drawn

    // One sentence; then where and by how much, one line each.
    std::vector<std::string> words() const;
    // "lower right, right": where they differ, whatever the reason.
    std::string regions() const;
};

// Compares in two steps. The first looks at all tiles, with 8 pictures of each program, and
// has a low bar. What seems to differ there is tested with new pictures and the bar that
// counts: the false-alarm rate is 1 in 1000. It stays so however often the first step errs,
// because the second step divides this rate among the few tests that it repeats. `start` picks
// the seeds; none is used twice.
Comparison compare(const TwoPrograms& programs, std::uint64_t start = 1);

// The same for programs without randomness, from one picture of each.
Comparison compare_still(const Picture& mine, const Picture& solution);

}  // namespace companion
