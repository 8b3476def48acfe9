#include <answer.hpp>
#include <rt/dot.hpp>

namespace answer EXPORTED {

rt::Real dot(const rt::Vec3& a, const rt::Vec3& b) {
    return rt::dot(a, b);
}

}  // namespace EXPORTED
