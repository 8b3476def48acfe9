#pragma once
#include <optional>
#include <rt/world.hpp>
#include <utility>

namespace rt {

// Two worlds in one (given): a ray hits whatever it meets first in either of them. Such a world is
// called an aggregate. Each of the two may itself be an aggregate.
template <World First, World Second>
struct Aggregate {
    First first;
    Second second;

    // If both hits are equally near, that of the second world counts.
    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        std::optional<Hit> nearest = first.hit(ray, within);
        if (nearest) within.max = nearest->t;
        if (const std::optional<Hit> in_second = second.hit(ray, within)) nearest = in_second;
        return nearest;
    }

    // True if anything is hit within the interval. `number` is that of a shape in the first world:
    // see WideTreeOf.
    template <class AnyRay>
    bool occluded(const AnyRay& ray, Interval within, int number = -1) const {
        return first.occluded(ray, within, number) || second.occluded(ray, within);
    }
};

// Stands for a world that is absent.
struct NoWorld {};

// One world made of two. A world that is absent does not appear in its type.
template <World First, World Second>
Aggregate<First, Second> both(First first, Second second) {
    return {std::move(first), std::move(second)};
}
template <World First>
First both(First first, NoWorld) {
    return first;
}

}  // namespace rt
