#pragma once
#include <app/run.hpp>
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

// The same, and each tile may be drawn with another seed than that of the quality: chapter 11 draws
// a picture in passes.
using DrawSeededTile = std::function<void(const rt::Tile& tile, std::uint64_t seed,
                                          rt::Image& image, std::uint64_t& rays)>;
struct SeededDrawing {
    Choice choice;
    std::function<DrawSeededTile()> make_worker;
    int tile_side = 16;
};
using MakeSeededDrawing = SeededDrawing (*)(const rt::SceneDescription& scene, int width,
                                            int height, const rt::Quality& quality);
inline MakeSeededDrawing make_seeded_batches = nullptr;

// How chapter 11 draws a scene, and the options that ask for it; null in a program without
// chapter 11.
struct Refining {
    std::vector<app::Choice> choices;  // the first: --sampler jittered|sobol
    std::vector<app::Number> numbers;
    MakeTileDrawing make_sobol_drawing = nullptr;
    // Where one of the numbers is given: refines the picture. Says first what it draws with.
    app::Picture (*render)(const rt::SceneDescription& scene, const app::Settings& settings,
                           const std::function<void(const Choice&)>& explain,
                           app::Progress& progress) = nullptr;
};
inline const Refining* refining = nullptr;

}  // namespace effects
