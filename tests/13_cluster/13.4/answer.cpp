#include <answer.hpp>
#include <rt/saved_tiles.hpp>

namespace answer EXPORTED {

void save_tile(const std::filesystem::path& folder, int tile, std::span<const rt::Color> pixels) {
    rt::save_tile(folder, tile, pixels);
}

std::vector<rt::Color> load_tile(const std::filesystem::path& folder, int tile) {
    return rt::load_tile(folder, tile);
}

std::vector<int> missing_tiles(const std::filesystem::path& folder, int count) {
    return rt::missing_tiles(folder, count);
}

}  // namespace EXPORTED
