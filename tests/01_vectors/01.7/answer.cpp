#include <answer.hpp>
#include <rt/inverse.hpp>

namespace answer EXPORTED {

rt::Mat4 inverse(const rt::Mat4& m) {
    return rt::inverse(m);
}

rt::Vec3 to_object(const rt::Mat4& object_to_world, const rt::Vec3& world_point) {
    return rt::to_object(object_to_world, world_point);
}

rt::Vec3 to_world(const rt::Mat4& object_to_world, const rt::Vec3& object_point) {
    return rt::to_world(object_to_world, object_point);
}

}  // namespace EXPORTED
