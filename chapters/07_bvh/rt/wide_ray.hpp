#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <rt/box_pack.hpp>
#include <rt/compiler.hpp>
#include <rt/slab_ray.hpp>
#include <rt/vec3_of.hpp>

namespace rt {

// The margin that replaces hit_margin if boxes are tested in Number (given). The ray's origin is
// rounded to Number, and so is a plane, twice: by itself, and after its margin is added. Then its
// distance from the origin, the inverse, the product of the two, and the end of the interval are
// rounded. A rounding changes a number by at most half of epsilon. So these seven act as if the
// plane were moved by 3 epsilon of Number, relative to the coordinates involved. The factor 8 also
// leaves room for hit_margin if Real is more precise than Number. Otherwise, hit_margin is the
// larger of the two, and has room for the roundings.
template <class Number>
inline constexpr Real wide_margin =
    std::max(hit_margin, 8 * static_cast<Real>(std::numeric_limits<Number>::epsilon()));

// The smallest component of a direction whose largest one is 1; smaller ones are raised to it,
// which moves the ray by far less than the margin. If 1 / direction were infinite, no plane along
// its axis would count, and the search would visit many boxes that the ray misses.
inline constexpr Real least_component = Real(0x1p-60);

// A ray made ready for the boxes of a WideNode (given): a SlabRay of Numbers. Its direction is
// scaled so that the largest component is 1 or -1, which keeps t in the range of Number.
template <class Number>
struct WideRay {
    Vec3Of<Number> origin;  // NaN where it is too large for Number: then no plane counts
    Vec3Of<Number> inverse;
    Number margin;
    Real scale;  // t in box tests = t of the unscaled ray * scale
};

// An infinite number becomes NaN; others stay. It takes packs, too.
template <class Number>
RT_INLINED Number finite_or_nan(Number x) {
    return x + (x - x);
}

// The ray from this origin, whose inverse and scale are known.
template <class Number>
RT_INLINED WideRay<Number> wide_ray(const Vec3& origin, const Vec3Of<Number>& inverse, Real scale) {
    const auto start = [](Real o) { return finite_or_nan(static_cast<Number>(o)); };
    return {{start(origin.x), start(origin.y), start(origin.z)},
            inverse,
            static_cast<Number>(wide_margin<Number> * max_component(origin)),
            scale};
}

template <class Number>
RT_INLINED WideRay<Number> wide_ray(const Ray& ray) {
    const Real scale = max_component(ray.direction);
    const Real least = least_component * scale;
    const auto inverse = [&](Real d) {
        return static_cast<Number>(scale / (std::abs(d) < least ? std::copysign(least, d) : d));
    };
    const auto& [o, d] = ray;
    return wide_ray<Number>(o, {inverse(d.x), inverse(d.y), inverse(d.z)}, scale);
}

}  // namespace rt
