#pragma once
#include <rt/link.hpp>
#include <vector>

namespace rt {

inline Real sum_along(const Link* first) {
    Real sum = 0;
    for (const Link* link = first; link; link = link->next) sum += link->value;
    return sum;
}

inline std::vector<Link> gathered(const Link* first) {
    std::vector<Link> links;
    links.reserve(1000);
    for (const Link* link = first; link; link = link->next) {
        links.push_back({link->value, nullptr});
        if (links.size() > 1) links[links.size() - 2].next = &links.back();
    }
    return links;
}

}  // namespace rt
