#pragma once
#include <array>
#include <string>

namespace rt {

// What a scene may call for beyond matte spheres, a pinhole and the sky. An effect costs time only
// in a renderer that has it.
struct Effects {
    bool mirror = false;     // metal without fuzz
    bool fuzz = false;       // metal with fuzz
    bool glass = false;      // reflects and refracts
    bool texture = false;    // an albedo that changes over the surface
    bool lens = false;       // an aperture that is not 0
    bool motion = false;     // spheres that move while the shutter is open
    bool lights = false;     // spheres that shine
    bool fog = false;        // a medium between the surfaces, which scatters light
    bool instances = false;  // spheres that a matrix stretches and turns
    bool own = false;        // the material of exercise 05.6
    bool haze = false;       // air that dims what is far away

    friend constexpr bool operator==(const Effects&, const Effects&) = default;
};

struct NamedEffect {
    const char* name;
    bool Effects::*member;
};

inline constexpr std::array all_effects{NamedEffect{"mirror", &Effects::mirror},
                                        NamedEffect{"fuzz", &Effects::fuzz},
                                        NamedEffect{"glass", &Effects::glass},
                                        NamedEffect{"texture", &Effects::texture},
                                        NamedEffect{"lens", &Effects::lens},
                                        NamedEffect{"motion", &Effects::motion},
                                        NamedEffect{"lights", &Effects::lights},
                                        NamedEffect{"fog", &Effects::fog},
                                        NamedEffect{"instances", &Effects::instances},
                                        NamedEffect{"own", &Effects::own},
                                        NamedEffect{"haze", &Effects::haze}};

// All effects.
inline constexpr Effects every_effect = [] {
    Effects every;
    for (const NamedEffect& effect : all_effects) every.*effect.member = true;
    return every;
}();

// The number of effects in this set.
constexpr int count(const Effects& effects) {
    int sum = 0;
    for (const NamedEffect& effect : all_effects) sum += effects.*effect.member ? 1 : 0;
    return sum;
}

// True when each of `needed` is among `present`.
constexpr bool covers(const Effects& present, const Effects& needed) {
    for (const NamedEffect& effect : all_effects)
        if (needed.*effect.member && !(present.*effect.member)) return false;
    return true;
}

// The effects in a, in b or in both.
constexpr Effects with(Effects a, const Effects& b) {
    for (const NamedEffect& effect : all_effects)
        if (b.*effect.member) a.*effect.member = true;
    return a;
}

// The effects in a that are not in b.
constexpr Effects without(Effects a, const Effects& b) {
    for (const NamedEffect& effect : all_effects)
        if (b.*effect.member) a.*effect.member = false;
    return a;
}

// The names of these effects, such as "mirror, glass, lens", or "none".
inline std::string names(const Effects& effects) {
    std::string all;
    for (const NamedEffect& effect : all_effects)
        if (effects.*effect.member) all += (all.empty() ? "" : ", ") + std::string{effect.name};
    return all.empty() ? "none" : all;
}

}  // namespace rt
