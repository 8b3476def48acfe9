#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <rt/compiler.hpp>
#include <rt/slab_ray.hpp>

namespace rt {

// hit_margin for tests of boxes in Number (given). A plane and the ray's origin are rounded to
// Number; their difference, the inverse and their product are rounded; and so is the end of
// the interval. These six roundings act as if the plane were moved by 3 epsilon of Number. 8
// leaves room for hit_margin if Real is more precise; if it is not, hit_margin is larger and
// has room for them.
template <class Number>
inline constexpr Real wide_margin =
    std::max(hit_margin, 8 * static_cast<Real>(std::numeric_limits<Number>::epsilon()));

// A ray made ready for the boxes of a WideNode (given): its direction scaled so that its largest
// component is 1 or -1, which keeps t within what Number can hold.
template <class Number>
struct WideRay {
    std::array<Number, 3> near_origin, far_origin, inverse;
    std::array<std::size_t, 3> near;  // which planes are met first: 0 for the low ones, or 1
    Real scale = 1;                   // what t is multiplied by

    explicit WideRay(const Ray& ray) : scale{max_component(ray.direction)} {
        const Real margin = wide_margin<Number> * max_component(ray.origin);
        const std::array<Real, 3> d{ray.direction.x, ray.direction.y, ray.direction.z},
            origin{ray.origin.x, ray.origin.y, ray.origin.z};
        // No branch: no processor can predict whether a random direction runs forward.
        for (std::size_t k = 0; k < 3; ++k) {
            near[k] = std::signbit(d[k]);
            inverse[k] = static_cast<Number>(scale / d[k]);
            // The nearer plane is moved toward the ray, and the farther one away from it.
            const Real ahead = std::copysign(margin, d[k]);
            near_origin[k] = static_cast<Number>(origin[k] + ahead);
            far_origin[k] = static_cast<Number>(origin[k] - ahead);
        }
    }
};

}  // namespace rt
