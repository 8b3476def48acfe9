#pragma once
#include <rt/link.hpp>
#include <rt/todo.hpp>
#include <vector>

namespace rt {

// Exercise 00.5. The sum of the values of a chain, added up in a Real from its first link to its
// last: in a different order or type, the sum would be rounded differently. The chain is given by
// the address of its first link; an empty chain is nullptr, and its sum is 0.
// Star: a chain may have millions of links.
inline Real sum_along(const Link* first) {
    return rt::todo("00.5", first);
}

// Exercise 00.5. The same chain in one piece of memory: the links are in the chain's order, each
// points to the next, and the last points to nullptr. None of them points into the old chain. The
// caller moves the vector and never copies it.
// Star: a chain may have millions of links.
inline std::vector<Link> gathered(const Link* first) {
    return rt::todo("00.5", first);
}

}  // namespace rt
