#pragma once
#include <filesystem>
#include <fstream>
#include <rt/color.hpp>
#include <rt/tile_file.hpp>
#include <rt/todo.hpp>
#include <span>
#include <stdexcept>
#include <vector>

namespace rt {

// Exercise 13.4. Writes the pixels of a tile to tile_file(folder, tile). The file has its name only
// when it is whole: a program that ends at whatever moment leaves a whole file or none.
// Star: throw std::runtime_error if it cannot be written; an older file is then unchanged, and
// nothing else is left behind.
inline void save_tile(const std::filesystem::path& folder, int tile,
                      std::span<const Color> pixels) {
    rt::todo("13.4", folder, tile, pixels);
}

// Exercise 13.4. The pixels in the file of a tile, which exists.
inline std::vector<Color> load_tile(const std::filesystem::path& folder, int tile) {
    return rt::todo("13.4", folder, tile);
}

// Exercise 13.4. Of the tiles 0 ... count - 1, those that have no file in the folder, in their
// order.
inline std::vector<int> missing_tiles(const std::filesystem::path& folder, int count) {
    return rt::todo("13.4", folder, count);
}

}  // namespace rt
