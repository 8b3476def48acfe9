#pragma once
#include <filesystem>
#include <string>

namespace rt {

// The file of a finished tile (given): folder/12.tile.
inline std::filesystem::path tile_file(const std::filesystem::path& folder, int tile) {
    return folder / (std::to_string(tile) + ".tile");
}

}  // namespace rt
