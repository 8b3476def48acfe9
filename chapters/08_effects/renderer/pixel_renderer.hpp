#pragma once
// A way to draw a scene pixel by pixel: with the narrowest renderer that has what the scene needs.

#include <rt/draw_by_tiles.hpp>
#include <rt/effects.hpp>
#include <rt/render_pixel.hpp>
#include <rt/scene.hpp>
#include <span>
#include <string>

namespace effects {

// Which renderer was chosen.
struct Choice {
    rt::Effects chosen;  // the effects that it has
    std::string among;   // out of how many it was chosen, such as "one of 9"
};

// The Choice of the renderer at `index`, out of renderers with these sets of effects.
inline Choice choice_of(std::span<const rt::Effects> renderers, std::size_t index) {
    return {renderers[index], "one of " + std::to_string(renderers.size())};
}

struct PixelRenderer {
    Choice choice;
    rt::PixelColor color;  // all threads may call it at once
};

// Follows each path to its end, with the narrowest renderer that has these effects. The scene must
// outlive the result.
PixelRenderer make_narrowest(const rt::Effects& needed, const rt::SceneDescription& scene,
                             int width, int height, const rt::Quality& quality);

}  // namespace effects
