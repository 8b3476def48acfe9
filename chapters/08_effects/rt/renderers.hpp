#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <rt/effects.hpp>
#include <rt/renderer.hpp>

namespace rt {

// The color of a pixel with this seed; the rays that it took are added to `rays`.
using PixelShader =
    std::function<Color(int column, int row, std::uint64_t seed, std::uint64_t& rays)>;

// The renderers that are compiled (given), each for one of these sets of effects: 30 of 2048
// possible ones. They vary in the four choices where this pays off, and only in the combinations
// that gain something:
//   camera     pinhole or lens
//   materials  matte alone, with metal, with glass, all: with one material nothing has to be looked
//              up; an alternative that is not used costs little more than its place in a table
//   motion, lights, fog   each there or not; all materials with them
//   instances  alone, with lights, or with motion, lights and fog; all materials with them
//   haze  alone; all materials with it
// The material of 05.6 is in the widest alone, which have everything, and so is any effect that a
// later chapter adds.
inline constexpr auto renderer_effects = [] {
    const Effects all_materials{.mirror = true, .fuzz = true, .glass = true, .texture = true};
    const std::array<Effects, 4> materials{
        {{}, {.mirror = true, .fuzz = true}, {.glass = true}, all_materials}};
    std::array<Effects, 30> all{};
    std::size_t count = 0;
    for (const bool lens : {false, true}) {
        for (Effects effects : materials) {
            effects.lens = lens;
            all[count++] = effects;
        }
        for (int beyond = 1; beyond < 8; ++beyond) {
            Effects effects = all_materials;
            effects.lens = lens;
            effects.motion = beyond & 1;
            effects.lights = beyond & 2;
            effects.fog = beyond & 4;
            all[count++] = effects;
        }
        for (const bool lights : {false, true}) {
            Effects effects = all_materials;
            effects.lens = lens;
            effects.instances = true;
            effects.lights = lights;
            all[count++] = effects;
        }
        all[count] = all_materials;
        all[count].haze = true;
        all[count++].lens = lens;
        all[count] = every_effect;
        all[count++].lens = lens;
    }
    return all;
}();

// The scene made ready for renderer `number` of renderer_effects. The scene must outlive it.
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
