#include <answer.hpp>
#include <rt/refract.hpp>

namespace answer EXPORTED {

std::optional<rt::Vec3> refract(rt::Vec3 incoming, rt::Vec3 normal, rt::Real eta) {
    return rt::refract(incoming, normal, eta);
}

}  // namespace EXPORTED
