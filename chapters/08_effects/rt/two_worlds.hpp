#pragma once
#include <optional>
#include <rt/hit.hpp>
#include <rt/interval.hpp>

namespace rt {

// Two worlds in one (given): a ray hits what it meets first in either of them.
template <class First, class Second>
struct TwoWorlds {
    First first;
    Second second;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        const std::optional<Hit> in_first = first.hit(ray, within);
        if (in_first) within.max = in_first->t;
        const std::optional<Hit> in_second = second.hit(ray, within);
        return in_second ? in_second : in_first;
    }
};

}  // namespace rt
