#pragma once
#include <rt/link.hpp>
#include <rt/todo.hpp>
#include <vector>

namespace rt {

// Exercise 00.5. The sum of the values of a chain, added up from its first link to its last one, in
// a Real: another order, or another type of number, is rounded otherwise. The chain is given by the
// address of its first link; an empty one is nullptr, and its sum 0. A chain may have millions of
// links.
inline Real sum_along(const Link* first) {
    return rt::todo("00.5", first);
}

// Exercise 00.5. The same chain in one piece of memory: the links in the order in which the chain
// goes through them, each leading to the one behind it, the last to nullptr. None leads back to the
// old chain. The caller moves the vector and never copies it.
inline std::vector<Link> gathered(const Link* first) {
    return rt::todo("00.5", first);
}

}  // namespace rt
