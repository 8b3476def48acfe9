// All renderers are compiled here, once, because that takes long.

#include <rt/choose_renderer.hpp>
#include <rt/renderers.hpp>

#include "pixel_renderer.hpp"

effects::PixelRenderer effects::make_narrowest(const rt::Effects& needed,
                                               const rt::SceneDescription& scene, int width,
                                               int height, const rt::Quality& quality) {
    const std::size_t number = rt::narrowest(needed, rt::renderer_effects);
    return {choice_of(rt::renderer_effects, number),
            rt::renderer_makers[number](scene, width, height, quality)};
}
