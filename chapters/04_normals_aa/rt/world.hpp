#pragma once
#include <concepts>
#include <optional>
#include <rt/hit.hpp>
#include <rt/interval.hpp>
#include <rt/ray.hpp>

namespace rt {

// What rays of a type are sent into (given): hit() gives the nearest hit within the interval. A
// type that lacks it is refused by name, where a template asks for a World.
template <class Type, class AnyRay = Ray>
concept World = requires(const Type& world, const AnyRay& ray, Interval within) {
    { world.hit(ray, within) } -> std::same_as<std::optional<Hit>>;
};

}  // namespace rt
