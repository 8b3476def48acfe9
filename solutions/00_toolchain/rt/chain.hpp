#pragma once
#include <rt/link.hpp>
#include <vector>

namespace rt {

// The sum of the values of a chain, added up from its first link to its last. The chain is given by
// the address of its first link; an empty chain is nullptr, and its sum is 0.
inline Real sum_along(const Link* first) {
    Real sum = 0;
    for (const Link* link = first; link; link = link->next) sum += link->value;
    return sum;
}

// The same chain in one piece of memory: the links are in the chain's order, each points to the
// next, and the last points to nullptr. No link points back into the old chain. If the vector is
// moved, its links keep their addresses. A copy of the vector would have links that point into the
// original.
inline std::vector<Link> gathered(const Link* first) {
    std::vector<Link> links;
    for (const Link* link = first; link; link = link->next) links.push_back({link->value, nullptr});
    // Only now, because a vector that grows may move its links to new addresses.
    for (std::size_t i = 1; i < links.size(); ++i) links[i - 1].next = &links[i];
    return links;
}

}  // namespace rt
