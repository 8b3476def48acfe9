#include <answer.hpp>
#include <rt/hit_box.hpp>

namespace answer EXPORTED {

bool hit_box(const rt::Box& box, const rt::SlabRay& ray, rt::Interval within) {
    return rt::hit_box(box, ray, within);
}

}  // namespace EXPORTED
