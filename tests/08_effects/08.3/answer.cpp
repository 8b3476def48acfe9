#include <answer.hpp>
#include <rt/sphere_light.hpp>

namespace answer EXPORTED {

rt::Real cone_height(rt::Real radius, rt::Real distance) {
    return rt::cone_height(radius, distance);
}

rt::Real light_density(const rt::Sphere& light, rt::Vec3 from) {
    return rt::light_density(light, from);
}

std::optional<rt::LightSample> sample_light(const rt::Sphere& light, rt::Vec3 from,
                                            rt::Vec2 place) {
    return rt::sample_light(light, from, place);
}

}  // namespace EXPORTED
