#pragma once
// Chapter 12's part of what chapter 11 adds to this program: scenes with meshes. There is one
// renderer for them, with all effects, because more renderers would take minutes to compile.

#include <rt/refinement.hpp>

#include "tile_renderer.hpp"

namespace effects {

// Passes of samples from Sobol's sequence, or jittered ones.
rt::DrawPass make_meshed_passes(const rt::SceneDescription& scene, int width, int height,
                                const rt::Quality& quality, bool sobol);
// Draws each tile, filtered with a tent.
DrawTile make_meshed_tent(const rt::SceneDescription& scene, int width, int height,
                          const rt::Quality& quality);

}  // namespace effects
