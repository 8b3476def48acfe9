#pragma once
#include <cstdint>
#include <functional>
#include <rt/image.hpp>
#include <rt/render_pixel.hpp>
#include <rt/scene.hpp>
#include <rt/tile.hpp>

namespace full_renderer {

// Draws a tile with jittered samples of this seed; adds the number of rays to `rays`.
using DrawSeed =
    std::function<void(const rt::Tile&, std::uint64_t seed, rt::Image& image, std::uint64_t& rays)>;

// Makes workers, one for each thread, that draw tiles of a scene in batches.
std::function<DrawSeed()> jittered_batches(const rt::SceneDescription& scene, int width, int height,
                                           const rt::Quality& quality);

}  // namespace full_renderer
