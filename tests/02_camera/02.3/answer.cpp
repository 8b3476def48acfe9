#include <answer.hpp>
#include <rt/look_at.hpp>

namespace answer EXPORTED {

rt::Basis look_at(const rt::Vec3& from, const rt::Vec3& at, const rt::Vec3& up) {
    return rt::look_at(from, at, up);
}

}  // namespace EXPORTED
