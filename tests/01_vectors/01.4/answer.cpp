#include <answer.hpp>
#include <rt/length.hpp>

namespace answer EXPORTED {

rt::Real length(const rt::Vec3& v) {
    return rt::length(v);
}

rt::Vec3 normalize(const rt::Vec3& v) {
    return rt::normalize(v);
}

}  // namespace EXPORTED
