#include <answer.hpp>
#include <rt/smooth_normal.hpp>

namespace answer EXPORTED {

rt::Vec3 smooth_normal(const std::array<rt::Vec3, 3>& normals, rt::Real u, rt::Real v,
                       rt::Vec3 flat) {
    return rt::smooth_normal(normals, u, v, flat);
}

rt::Vec3 bent_normal(rt::Vec3 smooth, rt::Vec3 flat, rt::Vec3 incoming) {
    return rt::bent_normal(smooth, flat, incoming);
}

rt::Vec3 keep_side(rt::Vec3 direction, rt::Vec3 smooth, rt::Vec3 flat) {
    return rt::keep_side(direction, smooth, flat);
}

}  // namespace EXPORTED
