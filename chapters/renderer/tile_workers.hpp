#pragma once
// The ways to draw a scene that this program has. A scene must outlive what draws it.

#include <app/run.hpp>
#include <functional>
#include <rt/draw_by_tiles.hpp>
#include <rt/mesh_scene.hpp>
#include <rt/render_pixel.hpp>

#include "pixel_renderer.hpp"

namespace full_renderer {

using effects::Choice;
using rt::MeshedDescription;

struct TileWorkers {
    Choice choice;
    std::function<rt::DrawTile()> make_worker;  // one for each thread; may be called by all at once
    int tile_side = 16;                         // in pixels
};

// Pixel by pixel, each path to its end: chapter 08's way, and chapter 12's if there are meshes.
effects::PixelRenderer make_pixel_renderer(const MeshedDescription& scene, int width, int height,
                                           const rt::Quality& quality);
TileWorkers make_path_by_path(const MeshedDescription& scene, int width, int height,
                              const rt::Quality& quality);
// Chapter 10's way: the same picture, byte for byte, in batches of rays. A scene that has meshes,
// or effects that batches lack, is drawn path by path.
TileWorkers make_batched(const MeshedDescription& scene, int width, int height,
                         const rt::Quality& quality);
// Chapter 11's way: with samples from Sobol's sequence, path by path or in batches as above.
TileWorkers make_sobol(const MeshedDescription& scene, int width, int height,
                       const rt::Quality& quality, bool in_batches);
// The same with a tent as the reconstruction filter: the pixels around a sample share it.
TileWorkers make_tent(const MeshedDescription& scene, int width, int height,
                      const rt::Quality& quality, bool in_batches);

// Chapter 11's way to refine a picture, until it reaches the target error or the time budget that
// the settings name. Calls explain() before it draws.
app::Picture refine(const MeshedDescription& scene, const app::Settings& settings,
                    const std::function<void(const Choice&)>& explain, app::Progress& progress);

// Draws what --show asks for, with the renderer that has every effect.
app::Picture show_scene(const MeshedDescription& scene, const app::Settings& settings,
                        app::Progress& progress);

}  // namespace full_renderer
