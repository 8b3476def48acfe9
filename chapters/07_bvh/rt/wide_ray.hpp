#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <rt/compiler.hpp>
#include <rt/slab_ray.hpp>

namespace rt {

// The margin that replaces hit_margin if boxes are tested in Number (given). A plane and the ray's
// origin are rounded to Number; the inverse, its products with both, and their sum are rounded; and
// so is the end of the interval. These seven roundings act as if the plane were moved by 4 epsilon
// of Number. The factor 8 also leaves room for hit_margin if Real is more precise than Number.
// Otherwise, hit_margin is the larger of the two, and has room for the roundings.
template <class Number>
inline constexpr Real wide_margin =
    std::max(hit_margin, 8 * static_cast<Real>(std::numeric_limits<Number>::epsilon()));

// The smallest component of a direction whose largest one is 1; smaller ones are raised to it,
// which moves the ray by far less than the margin. If 1 / direction were infinite, no plane along
// its axis would count, and the search would visit many boxes that the ray misses.
inline constexpr Real least_component = Real(0x1p-60);

// A ray made ready for the boxes of a WideNode (given): its direction is scaled so that the largest
// component is 1 or -1, which keeps t in the range of Number.
template <class Number>
struct WideRay {
    // 1 / direction, and -origin / direction: a plane at x is met at x * inverse + start. The
    // nearer plane is moved toward the ray, and the farther one away from it. If a start is too
    // large for Number, it is NaN, and the plane does not count.
    std::array<Number, 3> inverse, near_start, far_start;
    Real scale;  // t in box tests = t of the unscaled ray * scale

    // Which planes along an axis the ray meets first: 0 for the low ones, 1 for the high ones.
    std::size_t near(std::size_t axis) const { return std::signbit(inverse[axis]); }
};

// An infinite number becomes NaN; others stay. It takes packs, too.
template <class Number>
RT_INLINED Number finite_or_nan(Number x) {
    return x + (x - x);
}

template <class Number>
RT_INLINED WideRay<Number> wide_ray(const Ray& ray) {
    WideRay<Number> wide;
    wide.scale = max_component(ray.direction);
    const Real margin = wide_margin<Number> * max_component(ray.origin);
    const Real least = least_component * wide.scale;
    const auto raised = [least](Real x) {
        return std::abs(x) < least ? std::copysign(least, x) : x;
    };
    const std::array<Real, 3> d{raised(ray.direction.x), raised(ray.direction.y),
                                raised(ray.direction.z)},
        origin{ray.origin.x, ray.origin.y, ray.origin.z};
    // No branch: no processor can predict whether a random direction runs forward.
    for (std::size_t k = 0; k < 3; ++k) {
        wide.inverse[k] = static_cast<Number>(wide.scale / d[k]);
        const Real ahead = std::copysign(margin, d[k]);
        wide.near_start[k] =
            finite_or_nan(static_cast<Number>(-ahead - origin[k]) * wide.inverse[k]);
        wide.far_start[k] = finite_or_nan(static_cast<Number>(ahead - origin[k]) * wide.inverse[k]);
    }
    return wide;
}

}  // namespace rt
