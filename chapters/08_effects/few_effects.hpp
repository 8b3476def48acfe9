#pragma once
#include <array>
#include <rt/effects.hpp>

namespace effects {

// The sets of effects for which the electives' renderers are compiled: few, since each takes long,
// and since theirs lose little by an effect that is there in vain. The last one has all.
inline constexpr std::array<rt::Effects, 5> few_effects = [] {
    constexpr rt::Effects materials{
        .mirror = true, .fuzz = true, .glass = true, .texture = true, .lens = true};
    rt::Effects moving = materials, lit = materials, all = materials;
    moving.motion = moving.instances = true;
    lit.lights = lit.instances = true;
    for (const rt::NamedEffect& effect : rt::all_effects) all.*effect.member = true;
    return std::array<rt::Effects, 5>{{{}, materials, moving, lit, all}};
}();

}  // namespace effects
