#include <answer.hpp>
#include <rt/box_pack.hpp>
#include <rt/hit_box.hpp>
#include <rt/wide.hpp>
#include <rt/wide_ray.hpp>

namespace {

template <class Number>
rt::Lanes<rt::Interval> hit_packs(const rt::Lanes<rt::Box>& boxes, const rt::SlabRay& ray,
                                  rt::Interval within) {
    using Pack = rt::Part<Number>;
    constexpr std::size_t size = rt::part_size<Number>;
    const auto number = [](rt::Real x) { return static_cast<Number>(x); };
    const auto three = [&](rt::Vec3 v) {
        return rt::Vec3Of<Number>{number(v.x), number(v.y), number(v.z)};
    };
    const rt::WideRay<Number> wide{three(ray.origin), three(ray.inverse), number(ray.margin), 1};
    rt::Lanes<rt::Interval> parts;
    for (std::size_t first = 0; first < rt::lanes; first += size) {
        rt::BoxPack<Pack> some{};
        rt::IntervalPack<Pack> all{};
        for (std::size_t i = 0; i < size; ++i) {
            const auto low = three(boxes[first + i].low), high = three(boxes[first + i].high);
            some.low.x[i] = low.x, some.low.y[i] = low.y, some.low.z[i] = low.z;
            some.high.x[i] = high.x, some.high.y[i] = high.y, some.high.z[i] = high.z;
            all.min[i] = number(within.min), all.max[i] = number(within.max);
        }
        const rt::IntervalPack<Pack> part = rt::hit_box(some, wide, all);
        for (std::size_t i = 0; i < size; ++i) parts[first + i] = {part.min[i], part.max[i]};
    }
    return parts;
}

}  // namespace

namespace answer EXPORTED {

rt::Interval hit_box(const rt::Box& box, const rt::SlabRay& ray, rt::Interval within) {
    return rt::hit_box(box, ray, within);
}

rt::Lanes<rt::Interval> hit_eight(const rt::Lanes<rt::Box>& boxes, const rt::SlabRay& ray,
                                  rt::Interval within) {
    return hit_packs<rt::Real>(boxes, ray, within);
}

rt::Lanes<rt::Interval> hit_eight_in_float(const rt::Lanes<rt::Box>& boxes, const rt::SlabRay& ray,
                                           rt::Interval within) {
    return hit_packs<float>(boxes, ray, within);
}

}  // namespace EXPORTED
