#include <answer.hpp>
#include <rt/hit_sphere.hpp>

namespace answer EXPORTED {

std::optional<rt::Real> hit_sphere(const rt::Sphere& sphere, const rt::Ray& ray,
                                   rt::Interval within) {
    return rt::hit_sphere(sphere, ray, within);
}

}  // namespace EXPORTED
