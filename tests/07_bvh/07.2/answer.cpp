#include <answer.hpp>
#include <rt/bounds.hpp>
#include <rt/hit_box.hpp>

namespace answer EXPORTED {

rt::Box bounds_of(const rt::Sphere& sphere) {
    return rt::bounds_of(sphere);
}

rt::Box join(const rt::Box& a, const rt::Box& b) {
    return rt::join(a, b);
}

rt::Interval hit_box(const rt::Box& box, const rt::SlabRay& ray, rt::Interval within) {
    return rt::hit_box(box, ray, within);
}

}  // namespace EXPORTED
