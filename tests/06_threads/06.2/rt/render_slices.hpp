#pragma once
#include <rt/slice_rows.hpp>
#include <rt/tile.hpp>

namespace answer {

void render_slices(const rt::TileGrid& grid, int workers, const rt::TileWork& work);

}  // namespace answer

namespace rt {

using answer::render_slices;

}  // namespace rt
