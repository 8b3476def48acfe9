#pragma once
#include <istream>
#include <optional>
#include <ostream>
#include <rt/color.hpp>
#include <rt/tile_places.hpp>
#include <span>
#include <stdexcept>
#include <vector>

namespace rt {

// Writes the checksum and the pixels of a tile to its place in the file. When the function returns,
// the system has them, whatever becomes of the program. Throws std::runtime_error if they cannot be
// written.
inline void save_tile(std::ostream& file, const TilePlaces& places, int tile,
                      std::span<const Color> pixels) {
    const std::uint64_t checksum = places.checksum(tile, pixels);
    file.seekp(places.begin(tile));
    file.write(reinterpret_cast<const char*>(&checksum), sizeof checksum);
    file.write(reinterpret_cast<const char*>(pixels.data()),
               static_cast<std::streamsize>(pixels.size_bytes()));
    file.flush();  // the last bytes are written here
    if (!file) throw std::runtime_error("a finished tile cannot be written");
}

// Reads the pixels of a tile from its place in the file. Returns none if the place does not hold
// this tile, whole and unchanged.
inline std::optional<std::vector<Color>> load_tile(std::istream& file, const TilePlaces& places,
                                                   int tile) {
    std::uint64_t checksum = 0;
    std::vector<Color> pixels(places.pixels(tile));
    file.clear();  // an earlier tile may lie beyond the end
    file.seekg(places.begin(tile));
    file.read(reinterpret_cast<char*>(&checksum), sizeof checksum);
    file.read(reinterpret_cast<char*>(pixels.data()),
              static_cast<std::streamsize>(pixels.size() * sizeof(Color)));
    if (checksum != places.checksum(tile, pixels)) return {};  // also if there was less to read
    return pixels;
}

// Calls put(tile, pixels) for each tile of the picture that the file holds. Returns the numbers of
// the others. Both go through the tiles in increasing order.
inline std::vector<int> restore_tiles(std::istream& file, const TilePlaces& places,
                                      const PutTile& put) {
    std::vector<int> missing;
    for (int tile = 0; tile < tile_count(places.grid); ++tile)
        if (const auto pixels = load_tile(file, places, tile))
            put(tile, *pixels);
        else
            missing.push_back(tile);
    return missing;
}

}  // namespace rt
