#pragma once
// What it costs to know where a far sphere is hit, and whether it is hit at all.

#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/rng.hpp>
#include <study/double_double.hpp>
#include <study/report.hpp>
#include <vector>

#include "variants.hpp"

namespace spheres {

using rt::Ray, rt::Real, rt::Sphere, rt::Vec3;
using study::DoubleDouble;

// Rays at the unit sphere from one distance, and what is true of them: the nearest t, or -1.
struct Case {
    Ray ray;
    DoubleDouble t;
};

// The nearest hit of the unit sphere around (0, 0, 0), by numbers of 106 bits.
inline DoubleDouble exact_hit(const Ray& ray) {
    using D = DoubleDouble;
    const auto [fx, fy, fz] = ray.origin;
    const auto [dx, dy, dz] = ray.direction;
    const D a = D(dx) * D(dx) + D(dy) * D(dy) + D(dz) * D(dz);
    const D b = D(fx) * D(dx) + D(fy) * D(dy) + D(fz) * D(dz);
    const D x = D(fy) * D(dz) - D(fz) * D(dy), y = D(fz) * D(dx) - D(fx) * D(dz),
            z = D(fx) * D(dy) - D(fy) * D(dx);
    const D quarter = a - (x * x + y * y + z * z);
    return quarter < D(0) ? D(-1) : (-b - sqrt(quarter)) / a;
}

// From random sides, at random points of a disk of 1.4 radii: half of the rays hit.
inline std::vector<Case> cases_from(Real distance) {
    rt::Rng rng{11, 3};
    std::vector<Case> cases(2000);
    for (Case& c : cases) {
        const Vec3 side =
            rt::normalize({rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(Real(0.1), 1)});
        const rt::Basis disk = rt::orthonormal_basis(side);
        const Real away = Real(1.4) * std::sqrt(rng.uniform()), turn = rng.uniform(0, 2 * rt::pi);
        const Vec3 target = disk.to_world({away * std::cos(turn), away * std::sin(turn), 0});
        const Vec3 origin = (1 + distance) * side;
        c.ray = {origin, rt::normalize(target - origin)};
        c.t = exact_hit(c.ray);
    }
    return cases;
}

struct Quality {
    double largest_error = 0;  // of t relative to the true t, among the rays that rightly hit
    double wrong_share = 0;    // of all rays: hit for a miss, or a miss for a hit
};

inline Quality judge(const std::vector<Case>& cases, variants::HitFunction hit) {
    Quality quality;
    for (const Case& c : cases) {
        const bool hits = DoubleDouble(0) < c.t;
        const auto t = hit({}, c.ray, {0, rt::infinity});
        if (t.has_value() != hits)
            quality.wrong_share += 1 / static_cast<double>(cases.size());
        else if (hits)
            quality.largest_error =
                std::max(quality.largest_error, std::abs(((DoubleDouble(*t) - c.t) / c.t).high));
    }
    return quality;
}

// The time of one ray, each function compiled into its own loop as in a renderer.
template <class Hit>
double time_per_ray(const std::vector<Case>& cases, Hit hit) {
    const double time = study::time_ns([&] {
        Real sum = 0;
        for (const Case& c : cases) sum += hit({}, c.ray, {0, rt::infinity}).value_or(0);
        study::keep(sum);
    });
    return time / static_cast<double>(cases.size());
}

template <class Hit>
void measure(study::Report& report, const std::string& study, const std::string& variant, Hit hit,
             double Quality::*error, const std::string& error_name) {
    for (int exponent = 0; exponent <= 8; ++exponent) {
        const Real distance = std::pow(Real(10), static_cast<Real>(exponent));
        const auto cases = cases_from(distance);
        report.add({study, variant, static_cast<double>(distance), "distance / radius",
                    judge(cases, +hit).*error, error_name, time_per_ray(cases, hit), "ns per ray"});
    }
}

inline void run_study(study::Report& report) {
    const auto measure_all = [&](const std::string& study, double Quality::*error,
                                 const std::string& error_name) {
        // Lambdas, because a loop over a function pointer would time the calls instead.
        const auto with = [&](const std::string& variant, auto hit) {
            measure(report, study, variant, hit, error, error_name);
        };
        using S = const Sphere&;
        using R = const Ray&;
        using I = rt::Interval;
        with("textbook", [](S s, R r, I i) { return variants::textbook(s, r, i); });
        with("stable roots only", [](S s, R r, I i) { return variants::stable_roots(s, r, i); });
        with("nearest point", [](S s, R r, I i) { return variants::nearest_point(s, r, i); });
        with("cross product (ours)", [](S s, R r, I i) { return rt::hit_sphere(s, r, i); });
        with("cross product by fma", [](S s, R r, I i) { return variants::exact_cross(s, r, i); });
    };
    measure_all("Far spheres", &Quality::largest_error, "largest relative error of t");
    measure_all("Hit or miss", &Quality::wrong_share, "share of wrong answers");
}

}  // namespace spheres
