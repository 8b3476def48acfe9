#include <answer.hpp>
#include <rt/cross.hpp>

namespace answer EXPORTED {

rt::Vec3 cross(const rt::Vec3& a, const rt::Vec3& b) {
    return rt::cross(a, b);
}

}  // namespace EXPORTED
