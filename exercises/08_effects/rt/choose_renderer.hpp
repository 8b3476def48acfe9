#pragma once
#include <cstddef>
#include <rt/effects.hpp>
#include <rt/todo.hpp>
#include <span>
#include <stdexcept>

namespace rt {

// Exercise 08.6. The number of the renderer for a scene that needs these effects: it has all of
// them, and no other renderer that has all of them has fewer effects. If there are several such
// renderers, it is the first. The functions covers() and count() of effects.hpp help. Throws
// std::invalid_argument, with a message of your own, if no renderer has all of them.
inline std::size_t narrowest(const Effects& needed, std::span<const Effects> renderers) {
    return rt::todo("08.6", needed, renderers);
}

}  // namespace rt
