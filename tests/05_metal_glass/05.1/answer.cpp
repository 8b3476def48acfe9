#include <answer.hpp>
#include <rt/reflect.hpp>

namespace answer EXPORTED {

rt::Vec3 reflect(rt::Vec3 incoming, rt::Vec3 normal) {
    return rt::reflect(incoming, normal);
}

}  // namespace EXPORTED
