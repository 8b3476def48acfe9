#include <answer.hpp>
#include <rt/triangle_point.hpp>

namespace answer EXPORTED {

rt::Hit surface_hit(const rt::SceneTriangle& triangle, const rt::Ray& ray, rt::Real t) {
    return rt::surface_hit(triangle, ray, t);
}

}  // namespace EXPORTED
