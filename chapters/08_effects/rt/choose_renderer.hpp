#pragma once
#include <cstddef>
#include <rt/effects.hpp>
#include <span>
#include <stdexcept>

namespace rt {

// The number of the renderer for a scene that needs these effects (given): it has all of them, and
// no other renderer that has all of them has fewer effects. Of several such renderers, the first is
// taken.
// Throws std::invalid_argument if none has all of them.
inline std::size_t narrowest(const Effects& needed, std::span<const Effects> renderers) {
    std::size_t best = renderers.size();
    for (std::size_t i = 0; i < renderers.size(); ++i) {
        if (!covers(renderers[i], needed)) continue;
        if (best == renderers.size() || count(renderers[i]) < count(renderers[best])) best = i;
    }
    if (best == renderers.size())
        throw std::invalid_argument("no renderer has all of: " + names(needed));
    return best;
}

}  // namespace rt
