#include <answer.hpp>
#include <rt/leave_surface.hpp>

namespace answer EXPORTED {

rt::Vec3 leave_surface(const rt::Hit& hit, rt::Vec3 direction) {
    return rt::leave_surface(hit, direction);
}

}  // namespace EXPORTED
