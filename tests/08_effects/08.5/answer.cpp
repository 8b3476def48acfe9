#include <answer.hpp>
#include <rt/instance.hpp>

namespace answer EXPORTED {

rt::Ray object_ray(const rt::Instance& instance, const rt::Ray& ray) {
    return rt::object_ray(instance, ray);
}

std::optional<rt::Real> hit_instance(const rt::Instance& instance, const rt::Ray& ray,
                                     rt::Interval within) {
    return rt::hit_instance(instance, ray, within);
}

rt::Hit surface_hit(const rt::Instance& instance, const rt::Ray& ray, rt::Real t) {
    return rt::surface_hit(instance, ray, t);
}

rt::Box bounds_of(const rt::Instance& instance) {
    return rt::bounds_of(instance);
}

}  // namespace EXPORTED
