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

// A way to draw a scene, which must outlive it.
template <class Draw>
struct Drawing {
    Choice choice;
    std::function<Draw()> make_worker;  // one for each thread; may be called by all at once
    int tile_side = 16;                 // in pixels
};
using TileDrawing = Drawing<DrawTile>;

// What the electives provide draws whole tiles, with any seed, because chapter 11 draws a picture
// in passes. This chapter knows nothing more about it.
using DrawSeededTile = std::function<void(const rt::Tile& tile, std::uint64_t seed,
                                          rt::Image& image, std::uint64_t& rays)>;
using SeededDrawing = Drawing<DrawSeededTile>;
using MakeSeededDrawing = SeededDrawing (*)(const rt::SceneDescription& scene, int width,
                                            int height, const rt::Quality& quality);

// The same with one seed, until a signal comes.
inline TileDrawing with_seed(const SeededDrawing& seeded, std::uint64_t seed) {
    const auto make_worker = [make = seeded.make_worker, seed] {
        return [draw = make(), seed](const rt::Tile& tile, rt::Image& image, std::uint64_t& rays) {
            if (app::Interruption::signal() != 0) return std::int64_t{0};
            draw(tile, seed, image, rays);
            return pixel_count(tile);
        };
    };
    return {seeded.choice, make_worker, seeded.tile_side};
}

// In batches of rays (--batches), byte for byte as the Shader does. Null without chapter 10.
inline MakeSeededDrawing make_batch_drawing = nullptr;

// How chapter 11 draws a scene, and the options that ask for it; null in a program without
// chapter 11.
struct Refining {
    std::vector<app::Choice> choices;  // the first: --sampler jittered|sobol
    std::vector<app::Number> numbers;
    MakeSeededDrawing make_sobol_drawing = nullptr;
    // If one of the numbers is given, refines the picture. First prints what it draws with.
    app::Picture (*render)(const rt::SceneDescription& scene, const app::Settings& settings,
                           const std::function<void(const Choice&)>& explain,
                           app::Progress& progress) = nullptr;
};
inline const Refining* refining = nullptr;

}  // namespace effects
