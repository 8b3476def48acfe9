// Measures three tests for a ray and a triangle: what each costs, how many rays slip through a
// closed mesh, and how far off t is.

#include <app/run.hpp>
#include <rt/color.hpp>
#include <rt/length.hpp>
#include <rt/rng.hpp>
#include <rt/triangle_shape.hpp>
#include <rt/vec3_of.hpp>
#include <study/double_double.hpp>
#include <study/pixel_error.hpp>
#include <study/report.hpp>
#include <study/ulp.hpp>

#include "triangle_ways.hpp"

namespace triangles {
namespace {

Vec3 in_cube(Rng& random) {
    const Real x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    return {x, y, z};
}

template <class Way>
std::vector<Way> made(const std::vector<SceneTriangle>& all) {
    std::vector<Way> ways;
    for (const SceneTriangle& triangle : all) ways.emplace_back(triangle.shape);
    return ways;
}

// Calls do_for(name, triangles) for each of the three ways, with all triangles made ready for that
// way.
template <class Each>
void for_each_way(const std::vector<SceneTriangle>& all, const Each& do_for) {
    do_for("plain", made<Plain>(all));
    do_for("watertight", made<Watertight>(all));
    do_for("planes made before", made<Planes>(all));
}

// Rays from inside a closed ball, toward points on its edges or in random directions.
std::vector<Ray> rays_inside(const std::vector<SceneTriangle>& ball, int count, bool to_edges) {
    Rng random{12, to_edges ? 2u : 3u};
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const Vec3 from = Real(0.4) * in_cube(random);
        const auto& [a, b, c] = ball[random() % ball.size()].shape;
        const Real along = random.uniform();
        const Vec3 aim = to_edges ? a + along * (b - a) : in_cube(random);
        rays.push_back({from, aim - from});
    }
    return rays;
}

template <class Way>
bool meets_any(const std::vector<Way>& ways, const Ray& ray) {
    for (const Way& way : ways)
        if (way.hit(ray, {})) return true;
    return false;
}

// How many of a million rays slip out of a closed mesh.
void study_leaks(study::Report& report) {
    constexpr int few = 200'000;
    for (const int belts : {4, 8, 16}) {
        const auto ball = triangles_of(closed_ball(belts), 0, 0);
        const auto rays = rays_inside(ball, few, true);
        for_each_way(ball, [&](const char* variant, const auto& ways) {
            int leaks = 0;
            for (const Ray& ray : rays) leaks += !meets_any(ways, ray);
            report.add({"leaks", variant, static_cast<double>(ball.size()), "triangles",
                        leaks * 1e6 / few, "leaks per million rays to an edge"});
        });
    }
}

void study_cost(study::Report& report) {
    const auto ball = triangles_of(closed_ball(8), 0, 0);
    const auto rays = rays_inside(ball, 2000, false);
    for_each_way(ball, [&](const char* variant, const auto& ways) {
        report.add(
            {"one triangle", variant, static_cast<double>(ball.size()), "triangles", 0, "", 0,
             "time per test / ns"},
            [ways, rays] {
                for (const Ray& ray : rays)
                    for (const auto& way : ways) study::keep(way.hit(ray, {}));
            },
            static_cast<double>(rays.size() * ball.size()));
    });
    report.time_in_turns();
}

// How far t is off for needles (long, thin triangles), in units in the last place of t.
void study_needles(study::Report& report) {
    using Exact = study::DoubleDouble;
    using ExactVec3 = Vec3Of<Exact>;
    const auto exact = [](Vec3 v) { return ExactVec3{Exact(v.x), Exact(v.y), Exact(v.z)}; };
    for (int power = 0; power <= 5; ++power) {
        const Real thin = rt::portable::pow(Real(10), static_cast<Real>(-power));
        std::array<double, 3> worst{};
        Rng random{12, 4};
        for (int i = 0; i < 20'000; ++i) {
            const Vec3 a = in_cube(random), b = in_cube(random), side = in_cube(random);
            const Triangle triangle{a, b, a + thin * side};
            const Vec3 normal = cross(b - a, side);
            if (dot(normal, normal) < Real(0.1)) continue;
            const Real u = random.uniform(), v = (1 - u) * random.uniform();
            const Vec3 aim = a + u * (b - a) + v * (triangle.c - a);
            const Vec3 from = aim + 3 * normalize(in_cube(random));
            if (std::abs(dot(normalize(normal), normalize(aim - from))) < Real(0.3)) continue;
            const Ray ray{from, normalize(aim - from)};
            const ExactVec3 n = cross(exact(triangle.b) - exact(a), exact(triangle.c) - exact(a));
            const Exact t = dot(exact(a) - exact(from), n) / dot(exact(ray.direction), n);
            const auto compare = [&](std::size_t way, const std::optional<Real>& found) {
                if (found) worst[way] = std::max(worst[way], study::error_in_ulp(*found, t));
            };
            compare(0, Plain{triangle}.hit(ray, {}));
            compare(1, Watertight{triangle}.hit(ray, {}));
            compare(2, Planes{triangle}.hit(ray, {}));
        }
        const char* const names[]{"plain", "watertight", "planes made before"};
        for (std::size_t k = 0; k < 3; ++k)
            report.add({"needles", names[k], std::pow(10.0, power), "length / width", worst[k],
                        "largest error of t / ulp"});
    }
}

// Colors seen from inside the closed ball: its triangles are gray, and white comes in through a
// leak. The truth is that no ray gets out.
void study_pixels(study::Report& report) {
    const auto ball = triangles_of(closed_ball(8), 0, 0);
    for (const bool to_edges : {false, true}) {
        const auto rays = rays_inside(ball, 100'000, to_edges);
        for_each_way(ball, [&](const char* variant, const auto& ways) {
            std::vector<Color> truth(rays.size(), Color{Real(0.5), Real(0.5), Real(0.5)}), seen;
            for (const Ray& ray : rays)
                seen.push_back(meets_any(ways, ray) ? truth.front() : Color{1, 1, 1});
            report.add(study::pixel_error(
                variant + std::string{to_edges ? ", rays to edges" : ", rays to anywhere"},
                to_edges, "rays to edges", study::root_mean_square_error(seen, truth)));
        });
    }
}

void run_study(study::Report& report) {
    study_leaks(report);
    study_needles(report);
    study_pixels(report);
    study_cost(report);
}

}  // namespace
}  // namespace triangles

void (*const app::program_study)(study::Report&) = triangles::run_study;
