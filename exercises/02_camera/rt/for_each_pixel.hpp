#pragma once
#include <rt/tile.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 02.5. Calls visit(column, row) once for each pixel of a tile: row by row from the top,
// each row from the left. A tile has the columns left ... right - 1 of the rows top ... bottom - 1
// (see <rt/tile.hpp>) and may lie anywhere. For a tile without pixels, where left is not less than
// right or top is not less than bottom, there is no call. Do not catch what visit throws.
// Star: the tile may be very large, or lie at an end of the range of int. It is always the same
// visit that is called, never a copy of it.
template <class Visit>
void for_each_pixel(const Tile& tile, Visit visit) {
    rt::todo("02.5", tile, visit);
}

}  // namespace rt
