#pragma once
#pragma GCC system_header  // #include_next is no part of the standard
#define path_radiance path_radiance_unfollowed
#include_next <rt/path.hpp>
#undef path_radiance
#include <rt/follow_path.hpp>

namespace rt {

template <class AnyRay, class World, class Materials, class Sky, class Ending, class Random>
RT_NOT_INLINED Color path_radiance(AnyRay ray, const World& world, const Materials& materials,
                                   const Sky& sky, const Ending& ending, int depth,
                                   Random& random) {
    if (!follow::here.in_sample)
        return path_radiance_unfollowed(ray, world, materials, sky, ending, depth, random);
    const follow::Path path{depth};
    follow::Numbers<Random> numbers{random};
    const Color light = path_radiance_unfollowed(
        ray, follow::Scene<World>{world}, follow::Surfaces<Materials>{materials},
        follow::Far<Sky>{sky}, follow::Limit<Ending>{ending}, depth, numbers);
    random = numbers;
    follow::trail().step("light", "color", light);
    return light;
}

}  // namespace rt
