#pragma once
#include <algorithm>
#include <array>
#include <rt/draw_by_tiles.hpp>
#include <rt/effects.hpp>
#include <rt/renderer.hpp>

namespace rt {

// The effects of the scenes that the chapter draws (given): each of these sets has a renderer that
// contains nothing else.
inline constexpr std::array exact_effects{
    // The final scene, and the file cover.json.
    Effects{.fuzz = true, .glass = true, .lens = true, .lights = true, .instances = true},
    Effects{.mirror = true, .fuzz = true, .glass = true, .lens = true},
    // fog.json, galaxy.json, glass.json, haze.json, lens.json, lights.json and matte.json.
    Effects{.lights = true, .fog = true}, Effects{.glass = true, .lens = true, .lights = true},
    Effects{.glass = true}, Effects{.fuzz = true, .haze = true},
    Effects{.fuzz = true, .lens = true}, Effects{.lights = true}, Effects{},
    // metal.json, motion.json, own.json and textures.json.
    Effects{.mirror = true, .fuzz = true}, Effects{.mirror = true, .fuzz = true, .motion = true},
    Effects{.texture = true, .lights = true, .own = true}, Effects{.texture = true},
    // planets.json.
    Effects{.fuzz = true,
            .glass = true,
            .texture = true,
            .lens = true,
            .motion = true,
            .lights = true,
            .fog = true}};

// The renderers that all other scenes share (given): to compile one for each set of effects would
// take more than half an hour. All materials and the lens are in each of them, because together
// they cost hardly anything where they are not used. The last renderer has every effect, also those
// that later chapters add. It draws what fits no other, which costs most:
// docs/studies/08_effects.md says how much.
inline constexpr auto shared_effects = [] {
    constexpr Effects materials{
        .mirror = true, .fuzz = true, .glass = true, .texture = true, .lens = true, .own = true};
    return std::array{materials, with(materials, {.lights = true, .instances = true}),
                      every_effect};
}();

// All renderers that are compiled (given), each for one of these sets.
inline constexpr auto renderer_effects = [] {
    std::array<Effects, exact_effects.size() + shared_effects.size()> all;
    std::copy(exact_effects.begin(), exact_effects.end(), all.begin());
    std::copy(shared_effects.begin(), shared_effects.end(), all.begin() + exact_effects.size());
    return all;
}();

// The colors of a scene's pixels, by one of these renderers. The scene must outlive the result.
using MakePixelColor = PixelColor (*)(const SceneDescription& scene, int width, int height,
                                      const Quality& quality);

template <Effects effects>
PixelColor make_pixel_color(const SceneDescription& scene, int width, int height,
                            const Quality& quality) {
    return color_by(std::make_shared<const Renderer<effects>>(scene, width, height, quality));
}

inline constexpr auto renderer_makers = []<std::size_t... number>(std::index_sequence<number...>) {
    return std::array<MakePixelColor, sizeof...(number)>{
        make_pixel_color<renderer_effects[number]>...};
}
(std::make_index_sequence<renderer_effects.size()>{});

}  // namespace rt
