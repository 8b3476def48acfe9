#pragma once
#include <cstdint>
#include <functional>
#include <rt/image.hpp>
#include <rt/tile.hpp>

#include "narrowest_renderer.hpp"

namespace effects {

// Draws the pixels of a tile until a signal comes (app::Interruption), and returns how many are
// done; the rays that it took are added to `rays`.
using DrawTile =
    std::function<std::int64_t(const rt::Tile& tile, rt::Image& image, std::uint64_t& rays)>;

// Another way to draw a scene, byte for byte as the Shader does.
struct TileDrawing {
    Choice choice;
    std::function<DrawTile()> make_worker;  // one for each thread; may be called by all at once
    int tile_side = 16;                     // in pixels
};

// In batches of rays (--batches). Chapter 10 brings it along, and this chapter knows no more of it
// than this: null in a program without chapter 10. The scene must outlive the drawing.
using MakeTileDrawing = TileDrawing (*)(const rt::SceneDescription& scene, int width, int height,
                                        const rt::Quality& quality);
inline MakeTileDrawing make_batch_drawing = nullptr;

}  // namespace effects
