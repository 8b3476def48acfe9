#pragma once
#pragma GCC system_header  // #include_next is no part of the standard
#define lit_path_radiance lit_path_radiance_unfollowed
#include_next <rt/lit_path.hpp>
#undef lit_path_radiance
#include <rt/follow_path.hpp>

namespace rt {
namespace follow {

// The world of a ray to a lamp.
template <class World>
struct ToLamp {
    const World& world;

    template <class AnyRay>
    RT_NOT_INLINED std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        const std::optional<Hit> found = world.hit(ray, within);
        note(ray, within, "meets", found ? found->t : infinity);
        return found;
    }
    template <class AnyRay>
    RT_NOT_INLINED bool occluded(const AnyRay& ray, Interval within,
                                 int number) const requires requires {
        world.occluded(ray, within, number);
    }
    {
        const bool is_blocked = world.occluded(ray, within, number);
        note(ray, within, "blocked", is_blocked);
        return is_blocked;
    }

    template <class AnyRay, class Value>
    static void note(const AnyRay& ray, Interval within, const char* what, Value value) {
        trail().step("shadow", "origin", ray.origin, "direction", ray.direction, "distance",
                     within.max, what, value);
    }
};

// The learner's direct_light, which is less specialized, with that world.
template <class AnyRay, class World, class Lights, class Materials, class Medium, class Random>
RT_NOT_INLINED Color direct_light(AnyRay ray, const Scene<World>& scene, const Lights& lights,
                                  const PathVertex<Materials, Medium>& vertex, bool goes_on,
                                  Random& random) {
    random.drawn.clear();
    const Color light =
        direct_light(ray, ToLamp<World>{scene.world}, lights, vertex, goes_on, random);
    note_numbers(random);
    trail().step("lamp", "color", light);
    return light;
}

template <class Materials>
Real scatter_density(const Surfaces<Materials>& surfaces, const Hit& hit, Vec3 direction) {
    return scatter_density(surfaces.set, hit, direction);
}
template <class Materials>
Real scatter_density(const Surfaces<Materials>& surfaces, Vec3 incoming, const Hit& hit,
                     Vec3 direction) {
    return scatter_density(surfaces.set, incoming, hit, direction);
}
template <class Materials>
bool came_through_glass(const Surfaces<Materials>& surfaces, const Hit& hit) {
    return came_through_glass(surfaces.set, hit);
}

template <class Medium>
struct Droplets {
    const Medium& medium;

    template <class AnyRay, class Random>
    RT_NOT_INLINED std::optional<Real> meets(const AnyRay& ray, Real far, Random& random) const {
        random.drawn.clear();
        const std::optional<Real> t = medium.meets(ray, far, random);
        note_numbers(random);
        if (t) trail().step("fog", "t", *t, "point", ray.origin + *t * ray.direction);
        return t;
    }
    template <class Random>
    RT_NOT_INLINED Scatter scatter(Vec3 incoming, Random& random) const {
        random.drawn.clear();
        const Scatter bounce = medium.scatter(incoming, random);
        note_numbers(random);
        trail().step("scatter", "direction", bounce.direction, "attenuation", bounce.attenuation);
        return bounce;
    }
    Real density(Vec3 incoming, Vec3 outgoing) const { return medium.density(incoming, outgoing); }
    template <class AnyRay>
    Real gets_through(const AnyRay& ray, Real far) const {
        return medium.gets_through(ray, far);
    }
};

}  // namespace follow

template <class AnyRay, class World, class Materials, class Sky, class Lights, class Medium,
          class Ending, class Random>
RT_NOT_INLINED Color lit_path_radiance(AnyRay ray, const World& world, const Materials& materials,
                                       const Sky& sky, const Lights& lights, const Medium& fog,
                                       const Ending& ending, int depth, Random& random) {
    if (!follow::here.in_sample)
        return lit_path_radiance_unfollowed(ray, world, materials, sky, lights, fog, ending, depth,
                                            random);
    const follow::Path path{depth};
    follow::Numbers<Random> numbers{random};
    const Color light = lit_path_radiance_unfollowed(
        ray, follow::Scene<World>{world}, follow::Surfaces<Materials>{materials},
        follow::Far<Sky>{sky}, lights, follow::Droplets<Medium>{fog}, follow::Limit<Ending>{ending},
        depth, numbers);
    random = numbers;
    follow::trail().step("light", "color", light);
    return light;
}

}  // namespace rt
