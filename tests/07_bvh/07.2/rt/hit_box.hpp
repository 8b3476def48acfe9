#pragma once
// The answer's own: the margin must be wide enough for its roundings, too.

#include <rt/box.hpp>
#include <rt/interval.hpp>
#include <rt/slab_ray.hpp>

namespace answer {

rt::Interval hit_box(const rt::Box& box, const rt::SlabRay& ray, rt::Interval within);

}  // namespace answer

namespace rt {

using answer::hit_box;

}  // namespace rt
