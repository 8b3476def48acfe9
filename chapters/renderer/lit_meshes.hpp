#pragma once
// What draws scenes with chapter 14's lamps, skies and metals. There is only one renderer for
// scenes in which meshes shine, and one for skies and metals, each with all effects. A scene must
// outlive what draws it.

#include <app/run.hpp>
#include <rt/draw_by_tiles.hpp>
#include <rt/mesh_scene.hpp>
#include <rt/render_pixel.hpp>

namespace full_renderer {

// Whether any mesh of the scene shines.
bool has_lamp_meshes(const rt::MeshedDescription& scene);

// Whether the sky of the scene is a picture, or there is rough metal in it.
bool has_sky_or_rough(const rt::MeshedDescription& scene);

// The colors of the pixels of a scene that has any of these.
rt::PixelColor make_lit_meshed(const rt::MeshedDescription& scene, int width, int height,
                               const rt::Quality& quality);
// Draws what --show asks for, of such a scene.
app::Picture show_lit_meshed(const rt::MeshedDescription& scene, const app::Settings& settings,
                             app::Progress& progress);

}  // namespace full_renderer
