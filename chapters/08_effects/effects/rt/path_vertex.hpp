#pragma once
#include <optional>
#include <rt/color.hpp>
#include <rt/fog.hpp>
#include <rt/fuzz_density.hpp>
#include <rt/interval.hpp>
#include <rt/leave_surface.hpp>
#include <rt/lights.hpp>
#include <rt/spread.hpp>
#include <rt/world.hpp>

namespace rt {

// The starting point of a ray that leaves a hit in a direction in which its material scatters
// (given). Materials that do not start there have a function of their own.
template <class Materials>
Vec3 leaving_point(const Materials&, const Hit& hit, Vec3 direction) {
    return leave_surface(hit, direction);
}

// A vertex of a path (given), where a ray ends: on a surface, at a droplet of fog, or nowhere, in
// the sky.
template <class Materials, class AnyMedium>
struct PathVertex {
    const Materials& materials;
    const AnyMedium& fog;
    std::optional<Hit> hit;
    std::optional<Real> collision;  // the t of a droplet that is met before the hit
    Vec3 point, incoming;           // the point, and the direction of the ray that led there

    bool is_sky() const { return !hit && !collision; }

    // The light that was met; null if none was.
    template <class Lights>
    const Light* light(const Lights& lights) const {
        return hit && !collision ? lights.find(*hit) : nullptr;
    }
    // How the path goes on from here; none if it is absorbed.
    template <class Random>
    std::optional<Scatter> scatter(Random& random) const {
        if (collision) return fog.scatter(incoming, random);
        return materials(incoming, *hit, random);
    }
    // The probability density, per solid angle, with which scatter() takes a direction; 0 for
    // mirrors and glass, for which light cannot be sampled, and for rough metal, where sampling
    // light pays only with weights.
    Real density(Vec3 direction) const {
        return collision ? fog.density(incoming, direction)
                         : scatter_density(materials, *hit, direction);
    }
    // Star: the same, but including the density of rough metal, except on meshes. This density has
    // no upper limit, so it may be used only with weights.
    Real shared_density(Vec3 direction) const {
        return collision ? fog.density(incoming, direction)
                         : scatter_density(materials, incoming, *hit, direction);
    }
    // The starting point of a ray that leaves in this direction.
    Vec3 origin(Vec3 direction) const {
        return collision ? point : leaving_point(materials, *hit, direction);
    }
};

// Follows a ray to its end. Within glass there is no fog.
template <class AnyRay, World<AnyRay> AnyWorld, class Materials, Medium<AnyRay> AnyMedium,
          class Random>
PathVertex<Materials, AnyMedium> next_vertex(const AnyRay& ray, const AnyWorld& world,
                                             const Materials& materials, const AnyMedium& fog,
                                             Random& random) {
    PathVertex<Materials, AnyMedium> vertex{materials, fog, world.hit(ray, Interval{0, infinity}),
                                            {},        {},  ray.direction};
    if (!(vertex.hit && came_through_glass(materials, *vertex.hit)))
        vertex.collision = fog.meets(ray, vertex.hit ? vertex.hit->t : infinity, random);
    if (vertex.collision)
        vertex.point = ray.origin + *vertex.collision * ray.direction;
    else if (vertex.hit)
        vertex.point = vertex.hit->point;
    return vertex;
}

}  // namespace rt
