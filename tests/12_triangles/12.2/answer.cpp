#include <answer.hpp>
#include <rt/triangle_shape.hpp>

namespace answer EXPORTED {

rt::Box bounds_of(const rt::SceneTriangle& triangle) {
    return rt::bounds_of(triangle);
}

std::optional<rt::Real> hit_shape(const rt::SceneTriangle& triangle, const rt::Ray& ray,
                                  rt::Interval within) {
    return rt::hit_shape(triangle, ray, within);
}

std::vector<rt::SceneTriangle> triangles_of(const rt::Mesh& mesh, int material, int first) {
    return rt::triangles_of(mesh, material, first);
}

}  // namespace EXPORTED
