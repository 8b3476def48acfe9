#pragma once
#include <filesystem>
#include <fstream>
#include <rt/color.hpp>
#include <rt/tile_file.hpp>
#include <span>
#include <stdexcept>
#include <vector>

namespace rt {

// Writes the pixels of a tile to tile_file(folder, tile). The file gets this name only when it is
// whole: at whatever moment the program ends, it leaves a whole file or none. Throws
// std::runtime_error if the file cannot be written. An older file then stays as it was, and no
// other file is left behind.
inline void save_tile(const std::filesystem::path& folder, int tile,
                      std::span<const Color> pixels) {
    const std::filesystem::path file = tile_file(folder, tile),
                                unfinished = file.string() + ".part";
    std::ofstream out{unfinished, std::ios::binary};
    out.write(reinterpret_cast<const char*>(pixels.data()),
              static_cast<std::streamsize>(pixels.size_bytes()));
    out.close();  // the last bytes are written here
    std::error_code error;
    if (out) std::filesystem::rename(unfinished, file, error);
    if (!out || error) {
        std::filesystem::remove(unfinished, error);
        throw std::runtime_error(file.string() + " cannot be written; free some space there");
    }
}

// Reads the pixels from the file of a tile. The file exists.
inline std::vector<Color> load_tile(const std::filesystem::path& folder, int tile) {
    const std::filesystem::path file = tile_file(folder, tile);
    std::vector<Color> pixels(std::filesystem::file_size(file) / sizeof(Color));
    std::ifstream in{file, std::ios::binary};
    in.read(reinterpret_cast<char*>(pixels.data()),
            static_cast<std::streamsize>(pixels.size() * sizeof(Color)));
    return pixels;
}

// Returns those of the tiles 0 ... count - 1 that have no file in the folder, in increasing order.
inline std::vector<int> missing_tiles(const std::filesystem::path& folder, int count) {
    std::vector<int> missing;
    for (int tile = 0; tile < count; ++tile)
        if (!std::filesystem::exists(tile_file(folder, tile))) missing.push_back(tile);
    return missing;
}

}  // namespace rt
