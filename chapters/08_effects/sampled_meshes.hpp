#pragma once
// Chapter 12's part of what chapter 11 adds to this program: scenes with meshes. It has one
// renderer, with all effects, because more of them would take minutes to compile.

#include "tile_renderer.hpp"

namespace rt {
struct Pass;
}

namespace effects {

using DrawMeshedPass = std::function<void(const rt::Tile& tile, const rt::Pass& pass,
                                          rt::Image& image, std::uint64_t& rays)>;

// Passes of samples from Sobol's sequence, or jittered ones.
DrawMeshedPass make_meshed_passes(const rt::SceneDescription& scene, int width, int height,
                                  const rt::Quality& quality, bool sobol);
// Each tile, filtered by a tent.
DrawTile make_meshed_tent(const rt::SceneDescription& scene, int width, int height,
                          const rt::Quality& quality);

}  // namespace effects
