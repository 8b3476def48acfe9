#pragma once
// Chapter 12's part of what chapter 11 adds to this program: scenes with meshes. It has one
// renderer, with all effects, because more of them would take minutes to compile.

#include <rt/refinement.hpp>

#include "tile_renderer.hpp"

namespace effects {

// Passes of samples from Sobol's sequence, or jittered ones.
rt::DrawPass make_meshed_passes(const rt::SceneDescription& scene, int width, int height,
                                const rt::Quality& quality, bool sobol);
// Each tile, filtered by a tent.
DrawTile make_meshed_tent(const rt::SceneDescription& scene, int width, int height,
                          const rt::Quality& quality);

}  // namespace effects
