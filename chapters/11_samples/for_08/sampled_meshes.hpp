#pragma once
// What chapter 11 adds to chapter 08's program, for scenes with meshes (chapter 12). There is only
// one renderer for such scenes, with all effects, because more renderers would take minutes to
// compile.

#include <rt/refinement.hpp>

#include "tile_renderer.hpp"

namespace effects {

// Passes of Sobol's points, or of jittered samples.
rt::DrawPass make_meshed_passes(const rt::SceneDescription& scene, int width, int height,
                                const rt::Quality& quality, bool sobol);
// Draws each tile, filtered with a tent.
DrawTile make_meshed_tent(const rt::SceneDescription& scene, int width, int height,
                          const rt::Quality& quality);

}  // namespace effects
