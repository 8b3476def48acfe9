#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <rt/effects.hpp>
#include <rt/renderer.hpp>

namespace rt {

// The color of a pixel; the rays that it took are added to `rays`.
using PixelShader = std::function<Color(int column, int row, std::uint64_t& rays)>;

// The renderers that are compiled (given), one for each of these sets of effects. All 256 would
// take minutes and megabytes. These are the products of four choices, each of which has few ways to
// go: materials, camera, world, and what lies between the surfaces.
inline constexpr Effects with_all{true, true, true, true, true, true, true, true};

inline constexpr auto renderer_effects = [] {
    // Materials: matte alone, with metal, with glass, all.
    constexpr std::array<Effects, 4> materials{
        {{},
         {.mirror = true, .fuzz = true},
         {.glass = true},
         {.mirror = true, .fuzz = true, .glass = true, .texture = true}}};
    std::array<Effects, 64> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i] = materials[i % 4];
        all[i].lens = i / 4 % 2 == 1;
        all[i].motion = i / 8 % 2 == 1;
        all[i].lights = i / 16 % 2 == 1;
        all[i].fog = i / 32 == 1;
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
    return [renderer](int column, int row, std::uint64_t& rays) {
        return (*renderer)(column, row, rays);
    };
}

inline constexpr auto renderer_makers = []<std::size_t... number>(std::index_sequence<number...>) {
    return std::array<MakeShader, sizeof...(number)>{make_shader<renderer_effects[number]>...};
}
(std::make_index_sequence<renderer_effects.size()>{});

}  // namespace rt
