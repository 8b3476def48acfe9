#pragma once
#include <cstdint>
#include <functional>
#include <rt/effects.hpp>
#include <rt/render_pixel.hpp>
#include <rt/scene.hpp>

namespace effects {

// The color of a pixel; the rays that it took are added to `rays`.
using Shader = std::function<rt::Color(int column, int row, std::uint64_t& rays)>;

// The narrowest of all renderers that have these effects, made ready for the scene, which must
// outlive it.
Shader make_narrowest(const rt::Effects& needed, const rt::SceneDescription& scene, int width,
                      int height, const rt::Quality& quality);

// Which renderer was chosen.
struct Choice {
    rt::Effects chosen, left_out;  // the effects that it has, and has not
    std::size_t renderers = 0;     // how many there are to choose from
};
Choice choose(const rt::Effects& needed);

}  // namespace effects
