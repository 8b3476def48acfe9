// What it costs to know where a far sphere is hit, and whether it is hit at all.

#include <app/run.hpp>
#include <rt/compiler.hpp>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/rng.hpp>
#include <study/double_double.hpp>
#include <study/pixel_error.hpp>
#include <study/report.hpp>
#include <study/timing.hpp>
#include <vector>

#include "far_spheres.hpp"
#include "variants.hpp"

namespace spheres {
namespace {

using rt::Ray, rt::Real, rt::Sphere, rt::Vec3;
using study::DoubleDouble;

// A ray toward the unit sphere around (0, 0, 0), and the true answers.
struct Case {
    Ray ray;
    DoubleDouble t = -1;   // the nearest hit; -1 for a miss
    double condition = 0;  // (|f| + r) (1 + p / h) / |d|: about how much t changes per radian
};

// The true answers, computed with numbers of 106 bits.
Case exact_case(const Ray& ray) {
    const auto exact = [](Real x) { return DoubleDouble(static_cast<double>(x)); };
    const auto fx = exact(ray.origin.x), fy = exact(ray.origin.y), fz = exact(ray.origin.z);
    const auto dx = exact(ray.direction.x), dy = exact(ray.direction.y),
               dz = exact(ray.direction.z);
    const auto a = dx * dx + dy * dy + dz * dz, b = fx * dx + fy * dy + fz * dz;
    const auto x = fy * dz - fz * dy, y = fz * dx - fx * dz, z = fx * dy - fy * dx;
    const auto moment = x * x + y * y + z * z, quarter = a - moment;
    if (quarter < DoubleDouble(0)) return {ray};
    const double f = std::sqrt((fx * fx + fy * fy + fz * fz).high);
    return {ray, (-b - sqrt(quarter)) / a,
            (f + 1) * (1 + std::sqrt(moment.high / quarter.high)) / std::sqrt(a.high)};
}

// Rays that come from random directions and aim at random points of a ring around the center. If
// the ring is a disk with a radius of 1.4, half of the rays hit.
std::vector<Case> cases_from(Real distance, Real inner = 0, Real outer = Real(1.4)) {
    rt::Rng rng{11, 3};
    std::vector<Case> cases(2000);
    for (Case& c : cases) {
        const Vec3 side =
            rt::normalize({rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(Real(0.1), 1)});
        const rt::Basis disk = rt::orthonormal_basis(side);
        const Real away = std::sqrt(rng.uniform(inner * inner, outer * outer)),
                   turn = rng.uniform(0, 2 * rt::pi);
        const Vec3 target = disk.to_world({away * std::cos(turn), away * std::sin(turn), 0});
        const Vec3 origin = (1 + distance) * side;
        c = exact_case({origin, rt::normalize(target - origin)});
    }
    return cases;
}

struct Quality {
    double largest_error = 0;  // of t, relative to the true t, among the rays that rightly hit
    double of_condition = 0;   // the largest error of t / (epsilon * condition)
    double wrong_share = 0;    // of all rays: a hit taken for a miss, or a miss for a hit
};

Quality judge(const std::vector<Case>& cases, variants::HitFunction hit) {
    Quality quality;
    for (const Case& c : cases) {
        const bool hits = DoubleDouble(0) < c.t;
        const auto t = hit({}, c.ray, {0, rt::infinity});
        if (t.has_value() != hits) quality.wrong_share += 1 / static_cast<double>(cases.size());
        if (!t || !hits) continue;
        const double error = std::abs((DoubleDouble(static_cast<double>(*t)) - c.t).high);
        quality.largest_error = std::max(quality.largest_error, error / c.t.high);
        quality.of_condition = std::max(quality.of_condition,
                                        error / (static_cast<double>(rt::epsilon) * c.condition));
    }
    return quality;
}

// Each function is compiled into its own loop, as in a renderer.
template <class Hit>
RT_INLINES_ALL void hit_each(const std::vector<Ray>& rays, Hit hit) {
    Real sum = 0;
    for (const Ray& ray : rays) sum += hit({}, ray, {0, rt::infinity}).value_or(0);
    study::keep(sum);
}

// The work to be timed.
template <class Hit>
study::Work hit_all(const std::vector<Case>& cases, Hit hit) {
    std::vector<Ray> rays;
    for (const Case& c : cases) rays.push_back(c.ray);
    return [rays, hit] { hit_each(rays, hit); };
}

// Calls measure(name, way) for every way to intersect a sphere. The ways are lambdas, which the
// compiler can inline. With function pointers, the calls would be timed, too.
template <class Measure>
void with_each_variant(Measure measure) {
    using S = const Sphere&;
    using R = const Ray&;
    using I = rt::Interval;
    measure("textbook", [](S s, R r, I i) { return variants::textbook(s, r, i); });
    measure("stable roots only", [](S s, R r, I i) { return variants::stable_roots(s, r, i); });
    measure("nearest point", [](S s, R r, I i) { return variants::nearest_point(s, r, i); });
    measure("cross product (ours)", [](S s, R r, I i) { return rt::hit_sphere(s, r, i); });
    measure("cross product by fma", [](S s, R r, I i) { return variants::exact_cross(s, r, i); });
}

// The error that a formula makes in the chapter's small picture of a sphere at this distance.
double error_in_a_pixel(Real distance, variants::HitFunction hit) {
    const far_spheres::FarSphere far{distance, 64, 64};
    std::vector<rt::Color> pixels, truth;
    for (int y = 0; y < far.camera.height; ++y)
        for (int x = 0; x < far.camera.width; ++x) {
            const Ray ray = far.ray(x, y);
            pixels.push_back(far.color(ray, hit(far.sphere, ray, {0, rt::infinity})));
            const DoubleDouble t = exact_case({-far.sphere.center, ray.direction}).t;
            truth.push_back(far.color(ray, DoubleDouble(0) < t
                                               ? std::optional{static_cast<Real>(t.high)}
                                               : std::nullopt));
        }
    return study::root_mean_square_error(pixels, truth);
}

void run_study(study::Report& report) {
    const auto far = [&](const char* study, double Quality::*error, const char* error_name) {
        with_each_variant([&](const char* variant, auto hit) {
            for (int exponent = 0; exponent <= 8; ++exponent) {
                const Real distance = std::pow(Real(10), static_cast<Real>(exponent));
                const auto cases = cases_from(distance);
                report.add({.study = study,
                            .variant = variant,
                            .x = static_cast<double>(distance),
                            .x_name = "distance / radius",
                            .error = judge(cases, hit).*error,
                            .error_name = error_name,
                            .cost_name = "time / ns"},
                           hit_all(cases, hit), static_cast<double>(cases.size()));
            }
        });
        report.time_in_turns();
    };
    far("Far spheres", &Quality::largest_error, "largest relative error of t");
    far("Bound of the error", &Quality::of_condition, "error / (eps condition)");
    far("Hit or miss", &Quality::wrong_share, "share of wrong answers");

    with_each_variant([&](const char* variant, auto hit) {
        const auto row = [&](double share, Real inner, Real outer) {
            const auto cases = cases_from(10, inner, outer);
            report.add({.study = "Price of a miss",
                        .variant = variant,
                        .x = share,
                        .x_name = "share of rays that hit",
                        .error = judge(cases, hit).wrong_share,
                        .error_name = "share of wrong answers",
                        .cost_name = "time / ns"},
                       hit_all(cases, hit), static_cast<double>(cases.size()));
        };
        row(0, Real(1.1), 10);
        row(0.5, 0, Real(1.4));
        row(1, 0, Real(0.95));
    });
    report.time_in_turns();

    const auto add_pixel_error = [&](const std::string& variant, Real distance,
                                     variants::HitFunction hit) {
        report.add(study::pixel_error(variant, static_cast<double>(distance), "distance / radius",
                                      error_in_a_pixel(distance, hit)));
    };
    add_pixel_error("textbook, 1000 radii away", Real(1e3), variants::textbook);
    add_pixel_error("ours, 1000 radii away", Real(1e3), rt::hit_sphere);
    add_pixel_error("textbook, 10^7 radii away", Real(1e7), variants::textbook);
    add_pixel_error("ours, 10^7 radii away", Real(1e7), rt::hit_sphere);
}

}  // namespace
}  // namespace spheres

void (*const app::program_study)(study::Report&) = spheres::run_study;
