#pragma once
#include <utility>

namespace rt {

// A search for a shadow ray (given). All that matters is whether the ray meets any shape, so after
// the first hit, which need not be the nearest, the search reaches no more children.
template <class Search>
struct AnyHit : Search {
    int at_start;

    explicit AnyHit(Search search) : Search{std::move(search)}, at_start{this->nearest} {}
    bool found() const { return this->nearest != at_start; }
    template <class Child>
    bool reaches(const Child&) const {
        return !found();
    }
};

}  // namespace rt
