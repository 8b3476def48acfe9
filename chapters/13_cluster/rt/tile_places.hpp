#pragma once
#include <cstdint>
#include <functional>
#include <ios>
#include <rt/color.hpp>
#include <rt/hash_of.hpp>
#include <rt/render_tiles.hpp>
#include <span>
#include <vector>

namespace rt {

// Does something with a tile (given), such as put it into a picture.
using PutTile = std::function<void(int tile, const std::vector<Color>& pixels)>;

// Where the tiles of a picture are in the file of finished tiles (given). Each tile has a place of
// its own: first its checksum, a std::uint64_t, then its pixels. The places are equally large, one
// after the other. A place that was never written holds zeros, or lies beyond the file's end.
struct TilePlaces {
    TileGrid grid;
    std::uint64_t picture = 0;  // a number made from the scene, the settings and the program

    // The number of pixels in a tile.
    std::size_t pixels(int tile) const {
        return static_cast<std::size_t>(pixel_count(tile_at(grid, tile)));
    }

    // The byte at which the place of a tile begins.
    std::streamoff begin(int tile) const {
        const auto side = static_cast<std::size_t>(grid.tile_size);
        return static_cast<std::streamoff>(static_cast<std::size_t>(tile) *
                                           (sizeof(std::uint64_t) + side * side * sizeof(Color)));
    }

    // It differs if a bit of the pixels differs, or if they belong to another tile or picture.
    std::uint64_t checksum(int tile, std::span<const Color> pixels) const {
        return hash_of({reinterpret_cast<const char*>(pixels.data()), pixels.size_bytes()},
                       mix_bits(picture + static_cast<std::uint64_t>(tile)));
    }
};

}  // namespace rt
