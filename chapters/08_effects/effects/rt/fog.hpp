#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
#include <rt/directions.hpp>
#include <rt/dot.hpp>
#include <rt/interval.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/portable.hpp>
#include <rt/ray.hpp>
#include <rt/rng.hpp>
#include <rt/scatter.hpp>
#include <rt/sine_cosine.hpp>
#include <rt/sphere.hpp>
#include <rt/transmittance.hpp>

namespace rt {

// Fog that fills a ball evenly (given). It lies between the spheres, not in glass: a path that
// meets glass from within has met no fog on its way there.
struct Fog {
    Sphere region;
    Real density = 0;       // how many droplets light meets per unit of length, 0 or more
    Color albedo{1, 1, 1};  // the share of light that a droplet scatters; each channel in [0, 1]
    // The asymmetry parameter g: the mean cosine of the angle by which light turns, in (-1, 1). 0
    // scatters light evenly.
    Real asymmetry = 0;
};

// How far light gets before it meets a droplet: farther than d with probability exp(-density * d).
// `number` is random, in [0, 1).
inline Real free_flight(Real density, Real number) {
    return -portable::log1p(-number) / density;
}

// The probability density, per solid angle, of a turn with this cosine between the directions
// before and after.
// Source: Henyey and Greenstein, "Diffuse radiation in the galaxy", 1941.
inline Real phase_density(Real asymmetry, Real cosine) {
    // Negative g favors the way back: the density is that of -g with the sign of the cosine
    // changed. Rounding may put a computed cosine a little above 1.
    const Real g = std::abs(asymmetry);
    const Real away = std::max(Real(0), 1 - (asymmetry < 0 ? -cosine : cosine));
    // (1 - g)^2 + 2 g (1 - cosine): nothing cancels if g and the cosine are close to 1.
    const Real squared = (1 - g) * (1 - g) + 2 * g * away;
    return (1 - g) * (1 + g) / (4 * pi * squared * std::sqrt(squared));
}

// A direction drawn with that density.
inline Vec3 phase_direction(Real asymmetry, Vec3 incoming, Vec2 place) {
    const Real g = asymmetry;
    // The usual formula with this d, cosine = (1 + g^2 - ((1 - g^2) / d)^2) / 2g, cancels for small
    // g. The product below, which is 1 - cosine, does not. For g = 0 it is 2 (1 - x), which spreads
    // directions evenly.
    const Real d = 1 - g + 2 * g * place.x;
    const Real height = (1 - g) * (1 - place.x) / d * ((1 - g) * (1 + g) / d + 1 - g);
    const Real sine = std::sqrt(std::max(Real(0), height * (2 - height)));
    const auto turn = sine_cosine_of_turn(place.y);
    return normalize(
        orthonormal_basis(incoming).to_world({sine * turn.cosine, sine * turn.sine, 1 - height}));
}

// The part of a ray, from its origin on, that lies in a ball; empty if the ray misses it. The
// direction has length 1.
inline Interval within_ball(const Sphere& ball, Vec3 origin, Vec3 direction) {
    const Vec3 f = origin - ball.center;
    const Vec3 moment{f.y * direction.z - f.z * direction.y, f.z * direction.x - f.x * direction.z,
                      f.x * direction.y - f.y * direction.x};
    // Half of the chord, as in 03.2, and its middle. The code does not ask whether the ray starts
    // inside: on the surface itself that question has no safe answer.
    const Real squared = ball.radius * ball.radius - dot(moment, moment);
    if (!(squared > 0)) return {1, 0};
    const Real half = std::sqrt(squared), middle = -dot(f, direction);
    return {std::max(Real(0), middle - half), middle + half};
}

// What lies between the surfaces (given): air, or air with droplets. Directions have length 1.
template <class Type, class AnyRay = Ray, class Random = Rng>
concept Medium = requires(const Type& medium, const AnyRay& ray, Real far, Vec3 direction,
                          Random& random) {
    // The t at which the ray meets a droplet, if that is before `far`; none otherwise.
    { medium.meets(ray, far, random) } -> std::same_as<std::optional<Real>>;
    // How a path that comes in this direction goes on from a droplet.
    { medium.scatter(direction, random) } -> std::same_as<Scatter>;
    // The probability density, per solid angle, with which scatter() takes the second direction.
    { medium.density(direction, direction) } -> std::same_as<Real>;
    // The share of light that gets as far as `far` along the ray.
    { medium.gets_through(ray, far) } -> std::same_as<Real>;
};

// Stands for a scene without fog: the compiler removes every call to its functions.
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

// Fog as a Medium. If the density is 0, no random numbers are drawn.
struct FogBall {
    Fog fog;

    template <class AnyRay, class Random>
    std::optional<Real> meets(const AnyRay& ray, Real most, Random& random) const {
        const Interval foggy = part_of(ray, most);
        if (foggy.is_empty()) return {};
        const Real t = foggy.min + free_flight(fog.density, random.uniform());
        if (!(t < foggy.max)) return {};
        return t;
    }

    template <class Random>
    Scatter scatter(Vec3 incoming, Random& random) const {
        return {fog.albedo, phase_direction(fog.asymmetry, incoming, random_place(random))};
    }
    Real density(Vec3 incoming, Vec3 outgoing) const {
        return phase_density(fog.asymmetry, dot(incoming, outgoing));
    }

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
