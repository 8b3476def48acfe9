#pragma once
#include <rt/link.hpp>
#include <vector>

namespace rt {

inline Real sum_along(const Link* first) {
    Real sum;
    for (const Link* link = first; link; link = link->next) sum += link->value;
    return sum;
}

inline std::vector<Link> gathered(const Link* first) {
    std::vector<Link> links;
    for (const Link* link = first; link; link = link->next) links.push_back({link->value, nullptr});
    for (std::size_t i = 1; i < links.size(); ++i) links[i - 1].next = &links[i];
    return links;
}

}  // namespace rt
