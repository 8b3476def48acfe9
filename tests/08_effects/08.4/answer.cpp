#include <answer.hpp>
#include <rt/lit_path.hpp>

#include "types.hpp"

namespace answer EXPORTED {

rt::Color direct_light(const rt::TimedRay& ray, const World<rt::TimedRay>& world,
                       const Lights& lights,
                       const rt::PathVertex<Materials, Medium<rt::TimedRay>>& vertex, bool goes_on,
                       rt::Rng& random) {
    return rt::direct_light(ray, world, lights, vertex, goes_on, random);
}

rt::Color lit_path_radiance(const rt::Ray& ray, const World<rt::Ray>& world,
                            const Materials& materials, const Sky& sky, const Lights& lights,
                            const Medium<rt::Ray>& fog, const Ending& ending, int depth,
                            rt::Rng& random) {
    return rt::lit_path_radiance(ray, world, materials, sky, lights, fog, ending, depth, random);
}

}  // namespace EXPORTED
