#pragma once
#include <optional>
#include <rt/ending.hpp>
#include <rt/fog.hpp>
#include <rt/leave_surface.hpp>
#include <rt/lights.hpp>
#include <rt/spread.hpp>

namespace rt {

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
Color lit_path_radiance(AnyRay ray, const World& world, const Materials& materials, const Sky& sky,
                        const Lights& lights, const Medium& fog, const Ending& ending, int depth,
                        Random& random) {
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

        std::optional<Scatter> bounce;
        if (droplet) {
            bounce = fog.scatter(ray.direction, random);
        } else {
            if (!hit) return light + throughput * sky(ray.direction);
            if (const SphereLight* const found = lights.find(*hit)) {
                const Real weight =
                    drawn > 0 ? shared_weight(drawn, lights.density(*found, from)) : Real(1);
                return light + throughput * (weight * found->radiance);
            }
            bounce = materials(ray.direction, *hit, random);
            if (!bounce) return light;
        }
        throughput *= bounce->attenuation;
        const Color arriving = throughput;  // the share of light from here that reaches the eye
        const Fate fate = bounces < depth ? Fate::goes_on : ending(throughput, random);

        const Vec3 incoming = ray.direction;
        from = droplet ? ray.origin + *droplet * incoming : hit->point;
        const auto leave = [&](Vec3 direction) {
            ray.origin = droplet ? from : leave_surface(*hit, direction);
            ray.direction = direction;
        };
        if (!lights.empty()) {
            const auto density = [&](Vec3 direction) {
                return droplet ? fog.density(incoming, direction)
                               : scatter_density(materials, *hit, direction);
            };
            drawn = density(bounce->direction);
            const auto chosen = drawn > 0 ? lights.choose(from, random) : std::nullopt;
            const Real toward = chosen ? density(chosen->sample.direction) : Real(0);
            if (toward > 0) {
                leave(chosen->sample.direction);
                if (sees_light(world, ray, *chosen)) {
                    // A path that ends here will not find the light: the sample counts in full.
                    const Real weight = fate == Fate::ends_in_sky
                                            ? Real(1)
                                            : shared_weight(chosen->sample.density, toward);
                    const Real share = toward / chosen->sample.density * weight *
                                       fog.gets_through(ray, chosen->sample.distance);
                    light += arriving * (share * chosen->radiance);
                }
            }
        }
        if (fate == Fate::ends_in_black) return light;
        leave(bounce->direction);
        if (fate == Fate::ends_in_sky) return light + throughput * sky(ray.direction);
    }
}

}  // namespace rt
