#pragma once
// A way to draw a scene. This chapter has one; chapters 10, 11 and 12 add four more to this
// program, and a way to refine a picture. CMakeLists.txt names their sources.

#include <app/run.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <rt/effects.hpp>
#include <rt/image.hpp>
#include <rt/needed_effects.hpp>
#include <rt/render_pixel.hpp>
#include <rt/scene.hpp>
#include <rt/tile.hpp>
#include <span>

namespace effects {

// Which renderer was chosen.
struct Choice {
    rt::Effects chosen, left_out;  // the effects that it has, and those that it lacks
    std::size_t renderers = 1;     // how many there are to choose from
    bool in_batches = false;       // whether it follows many paths at a time
};

// The Choice of the renderer at `index`, out of renderers with these sets of effects.
inline Choice choice_of(std::span<const rt::Effects> renderers, std::size_t index) {
    return {renderers[index], without(rt::every_effect, renderers[index]), renderers.size()};
}

// The Choice of a renderer that has these effects and draws in batches, the only one of its kind.
inline Choice batched_choice(const rt::Effects& effects) {
    return {effects, without(rt::every_effect, effects), 1, true};
}

// Draws the pixels of a tile with this seed, and returns how many are done: all, unless a signal
// came meanwhile (app::Interruption) and the renderer stops at signals. The number of rays that
// were traced is added to `rays`.
using DrawTile = std::function<std::int64_t(const rt::Tile& tile, std::uint64_t seed,
                                            rt::Image& image, std::uint64_t& rays)>;

struct TileRenderer {
    Choice choice;
    std::function<DrawTile()> make_worker;  // one for each thread; may be called by all at once
    int tile_side = 16;                     // in pixels
};

// Each of these functions makes a renderer for the scene, which must outlive the renderer.

// This chapter's way: pixel by pixel, each path to its end, with the narrowest renderer that has
// these effects.
TileRenderer make_narrowest(const rt::Effects& needed, const rt::SceneDescription& scene, int width,
                            int height, const rt::Quality& quality);
// Chapter 10's way: the same picture, byte for byte, in batches of rays. A scene that has meshes,
// or effects that batches lack, is drawn path by path.
TileRenderer make_batched(const rt::SceneDescription& scene, int width, int height,
                          const rt::Quality& quality);
// Chapter 11's way: with samples from Sobol's sequence, path by path or in batches as above.
TileRenderer make_sobol(const rt::SceneDescription& scene, int width, int height,
                        const rt::Quality& quality, bool in_batches);
// The same with a tent as the reconstruction filter: the pixels around a sample share it.
TileRenderer make_tent(const rt::SceneDescription& scene, int width, int height,
                       const rt::Quality& quality, bool in_batches);

// Chapter 12's way: pixel by pixel, with meshes.
TileRenderer make_meshed(const rt::SceneDescription& scene, int width, int height,
                         const rt::Quality& quality);
// make_meshed for a scene with meshes, and make_narrowest for any other. Both follow each path to
// its end.
inline TileRenderer make_path_by_path(const rt::SceneDescription& scene, int width, int height,
                                      const rt::Quality& quality) {
    return scene.meshes.empty()
               ? make_narrowest(rt::needed_effects(scene), scene, width, height, quality)
               : make_meshed(scene, width, height, quality);
}
// Draws what --show asks for, of a scene with meshes.
app::Picture show_meshed(rt::SceneDescription scene, const app::Settings& settings,
                         app::Progress& progress);
// The mesh in the bytes of an OBJ file, with smooth normals (true), without them (false), or as the
// file has them (none). Throws std::invalid_argument, which says what is wrong with the file.
rt::Mesh read_mesh(const std::string& bytes, std::optional<bool> smooth);

// Chapter 11's way to refine a picture, until it reaches the target error or the time budget that
// the settings name. Calls explain() before it draws.
app::Picture refine(const rt::SceneDescription& scene, const app::Settings& settings,
                    const std::function<void(const Choice&)>& explain, app::Progress& progress);

}  // namespace effects
