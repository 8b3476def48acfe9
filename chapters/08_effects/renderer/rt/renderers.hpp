#pragma once
#include <array>
#include <rt/draw_by_tiles.hpp>
#include <rt/effects.hpp>
#include <rt/renderer.hpp>

namespace rt {

// The renderers that are compiled (given), each for one of these sets of effects. A material or a
// lens that is compiled in but not used costs nothing that can be measured, so only one renderer
// does without them. Motion, lights, fog, haze and instances do cost something, so each of them has
// a renderer of its own, and so has each pair that scenes often have. The last renderer has every
// effect. It alone has the material of 05.6 and the effects that later chapters add.
inline constexpr auto renderer_effects = [] {
    constexpr Effects materials{
        .mirror = true, .fuzz = true, .glass = true, .texture = true, .lens = true};
    constexpr Effects none;
    return std::array{none,
                      materials,
                      with(materials, {.motion = true}),
                      with(materials, {.lights = true}),
                      with(materials, {.fog = true}),
                      with(materials, {.haze = true}),
                      with(materials, {.instances = true}),
                      with(materials, {.lights = true, .instances = true}),
                      every_effect};
}();

// Draws a scene with one of these renderers. The scene must outlive the result.
using MakeDrawTile = DrawTile (*)(const SceneDescription& scene, int width, int height,
                                  const Quality& quality);

template <Effects effects>
DrawTile make_draw_tile(const SceneDescription& scene, int width, int height,
                        const Quality& quality) {
    return pixel_by_pixel(std::make_shared<const Renderer<effects>>(scene, width, height, quality));
}

inline constexpr auto renderer_makers = []<std::size_t... number>(std::index_sequence<number...>) {
    return std::array<MakeDrawTile, sizeof...(number)>{make_draw_tile<renderer_effects[number]>...};
}
(std::make_index_sequence<renderer_effects.size()>{});

}  // namespace rt
