#pragma once
#include <array>
#include <rt/effects.hpp>
#include <utility>

namespace full_renderer {

// The sets of effects for which the electives' renderers are compiled. There are few, because each
// takes long to compile. docs/studies/08_effects.md says what effects cost that a renderer has and
// a scene lacks. The last set has all effects.
inline constexpr std::array<rt::Effects, 4> few_effects = [] {
    constexpr rt::Effects materials{
        .mirror = true, .fuzz = true, .glass = true, .texture = true, .lens = true};
    rt::Effects moving = materials, lit = materials;
    moving.motion = moving.instances = true;
    lit.lights = lit.instances = true;
    return std::array<rt::Effects, 4>{{materials, moving, lit, rt::every_effect}};
}();

// Calls make<set>() for each of these sets, and returns the results in the order of the sets.
template <class Make>
constexpr auto for_few_effects(const Make& make) {
    return [&]<std::size_t... index>(std::index_sequence<index...>) {
        return std::array{make.template operator()<few_effects[index]>()...};
    }
    (std::make_index_sequence<few_effects.size()>{});
}

}  // namespace full_renderer
