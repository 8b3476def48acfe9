#include <answer.hpp>
#include <rt/hit_triangle.hpp>

namespace answer EXPORTED {

std::optional<rt::TriangleHit> hit_triangle(const rt::Triangle& triangle, const rt::Ray& ray,
                                            rt::Interval within) {
    return rt::hit_triangle(triangle, ray, within);
}

}  // namespace EXPORTED
