#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <rt/directions.hpp>
#include <rt/dot.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/scatter.hpp>

namespace rt {

// Fog that fills a ball evenly (given). It lies between the spheres: there is none inside of glass.
struct Fog {
    Sphere region;
    Real density = 0;       // how many droplets light meets on a unit of length, 0 or more
    Color albedo{1, 1, 1};  // the share of light that a droplet scatters, each channel in [0, 1]
    Real forwardness = 0;   // the mean cosine of the turn, in (-1, 1); 0 scatters evenly
};

// The share of light that gets through this much of a fog: exp(-density * length).
// Source: Bouguer, "Essai d'optique", 1729; known as Beer's law.
inline Real transmittance(Real density, Real length) {
    return std::exp(-density * length);
}

// How far light gets before it meets a droplet: longer than d with probability exp(-density * d).
// `number` lies in [0, 1).
inline Real free_flight(Real density, Real number) {
    return -std::log1p(-number) / density;
}

// The density, per solid angle, of a turn with this cosine between the directions before and after.
// Source: Henyey and Greenstein, "Diffuse radiation in the galaxy", 1941.
inline Real phase_density(Real forwardness, Real cosine) {
    const Real g = forwardness;
    // (1 - g)^2 + 2 g (1 - cosine): nothing cancels where g and the cosine are close to 1.
    const Real squared = (1 - g) * (1 - g) + 2 * g * (1 - cosine);
    return (1 - g) * (1 + g) / (4 * pi * squared * std::sqrt(squared));
}

// A direction that is drawn with that density.
inline Vec3 phase_direction(Real forwardness, Vec3 incoming, Vec2 place) {
    if (forwardness == 0) return uniform_direction(place);
    const Real g = forwardness;
    const Real root = (1 - g) * (1 + g) / (1 - g + 2 * g * place.x);
    const Real cosine = std::clamp((1 + g * g - root * root) / (2 * g), Real(-1), Real(1));
    const Real sine = std::sqrt((1 - cosine) * (1 + cosine)), angle = 2 * pi * place.y;
    return normalize(orthonormal_basis(incoming).to_world(
        {sine * std::cos(angle), sine * std::sin(angle), cosine}));
}

// The part of a ray that lies in a ball; empty where it misses it.
inline Interval within_ball(const Sphere& ball, Vec3 origin, Vec3 direction) {
    const Ray ray{origin, direction};
    const Vec3 apart = origin - ball.center;
    const Interval forward{0, infinity};
    if (length(apart) <= ball.radius) {
        const auto leaves = hit_sphere(ball, ray, forward);
        return {0, leaves.value_or(0)};
    }
    const auto enters = hit_sphere(ball, ray, forward);
    if (!enters) return {1, 0};
    // The second place is as far behind the point nearest to the center as the first is before it.
    const Real middle = -dot(apart, direction);
    return {*enters, std::max(*enters, 2 * middle - *enters)};
}

// A scene without fog: the compiler leaves out all that would ask it.
struct NoFog {
    template <class AnyRay, class Random>
    std::optional<Real> meets(const AnyRay&, Real, Random&) const {
        return {};
    }
    template <class Random>
    Scatter scatter(Vec3, Random&) const {
        return {};
    }
    Real density(Vec3, Vec3) const { return 0; }
    template <class AnyRay>
    Real gets_through(const AnyRay&, Real) const {
        return 1;
    }
};

// Fog as a medium for paths. Where its density is 0 nothing is drawn. Directions have length 1.
struct FogBall {
    Fog fog;

    // Where a ray meets a droplet before it has gone this far; none where it does not.
    template <class AnyRay, class Random>
    std::optional<Real> meets(const AnyRay& ray, Real most, Random& random) const {
        const Interval foggy = part_of(ray, most);
        if (foggy.is_empty()) return {};
        const Real t = foggy.min + free_flight(fog.density, random.uniform());
        if (!(t < foggy.max)) return {};
        return t;
    }

    // How a path goes on from a droplet.
    template <class Random>
    Scatter scatter(Vec3 incoming, Random& random) const {
        return {fog.albedo, phase_direction(fog.forwardness, incoming, random_place(random))};
    }
    Real density(Vec3 incoming, Vec3 outgoing) const {
        return phase_density(fog.forwardness, dot(incoming, outgoing));
    }

    // The share of light that gets this far along a ray.
    template <class AnyRay>
    Real gets_through(const AnyRay& ray, Real far) const {
        const Interval foggy = part_of(ray, far);
        return foggy.is_empty() ? 1 : transmittance(fog.density, foggy.size());
    }

  private:
    template <class AnyRay>
    Interval part_of(const AnyRay& ray, Real most) const {
        if (!(fog.density > 0)) return {1, 0};
        Interval inside = within_ball(fog.region, ray.origin, ray.direction);
        inside.max = std::min(inside.max, most);
        return inside;
    }
};

}  // namespace rt
