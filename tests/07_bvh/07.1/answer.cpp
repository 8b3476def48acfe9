#include <answer.hpp>
#include <rt/box_pack.hpp>
#include <rt/hit_box.hpp>
#include <rt/wide.hpp>
#include <rt/wide_ray.hpp>

namespace answer EXPORTED {

rt::Interval hit_box(const rt::Box& box, const rt::SlabRay& ray, rt::Interval within) {
    return rt::hit_box(box, ray, within);
}

rt::Lanes<rt::Interval> hit_eight(const rt::Lanes<rt::Box>& boxes, const rt::SlabRay& ray,
                                  rt::Interval within) {
    const auto three = [](rt::Vec3 v) { return rt::Vec3Of<rt::Real>{v.x, v.y, v.z}; };
    const rt::WideRay<rt::Real> wide{three(ray.origin), three(ray.inverse), ray.margin, 1};
    rt::Lanes<rt::Interval> parts;
    constexpr std::size_t size = rt::part_size<rt::Real>;
    for (std::size_t first = 0; first < rt::lanes; first += size) {
        rt::BoxPack<rt::Reals> some{};
        rt::IntervalPack<rt::Reals> all{};
        for (std::size_t i = 0; i < size; ++i) {
            const auto& [low, high] = boxes[first + i];
            some.low.x[i] = low.x, some.low.y[i] = low.y, some.low.z[i] = low.z;
            some.high.x[i] = high.x, some.high.y[i] = high.y, some.high.z[i] = high.z;
            all.min[i] = within.min, all.max[i] = within.max;
        }
        const rt::IntervalPack<rt::Reals> part = rt::hit_box(some, wide, all);
        for (std::size_t i = 0; i < size; ++i) parts[first + i] = {part.min[i], part.max[i]};
    }
    return parts;
}

}  // namespace EXPORTED
