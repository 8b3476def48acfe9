#pragma once
#include <rt/tile.hpp>

namespace rt {

// Calls visit(column, row) once for each pixel of a tile: row by row from the top, each row from
// the left. For a tile without pixels, where left is not less than right or top is not less than
// bottom, it makes no call.
template <class Visit>
void for_each_pixel(const Tile& tile, Visit visit) {
    for (int row = tile.top; row < tile.bottom; ++row)
        for (int column = tile.left; column < tile.right; ++column) visit(column, row);
}

}  // namespace rt
