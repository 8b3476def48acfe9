#pragma once
#include <array>
#include <rt/effects.hpp>

namespace effects {

// The sets of effects for which the electives' renderers are compiled. There are few, because each
// takes long to compile, and because an effect that is compiled in but not used costs these
// renderers little. The last set has all effects.
inline constexpr std::array<rt::Effects, 5> few_effects = [] {
    constexpr rt::Effects materials{
        .mirror = true, .fuzz = true, .glass = true, .texture = true, .lens = true};
    rt::Effects moving = materials, lit = materials;
    moving.motion = moving.instances = true;
    lit.lights = lit.instances = true;
    return std::array<rt::Effects, 5>{{{}, materials, moving, lit, rt::every_effect}};
}();

}  // namespace effects
