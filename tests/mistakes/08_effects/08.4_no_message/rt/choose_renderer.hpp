#pragma once
#include <cstddef>
#include <rt/effects.hpp>
#include <span>
#include <stdexcept>

namespace rt {

// Which of these renderers draws a scene that needs these effects: it has all of them, and no
// other that does has fewer. Of several, the first. Throws std::invalid_argument when none has all.
inline std::size_t narrowest(const Effects& needed, std::span<const Effects> renderers) {
    std::size_t best = renderers.size();
    for (std::size_t i = 0; i < renderers.size(); ++i) {
        if (!covers(renderers[i], needed)) continue;
        if (best == renderers.size() || count(renderers[i]) < count(renderers[best])) best = i;
    }
    if (best == renderers.size()) throw std::invalid_argument("");
    return best;
}

}  // namespace rt
