#pragma once
#include <optional>
#include <rt/compiler.hpp>
#include <rt/ending.hpp>
#include <rt/fog.hpp>
#include <rt/leave_surface.hpp>
#include <rt/lights.hpp>
#include <rt/spread.hpp>

namespace rt {

// A place where a path turns: on a surface, or at a droplet of fog (given).
template <class Materials, class Medium>
struct Turn {
    const Materials& materials;
    const Medium& fog;
    const Hit* hit;  // null at a droplet
    Vec3 point, incoming;

    // The density, per solid angle, with which the path takes a direction from here.
    Real density(Vec3 direction) const {
        return hit ? scatter_density(materials, *hit, direction) : fog.density(incoming, direction);
    }
    // Where a ray that leaves in this direction begins.
    Vec3 origin(Vec3 direction) const { return hit ? leave_surface(*hit, direction) : point; }
};

// Next-event estimation (given): the light that comes straight from one of the lights, chosen at
// random, and turns here towards the eye. Where the path goes on it may find the light by itself,
// so that the sample is weighed against that. `ray` brings all but the origin and the direction.
template <class AnyRay, class World, class Lights, class Materials, class Medium, class Random>
Color direct_light(AnyRay ray, const World& world, const Lights& lights,
                   const Turn<Materials, Medium>& turn, bool goes_on, Random& random) {
    const std::optional<ChosenLight> chosen = lights.choose(turn.point, random);
    if (!chosen) return {};
    const LightSample& sample = chosen->sample;
    const Real toward = turn.density(sample.direction);
    if (!(toward > 0)) return {};
    ray.origin = turn.origin(sample.direction);
    ray.direction = sample.direction;
    if (!sees_light(world, ray, *chosen)) return {};
    const Real weight = goes_on ? shared_weight(sample.density, toward) : Real(1);
    const Real share =
        toward / sample.density * weight * turn.fog.gets_through(ray, sample.distance);
    return share * chosen->radiance;
}

// The light that comes back along a ray in a scene with lights, with fog, or with both (given). It
// is path_radiance of chapter 04, and at each place where a path turns two things more:
//   fog     a droplet may turn the path before it reaches a surface
//   lights  a light is chosen and looked for; what the path finds by itself is weighed against it
// A black end of all paths is darker here than there: the last place's sample of a light is weighed
// against a bounce that is not followed any more. The end in the sky and roulette are right.
// With NoLights and NoFog, or with neither in the scene, it gives path_radiance's result bit for
// bit: no random number is drawn for what is not there.
template <class AnyRay, class World, class Materials, class Sky, class Lights, class Medium,
          class Ending, class Random>
RT_INLINES_ALL Color lit_path_radiance(AnyRay ray, const World& world, const Materials& materials,
                                       const Sky& sky, const Lights& lights, const Medium& fog,
                                       const Ending& ending, int depth, Random& random) {
    Color throughput{1, 1, 1}, light;
    // Where the ray comes from, and the density with which its direction was drawn. 0 where no
    // light was looked for: then what the path finds is all there is, and counts in full.
    Vec3 from;
    Real drawn = 0;
    for (int bounces = 1;; ++bounces) {
        const std::optional<Hit> hit = world.hit(ray, Interval{0, infinity});
        std::optional<Real> droplet;
        if (!(hit && came_through_glass(materials, *hit)))
            droplet = fog.meets(ray, hit ? hit->t : infinity, random);

        if (!droplet) {
            if (!hit) return light + throughput * sky(ray.direction);
            if (const SphereLight* const found = lights.find(*hit)) {
                const Real weight =
                    drawn > 0 ? shared_weight(drawn, lights.density(*found, from)) : Real(1);
                return light + throughput * (weight * found->radiance);
            }
        }

        const std::optional<Scatter> bounce =
            droplet ? fog.scatter(ray.direction, random) : materials(ray.direction, *hit, random);
        if (!bounce) return light;
        throughput *= bounce->attenuation;
        const Color arriving = throughput;  // the share of light from here that reaches the eye
        const Fate fate = bounces < depth ? Fate::goes_on : ending(throughput, random);

        from = droplet ? ray.origin + *droplet * ray.direction : hit->point;
        const Turn<Materials, Medium> turn{materials, fog, droplet ? nullptr : &*hit, from,
                                           ray.direction};
        if (!lights.empty()) {
            drawn = turn.density(bounce->direction);
            if (drawn > 0)
                light += arriving *
                         direct_light(ray, world, lights, turn, fate != Fate::ends_in_sky, random);
        }
        if (fate == Fate::ends_in_black) return light;
        ray.origin = turn.origin(bounce->direction);
        ray.direction = bounce->direction;
        if (fate == Fate::ends_in_sky) return light + throughput * sky(ray.direction);
    }
}

}  // namespace rt
