#include <answer.hpp>
#include <rt/surface_hit.hpp>

namespace answer EXPORTED {

rt::Hit surface_hit(const rt::Sphere& sphere, const rt::Ray& ray, rt::Real t) {
    return rt::surface_hit(sphere, ray, t);
}

}  // namespace EXPORTED
