#include <answer.hpp>
#include <rt/facing.hpp>

namespace answer EXPORTED {

int facing(const rt::Vec3& normal, const rt::Vec3& to_viewer) {
    return rt::facing(normal, to_viewer);
}

}  // namespace EXPORTED
