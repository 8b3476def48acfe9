#pragma once
#include <filesystem>
#include <rt/color.hpp>
#include <rt/tile_file.hpp>
#include <span>
#include <vector>

namespace answer {

void save_tile(const std::filesystem::path& folder, int tile, std::span<const rt::Color> pixels);
std::vector<rt::Color> load_tile(const std::filesystem::path& folder, int tile);
std::vector<int> missing_tiles(const std::filesystem::path& folder, int count);

}  // namespace answer

namespace rt {

using answer::load_tile;
using answer::missing_tiles;
using answer::save_tile;

}  // namespace rt
