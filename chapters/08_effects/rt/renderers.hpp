#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <rt/effects.hpp>
#include <rt/renderer.hpp>

namespace rt {

// The color of a pixel with this seed; the number of rays that were traced is added to `rays`.
using PixelShader =
    std::function<Color(int column, int row, std::uint64_t seed, std::uint64_t& rays)>;

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

// Makes a PixelShader, which draws a scene with one of these renderers. The scene must outlive the
// PixelShader.
using MakeShader = PixelShader (*)(const SceneDescription& scene, int width, int height,
                                   const Quality& quality);

template <Effects effects>
PixelShader make_shader(const SceneDescription& scene, int width, int height,
                        const Quality& quality) {
    auto renderer = std::make_shared<const Renderer<effects>>(scene, width, height, quality);
    return [renderer, count = quality.samples_per_pixel](int column, int row, std::uint64_t seed,
                                                         std::uint64_t& rays) {
        return (*renderer)(JitteredSamples{seed, count}, column, row, rays);
    };
}

inline constexpr auto renderer_makers = []<std::size_t... number>(std::index_sequence<number...>) {
    return std::array<MakeShader, sizeof...(number)>{make_shader<renderer_effects[number]>...};
}
(std::make_index_sequence<renderer_effects.size()>{});

}  // namespace rt
