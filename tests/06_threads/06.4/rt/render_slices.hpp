#pragma once
// The answer's own, among all strategies.

#include <rt/tile.hpp>

namespace answer {

void render_slices(const rt::TileGrid& grid, int workers, const rt::TileWork& work);

}  // namespace answer

namespace rt {

using answer::render_slices;

}  // namespace rt
