#pragma once
#include <rt/link.hpp>
#include <vector>

namespace rt {

inline Real sum_along(const Link* first) {
    if (!first) return 0;
    return first->value + sum_along(first->next);
}

inline std::vector<Link> gathered(const Link* first) {
    std::vector<Link> links;
    for (const Link* link = first; link; link = link->next) links.push_back({link->value, nullptr});
    for (std::size_t i = 1; i < links.size(); ++i) links[i - 1].next = &links[i];
    return links;
}

}  // namespace rt
