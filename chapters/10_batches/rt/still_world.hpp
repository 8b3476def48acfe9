#pragma once
#include <rt/aggregate.hpp>
#include <rt/effects.hpp>
#include <rt/path_record.hpp>
#include <rt/timed_ray.hpp>
#include <rt/wide_tree.hpp>
#include <vector>

namespace rt {

// The two parts of a world (given): the tree of spheres that stand still, which lists of rays go
// down, and the rest, if any, which is searched for one ray at a time.
inline const WideTree& still_part(const WideTree& world) {
    return world;
}
template <class First, class Second>
const WideTree& still_part(const Aggregate<First, Second>& world) {
    return still_part(world.first);
}

template <class AnyRay>
std::optional<Hit> hit_other_part(const WideTree&, const AnyRay&, Interval) {
    return {};
}
template <class First, class Second, class AnyRay>
std::optional<Hit> hit_other_part(const Aggregate<First, Second>& world, const AnyRay& ray,
                                  Interval within) {
    const std::optional<Hit> in_first = hit_other_part(world.first, ray, within);
    if (in_first) within.max = in_first->t;
    const std::optional<Hit> in_second = world.second.hit(ray, within);
    return in_second ? in_second : in_first;
}

// True if a ray meets anything but the tree's spheres.
template <class AnyRay>
bool other_part_occludes(const WideTree&, const AnyRay&, Interval) {
    return false;
}
template <class First, class Second, class AnyRay>
bool other_part_occludes(const Aggregate<First, Second>& world, const AnyRay& ray,
                         Interval within) {
    return other_part_occludes(world.first, ray, within) || world.second.occluded(ray, within);
}

// The ray of a path, with the time of its sample if anything moves.
template <Effects effects>
auto ray_of(const PathRecord& path, const std::vector<Real>& times) {
    if constexpr (effects.motion)
        return TimedRay{path.origin, path.direction, times[static_cast<std::size_t>(path.sample)]};
    else
        return Ray{path.origin, path.direction};
}
template <class World>
inline constexpr bool has_other_part = !std::is_same_v<World, WideTree>;

}  // namespace rt
