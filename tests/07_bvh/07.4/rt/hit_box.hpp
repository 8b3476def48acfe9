#pragma once
// The answer's own: its roundings decide which boxes a search meets.

#include <rt/box.hpp>
#include <rt/interval.hpp>
#include <rt/slab_ray.hpp>

namespace answer {

rt::Interval hit_box(const rt::Box& box, const rt::SlabRay& ray, rt::Interval within);

}  // namespace answer

namespace rt {

using answer::hit_box;

}  // namespace rt
