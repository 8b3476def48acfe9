#include <answer.hpp>
#include <rt/lambert.hpp>

namespace answer EXPORTED {

rt::Real lambert(rt::Vec3 normal, rt::Vec3 to_light) {
    return rt::lambert(normal, to_light);
}

}  // namespace EXPORTED
