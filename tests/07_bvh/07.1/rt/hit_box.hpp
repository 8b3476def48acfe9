#pragma once
#include <array>
#include <rt/box.hpp>
#include <rt/interval.hpp>
#include <rt/slab_ray.hpp>
#include <rt/wide.hpp>

namespace answer {

rt::Interval hit_box(const rt::Box& box, const rt::SlabRay& ray, rt::Interval within);

// The same for eight boxes, as many at once as fit into a register; the other one computes in
// float.
rt::Lanes<rt::Interval> hit_eight(const rt::Lanes<rt::Box>& boxes, const rt::SlabRay& ray,
                                  rt::Interval within);
rt::Lanes<rt::Interval> hit_eight_in_float(const rt::Lanes<rt::Box>& boxes, const rt::SlabRay& ray,
                                           rt::Interval within);

}  // namespace answer

namespace rt {

using answer::hit_box;

}  // namespace rt
