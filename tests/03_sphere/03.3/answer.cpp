// The test cases compare with the hit_sphere that the answer calls.
#include "03.2/answer.cpp"

#include <answer.hpp>
#include <rt/nearest_sphere.hpp>

namespace answer EXPORTED {

std::optional<rt::NearestSphere> nearest_sphere(std::span<const rt::SceneSphere> spheres,
                                                const rt::Ray& ray, rt::Interval within) {
    return rt::nearest_sphere(spheres, ray, within);
}

}  // namespace EXPORTED
