#pragma once
// The verdict on two programs' pictures.

#include <companion/compare/picture_statistics.hpp>
#include <cstdint>
#include <functional>

namespace companion {

// Two programs that draw the same scene; each seed gives different random numbers.
struct TwoPrograms {
    std::function<Picture(std::uint64_t seed)> mine, solution;
    bool random = false;  // if false, all seeds give the same picture
};

struct Comparison {
    bool same = false;
    bool bit_for_bit = false;
    bool sizes_differ = false;
    int pictures = 1;              // of each program; the verdict is based on them
    PictureStatistics statistics;  // of these pictures
    std::vector<TileStatistics>
        light_differs_in;  // tiles whose light differs, and blocks if no tile shows it
    std::vector<TileStatistics> noise_differs_in;  // the same for the noise
    bool pixels_differ = false;                    // even if the light of each tile is right
    bool pixel_noise_differs = false, tile_noise_differs = false;
    std::vector<Picture> mine, solution;  // all pictures that were drawn

    // The verdict in one sentence; then, line by line, where the pictures differ and by how much.
    std::vector<std::string> words() const;
    // Where the pictures differ, whatever the reason: "lower right, right".
    std::string regions() const;
};

// Compares in two steps. The first step looks at all tiles, with 8 pictures of each program, and is
// easily suspicious. What seems to differ is tested again with new pictures and a strict threshold:
// the false-alarm rate is 1 in 1000. It stays so however often the first step errs, because the
// second step divides this rate among the few tests that it repeats. `start` determines the seeds;
// none is used twice.
Comparison compare(const TwoPrograms& programs, std::uint64_t start = 1);

// The same for programs without randomness, with one picture of each.
Comparison compare_still(const Picture& mine, const Picture& solution);

}  // namespace companion
