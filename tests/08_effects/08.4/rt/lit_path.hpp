#pragma once
#include <optional>
#include <rt/ending.hpp>
#include <rt/path_vertex.hpp>

#include "../types.hpp"

namespace answer {

rt::Color direct_light(const rt::TimedRay& ray, const World<rt::TimedRay>& world,
                       const Lights& lights,
                       const rt::PathVertex<Materials, Medium<rt::TimedRay>>& vertex, bool goes_on,
                       rt::Rng& random);
rt::Color lit_path_radiance(const rt::Ray& ray, const World<rt::Ray>& world,
                            const Materials& materials, const Sky& sky, const Lights& lights,
                            const Medium<rt::Ray>& fog, const Ending& ending, int depth,
                            rt::Rng& random);

// A test case's types as these types.
template <class AnyRay, class Given>
World<AnyRay> as_world(const Given& world) {
    return {[&](const AnyRay& ray, rt::Interval within) { return world.hit(ray, within); }};
}
template <class Given>
Materials as_materials(const Given& set) {
    return {[&](rt::Vec3 incoming, const rt::Hit& hit, rt::Rng& random) {
                return set(incoming, hit, random);
            },
            [&](const rt::Hit& hit, rt::Vec3 out) { return scatter_density(set, hit, out); },
            [&](rt::Vec3 in, const rt::Hit& hit, rt::Vec3 out) {
                return scatter_density(set, in, hit, out);
            },
            [&](const rt::Hit& hit) { return came_through_glass(set, hit); }};
}
template <class Given>
Lights as_lights(const Given& lights) {
    return {[&] { return lights.empty(); }, [&](const rt::Hit& hit) { return lights.find(hit); },
            [&](const rt::Light& light, rt::Vec3 from) { return lights.density(light, from); },
            [&](rt::Vec3 from, rt::Rng& random) { return lights.choose(from, random); }};
}
template <class AnyRay, class Given>
Medium<AnyRay> as_medium(const Given& fog) {
    return {[&](const AnyRay& ray, rt::Real most, rt::Rng& random) {
                return fog.meets(ray, most, random);
            },
            [&](rt::Vec3 incoming, rt::Rng& random) { return fog.scatter(incoming, random); },
            [&](rt::Vec3 incoming, rt::Vec3 out) { return fog.density(incoming, out); },
            [&](const AnyRay& ray, rt::Real far) { return fog.gets_through(ray, far); }};
}

}  // namespace answer

namespace rt {

template <class AnyRay, class World, class Lights, class Materials, class Medium>
Color direct_light(const AnyRay& ray, const World& world, const Lights& lights,
                   const PathVertex<Materials, Medium>& vertex, bool goes_on, Rng& random) {
    const answer::Materials materials = answer::as_materials(vertex.materials);
    const auto fog = answer::as_medium<AnyRay>(vertex.fog);
    return answer::direct_light(
        ray, answer::as_world<AnyRay>(world), answer::as_lights(lights),
        {materials, fog, vertex.hit, vertex.collision, vertex.point, vertex.incoming}, goes_on,
        random);
}

template <class AnyRay, class World, class Materials, class Sky, class Lights, class Medium,
          class Ending>
Color lit_path_radiance(const AnyRay& ray, const World& world, const Materials& materials,
                        const Sky& sky, const Lights& lights, const Medium& fog,
                        const Ending& ending, int depth, Rng& random) {
    return answer::lit_path_radiance(
        ray, answer::as_world<AnyRay>(world), answer::as_materials(materials), std::ref(sky),
        answer::as_lights(lights), answer::as_medium<AnyRay>(fog), std::ref(ending), depth, random);
}

}  // namespace rt
