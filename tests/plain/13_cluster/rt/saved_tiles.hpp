#pragma once
#include <filesystem>
#include <fstream>
#include <rt/color.hpp>
#include <rt/tile_file.hpp>
#include <span>
#include <stdexcept>
#include <vector>

namespace rt {

inline void save_tile(const std::filesystem::path& folder, int tile,
                      std::span<const Color> pixels) {
    const std::filesystem::path file = tile_file(folder, tile),
                                unfinished = file.string() + ".part";
    std::ofstream out{unfinished, std::ios::binary};
    out.write(reinterpret_cast<const char*>(pixels.data()),
              static_cast<std::streamsize>(pixels.size_bytes()));
    out.close();
    std::filesystem::rename(unfinished, file);
}

inline std::vector<Color> load_tile(const std::filesystem::path& folder, int tile) {
    const std::filesystem::path file = tile_file(folder, tile);
    std::vector<Color> pixels(std::filesystem::file_size(file) / sizeof(Color));
    std::ifstream in{file, std::ios::binary};
    in.read(reinterpret_cast<char*>(pixels.data()),
            static_cast<std::streamsize>(pixels.size() * sizeof(Color)));
    return pixels;
}

inline std::vector<int> missing_tiles(const std::filesystem::path& folder, int count) {
    std::vector<int> missing;
    for (int tile = 0; tile < count; ++tile)
        if (!std::filesystem::exists(tile_file(folder, tile))) missing.push_back(tile);
    return missing;
}

}  // namespace rt
