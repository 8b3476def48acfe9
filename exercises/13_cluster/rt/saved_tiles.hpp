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

// Exercise 13.4. Writes the pixels of a tile to tile_file(folder, tile). The file gets this name
// only when it is whole: at whatever moment the program ends, it leaves a whole file or none.
// Star: throw std::runtime_error if the file cannot be written. An older file then stays as it was,
// and no other file is left behind.
inline void save_tile(const std::filesystem::path& folder, int tile,
                      std::span<const Color> pixels) {
    rt::todo("13.4", folder, tile, pixels);
}

// Exercise 13.4. Reads the pixels from the file of a tile. You may assume that the file exists.
inline std::vector<Color> load_tile(const std::filesystem::path& folder, int tile) {
    return rt::todo("13.4", folder, tile);
}

// Exercise 13.4. Returns those of the tiles 0 ... count - 1 that have no file in the folder, in
// increasing order.
inline std::vector<int> missing_tiles(const std::filesystem::path& folder, int count) {
    return rt::todo("13.4", folder, count);
}

}  // namespace rt
