#pragma once
// What path_radiance is written over, as types that both sides know.

#include <any_random.hpp>
#include <functional>
#include <optional>
#include <rt/hit.hpp>
#include <rt/interval.hpp>
#include <rt/path_end.hpp>
#include <rt/ray.hpp>
#include <rt/rng.hpp>
#include <rt/scatter.hpp>

namespace answer {

// A ray that carries something else.
struct TimedRay {
    rt::Vec3 origin, direction;
    rt::Real time;
};

template <class AnyRay>
struct World {
    std::function<std::optional<rt::Hit>(const AnyRay&, rt::Interval)> find;
    std::optional<rt::Hit> hit(const AnyRay& ray, rt::Interval within) const {
        return find(ray, within);
    }
};

using Materials = std::function<std::optional<rt::Scatter>(rt::Vec3, const rt::Hit&, rt::Rng&)>;
using Sky = std::function<rt::Color(rt::Vec3)>;
using Ending = std::function<rt::PathEnd(rt::Color&, rt::Rng&)>;

}  // namespace answer
