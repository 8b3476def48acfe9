// This file is compiled with Real = float and with another name for the namespace rt: see
// 03.float.cpp.
#include "04.float.hpp"

#include <cmath>
#include <rt/hit_sphere.hpp>
#include <rt/leave_surface.hpp>
#include <rt/surface_hit.hpp>

static_assert(sizeof(rt::Real) == sizeof(float));

namespace live {
namespace {

rt::Real real(double x) {
    return static_cast<rt::Real>(x);
}

// How far a point is above the surface: in double, which is exact enough for numbers of float.
double height_above(const rt::Sphere& sphere, rt::Vec3 p) {
    const auto from = [](rt::Real a, rt::Real b) {
        return static_cast<double>(a) - static_cast<double>(b);
    };
    return std::hypot(from(p.x, sphere.center.x), from(p.y, sphere.center.y),
                      from(p.z, sphere.center.z)) -
           static_cast<double>(sphere.radius);
}

}  // namespace

Departure depart_in_float(double radius, double far, double place, double angle, int way) {
    const rt::Sphere sphere{{real(0.48 * far), real(0.6 * far), real(-0.64 * far)}, real(radius)};
    // From an eye three radii above the surface.
    const rt::Vec3 toward_eye{real(0.36), real(0.48), real(0.8)}, right{real(0.8), real(-0.6), 0},
        eye = sphere.center + 4 * sphere.radius * toward_eye;
    const rt::Vec3 aim = sphere.center + sphere.radius * (real(std::cos(place)) * toward_eye +
                                                          real(std::sin(place)) * right);
    const rt::Ray seen{eye, aim - eye};
    const auto t = rt::hit_sphere(sphere, seen, {0, rt::infinity});
    if (!t) return {};
    const rt::Hit hit = rt::surface_hit(sphere, seen, *t);

    const rt::Vec3 across = rt::normalize(right - rt::dot(right, hit.normal) * hit.normal);
    const rt::Vec3 direction = real(std::cos(angle)) * hit.normal + real(std::sin(angle)) * across;
    Departure departure{height_above(sphere, hit.point), hit.point_error, 0, false};
    rt::Vec3 start = hit.point;
    if (way == 1) {
        const rt::Real plain = rt::rounding_bound(16) * (rt::length(hit.point) + sphere.radius);
        departure.error = plain;
        start =
            hit.point + 2 * plain * (rt::dot(direction, hit.normal) < 0 ? -hit.normal : hit.normal);
    } else if (way == 2) {
        start = rt::leave_surface(hit, direction);
    }
    departure.start = height_above(sphere, start);

    const auto next = rt::hit_sphere(sphere, {start, direction}, {0, rt::infinity});
    const rt::Real inward = -rt::dot(direction, hit.normal);
    departure.is_right = inward > 0 ? next && *next > inward * sphere.radius : !next;
    return departure;
}

}  // namespace live
