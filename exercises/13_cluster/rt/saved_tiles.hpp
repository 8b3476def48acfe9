#pragma once
#include <istream>
#include <optional>
#include <ostream>
#include <rt/color.hpp>
#include <rt/tile_places.hpp>
#include <rt/todo.hpp>
#include <span>
#include <stdexcept>
#include <vector>

namespace rt {

// Exercise 13.4. Writes the checksum and the pixels of a tile to its place in the file. When the
// function returns, the system has them, whatever becomes of the program.
// Star: throw std::runtime_error if they cannot be written.
inline void save_tile(std::ostream& file, const TilePlaces& places, int tile,
                      std::span<const Color> pixels) {
    rt::todo("13.4", file, places, tile, pixels);
}

// Exercise 13.4. Reads the pixels of a tile from its place in the file. Returns none if the place
// does not hold this tile, whole and unchanged.
inline std::optional<std::vector<Color>> load_tile(std::istream& file, const TilePlaces& places,
                                                   int tile) {
    return rt::todo("13.4", file, places, tile);
}

// Exercise 13.4. Calls put(tile, pixels) for each tile of the picture that the file holds. Returns
// the numbers of the others. Both go through the tiles in increasing order.
inline std::vector<int> restore_tiles(std::istream& file, const TilePlaces& places,
                                      const PutTile& put) {
    return rt::todo("13.4", file, places, put);
}

}  // namespace rt
