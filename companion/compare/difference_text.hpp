#pragma once
// Where two pictures differ and by how much, in words.

#include <companion/compare/picture_statistics.hpp>
#include <string>
#include <vector>

namespace companion {

// The ninth of the picture that contains the tile's middle: "lower left", "top", "middle", ...
std::string region_of(const Tile& tile, int width, int height);

// The regions that contain the middles of these tiles, each once.
std::vector<std::string> regions_of(const std::vector<TileStatistics>& tiles, int width,
                                    int height);

// How the light of a region differs: "3.1 % too dark", "twice as bright as it should be", "drawn
// differently, by 12 % on average". If one channel stands out, it is named: "3.1 % too dark, 8.0 %
// too little blue". If the light differs by less than 0.1 %: "12 pixels without noise differ, by up
// to 3 of 255 steps". All tiles must be in the same region.
std::string describe_difference(const std::vector<TileStatistics>& tiles);

// A line for each region with differing tiles, the largest difference first, at most four lines; or
// a single line if the whole picture differs.
std::vector<std::string> describe_by_region(const std::vector<TileStatistics>& differing,
                                            const std::vector<TileStatistics>& all, int width,
                                            int height);

}  // namespace companion
