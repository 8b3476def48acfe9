#pragma once
#include <filesystem>
#include <fstream>
#include <rt/color.hpp>
#include <rt/tile_file.hpp>
#include <span>
#include <stdexcept>
#include <vector>

namespace rt {

// Writes the pixels of a tile to its file. The file has its name only when it is whole, so whoever
// ends the program at whatever moment leaves a whole file or none. Throws std::runtime_error if it
// cannot be written; an older file is then unchanged, and nothing else is left behind.
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

// The pixels in the file of a tile, which exists.
inline std::vector<Color> load_tile(const std::filesystem::path& folder, int tile) {
    const std::filesystem::path file = tile_file(folder, tile);
    std::vector<Color> pixels(std::filesystem::file_size(file) / sizeof(Color));
    std::ifstream in{file, std::ios::binary};
    in.read(reinterpret_cast<char*>(pixels.data()),
            static_cast<std::streamsize>(pixels.size() * sizeof(Color)));
    return pixels;
}

// Of the tiles 0 ... count - 1, those that have no file in the folder, in their order.
inline std::vector<int> missing_tiles(const std::filesystem::path& folder, int count) {
    std::vector<int> missing;
    for (int tile = 0; tile < count; ++tile)
        if (!std::filesystem::exists(tile_file(folder, tile))) missing.push_back(tile);
    return missing;
}

}  // namespace rt
