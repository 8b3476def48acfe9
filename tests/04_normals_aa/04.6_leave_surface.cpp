#include <rt/image.hpp>
#include <rt/lambertian.hpp>
#include <rt/leave_surface.hpp>
#include <rt/make_camera.hpp>
#include <rt/path.hpp>
#include <rt/render_pixel.hpp>
#include <rt/rng.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>

#include "checkpoint.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Color, rt::Hit, rt::Ray, rt::Sphere;

namespace {

// A place on a sphere of radius 10^-9 to 10^9, up to 10^6 radii from the scene's origin, as a ray
// finds it from outside or from inside.
struct Place {
    Sphere sphere;
    Hit hit;
};

Place any_place(rt::Rng& rng) {
    for (;;) {
        const Real radius = any_size(rng, -9, 9);
        const Sphere sphere{radius * any_size(rng, -2, 6) * any_direction(rng), radius};
        const bool from_inside = rng() & 1;
        const Vec3 start = radius * (from_inside ? real(0.5) : Real(3)) * any_direction(rng);
        const Vec3 aim = real(0.9) * radius * any_direction(rng);
        const Ray ray{sphere.center + start, (aim - start) / radius};
        if (const auto t = rt::hit_sphere(sphere, ray, {}))
            return {sphere, rt::surface_hit(sphere, ray, *t)};
    }
}

double exact_dot(Vec3 a, Vec3 b) {
    return (Exact(a.x) * Exact(b.x) + Exact(a.y) * Exact(b.y) + Exact(a.z) * Exact(b.z)).high;
}

// A direction on the outer side of the surface: any, or one that all but grazes it.
Vec3 leaving(Vec3 normal, rt::Rng& rng) {
    for (;;) {
        Vec3 d = any_direction(rng);
        const Real cosine = static_cast<Real>(exact_dot(d, normal));
        if (rng() & 1) d += (any_size(rng, -16, 0) - cosine) * normal;
        const Vec3 out = exact_dot(d, normal) < 0 ? -d : d;
        // Within its rounding error the dot product does not tell which side this is.
        if (exact_dot(out, normal) > 4 * static_cast<double>(rt::epsilon)) return out;
    }
}

std::string describe(const Place& place, Vec3 direction) {
    return "the sphere at " + text(place.sphere.center) + " with radius " +
           text(place.sphere.radius) + ", left from " + text(place.hit.point) + " along " +
           text(direction);
}

}  // namespace

TEST_CASE("04.6 the ray starts just off the surface on the side it leaves to", "[04.6]") {
    Hit hit;
    hit.point = {0, 0, 1};
    hit.normal = {0, 0, 1};
    hit.point_error = 8 * rt::epsilon;
    for (const Vec3 up : {Vec3{0, 0, 1}, Vec3{real(0.6), 0, real(0.8)}, Vec3{0, 1, real(1e-6)}}) {
        const Vec3 out = rt::leave_surface(hit, up), in = rt::leave_surface(hit, -up);
        INFO("leaving (0, 0, 1) along " << text(up) << ": yours starts at " << text(out)
                                        << ", and the other way at " << text(in));
        INFO("Hint: along the normal, by the error of the point and that of the sum");
        CHECK(out.x == 0);
        CHECK(out.y == 0);
        CHECK(out.z >= 1 + 8 * rt::epsilon);
        CHECK(out.z <= 1 + 16 * rt::epsilon);
        {
            INFO("Hint: a direction against the normal goes into the sphere, and starts inside");
            CHECK(in.z <= 1 - 8 * rt::epsilon);
            CHECK(in.z >= 1 - 16 * rt::epsilon);
        }
    }
}

TEST_CASE("04.6 the ray moves along the normal by the error and no more than four", "[04.6]") {
    rt::Rng rng{46, 8};
    for (int i = 0; i < 50'000; ++i) {
        const Place place = any_place(rng);
        Hit hit = place.hit;
        // Other shapes, and spheres that were moved, have larger errors.
        if (i % 2) hit.point_error *= any_size(rng, 0, 6);
        hit.t = any_size(rng, -3, 3);
        const bool goes_out = rng() & 1;
        Vec3 direction = leaving(hit.normal, rng);
        if (!goes_out) direction = -direction;
        if (i % 3 == 0) direction *= any_size(rng, -6, 6);
        const Vec3 start = rt::leave_surface(hit, direction);
        const Vec3 side = goes_out ? hit.normal : -hit.normal;
        const double error = static_cast<double>(hit.point_error);
        const ExactVec3 move{Exact(start.x) - Exact(hit.point.x),
                             Exact(start.y) - Exact(hit.point.y),
                             Exact(start.z) - Exact(hit.point.z)};
        const double up =
            (move.x * Exact(side.x) + move.y * Exact(side.y) + move.z * Exact(side.z)).high;
        const auto beside = [&](const Exact& m, Real n) {
            return std::abs((m - Exact(up) * Exact(n)).high);
        };
        const double aside =
            std::max({beside(move.x, side.x), beside(move.y, side.y), beside(move.z, side.z)});
        // Each coordinate is rounded, and the largest may be far larger than what counts above.
        const double rounded = 4 * static_cast<double>(rt::epsilon) *
                               static_cast<double>(rt::max_component(rt::abs(hit.point)));
        const double moved_in_errors = up / error, aside_over_allowed = aside / (error + rounded);
        if (1 - 1e-3 <= moved_in_errors && moved_in_errors <= 4 && aside_over_allowed <= 1)
            continue;
        INFO("the point " << text(hit.point) << " with normal " << text(hit.normal)
                          << " and point_error " << text(hit.point_error) << ", left along "
                          << text(direction) << ": yours starts at " << text(start));
        {
            INFO(
                "Hint: it is moved to the wrong side. That is the side to which the new direction "
                "points, by however little");
            REQUIRE(moved_in_errors > 0);
        }
        {
            INFO("Hint: move by the error of the point plus what rounding the sum may take back");
            REQUIRE(moved_in_errors >= 1 - 1e-3);
        }
        {
            INFO("Hint: this starts too far away: it may be beyond another surface");
            REQUIRE(moved_in_errors <= 4);
        }
        INFO("Hint: move along the normal, not along the direction");
        REQUIRE(aside_over_allowed <= 1);
    }
}

TEST_CASE("04.6 a gray sphere under a white sky returns its albedo", "[04.6]") {
    // The furnace: from a sphere alone every path leaves after one bounce, so nothing is random
    // here. One path that meets the sphere again is one too many.
    rt::Rng rng{46, 1};
    const Real albedo = real(0.75);
    const rt::MaterialList<rt::Lambertian> gray{{{{albedo, albedo, albedo}}}};
    for (const Real radius : {real(1e-9), Real(1), real(1e9)})
        for (int i = 0; i < 20000; ++i) {
            const Vec3 center = 100 * radius * any_direction(rng);
            const Vec3 from = center + 3 * radius * any_direction(rng);
            const Vec3 at = center + real(0.99) * radius * any_direction(rng);
            const Color light = rt::path_radiance(Ray{from, (at - from) / radius},
                                                  rt::SphereList{{{{center, radius}, 0}}}, gray,
                                                  rt::UniformSky{}, rt::BlackEnding{}, 16, rng);
            if (std::abs(light.r - albedo) <= rt::epsilon) continue;
            INFO("radius " << text(radius) << ": expected " << text(albedo) << ", yours gives "
                           << text(light.r)
                           << ".\nHint: the path met the sphere again that it had left, and was "
                              "dimmed twice. Move by the error of the point plus what rounding the "
                              "sum may take back");
            REQUIRE(text(light.r) == text(albedo));
        }
}

TEST_CASE("04.6 two facing spheres pass light on as their series says", "[04.6]") {
    // From the point of the one sphere that faces the other, a share (r / d)^2 of all bounces meets
    // the other, at distance d from its center: r = 1, d = 2 here, so that they almost touch.
    const double share = 0.25, albedo = 0.5;
    const rt::SphereList world{{{{{-2, 0, 0}, 1}, 0}, {{{1, 0, 0}, 1}, 0}}};
    const Color half{real(0.5), real(0.5), real(0.5)};
    const rt::MaterialList<rt::Lambertian> gray{{{half}}};
    const Ray ray{{real(-0.5), 0, 0}, {-1, 0, 0}};
    const auto mean_light = [&](const auto& ending, int depth) {
        rt::Rng rng{46, 2};
        Mean light;
        for (int i = 0; i < 100'000; ++i)
            light.add(static_cast<double>(
                rt::path_radiance(ray, world, gray, rt::UniformSky{}, ending, depth, rng).g));
        return light;
    };
    const auto check = [](const char* what, const Mean& light, double expected) {
        INFO(what << ": expected " << expected << ", yours gives " << light.mean() << " +- "
                  << light.standard_error());
        // Right code stays within 3 standard errors in all but one of 370 runs, and the seed is
        // fixed.
        CHECK(std::abs(light.mean() - expected) <= 3 * light.standard_error());
    };
    const double first = albedo * (1 - share), second = albedo * albedo * share;
    check("depth 2, black", mean_light(rt::BlackEnding{}, 2), first);
    check("depth 2, sky", mean_light(rt::SkyEnding{}, 2), first + second);
    // Deeper, what is left lies between the two.
    const Mean roulette = mean_light(rt::RouletteEnding{}, 2);
    const Mean deep = mean_light(rt::SkyEnding{}, 32);
    CHECK(deep.mean() > first);
    CHECK(deep.mean() < first + second);
    INFO("Russian roulette gives " << roulette.mean() << " +- " << roulette.standard_error()
                                   << ", 32 bounces " << deep.mean());
    CHECK(std::abs(roulette.mean() - deep.mean()) <=
          4 * (roulette.standard_error() + deep.standard_error()));
}

TEST_CASE("04.6 a path in a closed room stays in it", "[04.6]") {
    rt::Rng rng{46, 3};
    const rt::SphereList room{{{{{0, 0, 0}, 1}, 0}}};
    const rt::MaterialList<rt::Lambertian> white{{{{1, 1, 1}}}};
    for (int i = 0; i < 200; ++i) {
        const Color light = rt::path_radiance(Ray{{0, 0, 0}, any_direction(rng)}, room, white,
                                              rt::UniformSky{}, rt::BlackEnding{}, 100, rng);
        if (light == Color{}) continue;
        INFO("this path got out.\nHint: a ray that leaves the inner side starts inside");
        REQUIRE(text(light.r) == "0");
    }
}

TEST_CASE("04.6 a million rays never meet the surface that they leave", "[04.6][hard]") {
    rt::Rng rng{46, 4};
    for (int i = 0; i < 1'000'000; ++i) {
        const Place place = any_place(rng);
        const Vec3 out = leaving(place.hit.normal, rng);
        const Ray ray{rt::leave_surface(place.hit, out), out};
        if (const auto t = rt::hit_sphere(place.sphere, ray, {})) {
            INFO(describe(place, out) << " is met again at t = " << text(*t));
            const double moved = exact_dot(ray.origin - place.hit.point, place.hit.normal);
            const double error = static_cast<double>(place.hit.point_error);
            INFO("it starts " << moved << " above the point, whose error is " << error);
            INFO("Hint: " << (moved < 0 ? "it starts on the wrong side"
                              : moved < 2 * error
                                  ? "the sum point + distance * normal is rounded, too, and may "
                                    "take back a part of the move: add that to the distance"
                                  : "the distance must come from the error bound: a fixed one, "
                                    "such as 0.001, or a fixed smallest t, is right for no other "
                                    "size"));
            REQUIRE(!t);
        }
    }
}

TEST_CASE("04.6 a million rays meet what stands ten error bounds off", "[04.6][hard]") {
    rt::Rng rng{46, 5};
    for (int i = 0; i < 1'000'000; ++i) {
        const Place place = any_place(rng);
        const Hit& hit = place.hit;
        // A sphere of the same size whose surface faces this one at ten times the error bound.
        const Real r = place.sphere.radius;
        const Sphere wall{hit.point + (r + 10 * hit.point_error) * hit.normal, r};
        const Vec3 start = rt::leave_surface(hit, hit.normal);
        const auto t = rt::hit_sphere(wall, {start, hit.normal}, {});
        if (!t || !(*t < r)) {
            INFO(describe(place, hit.normal)
                 << " starts at " << text(start) << ", beyond a wall at a distance of "
                 << text(10 * hit.point_error));
            INFO("Hint: start off the surface by its error, and by no more than that needs");
            REQUIRE(t);
            REQUIRE(*t < r);
        }
    }
}

TEST_CASE("04.6 a ray into the sphere meets its far side", "[04.6][hard]") {
    rt::Rng rng{46, 6};
    for (int i = 0; i < 100'000; ++i) {
        const Place place = any_place(rng);
        const Vec3 in = -leaving(place.hit.normal, rng);
        // Through steep angles only: a chord as short as the error bound may come out at 0.
        const double cosine = -exact_dot(in, place.hit.normal) / std::sqrt(exact_dot(in, in));
        if (cosine < 0.1) continue;
        const Ray ray{rt::leave_surface(place.hit, in), in};
        const auto t = rt::hit_sphere(place.sphere, ray, {});
        const double length = std::sqrt(exact_dot(in, in)), chord = 2 * cosine / length;
        const double r = static_cast<double>(place.sphere.radius);
        // The start is off by some error bounds along the normal and along the surface.
        const double off = static_cast<double>(place.hit.point_error) / r;
        const double allowed = 100 * (off + static_cast<double>(rt::epsilon)) / length;
        const double found = t ? static_cast<double>(*t) / r : 0;
        if (std::abs(found - chord) <= allowed) continue;
        INFO(describe(place, in));
        INFO(
            "Hint: it must start inside; what it meets then is the far end of its chord. This is "
            "how far that is, in radii; it may be off by "
            << allowed);
        REQUIRE(t);
        REQUIRE(text(static_cast<Real>(found)) == text(static_cast<Real>(chord)));
    }
}

TEST_CASE("04.6 a scene 2^30 times larger or smaller is left the same way", "[04.6][hard]") {
    rt::Rng rng{46, 7};
    for (int i = 0; i < 10'000; ++i) {
        const Place place = any_place(rng);
        const Vec3 out = leaving(place.hit.normal, rng);
        for (const int power : {-30, 30}) {
            const Real s = std::scalbn(Real(1), power);
            Hit scaled = place.hit;
            scaled.point *= s;
            scaled.point_error *= s;
            const Vec3 actual = rt::leave_surface(scaled, out);
            const Vec3 expected = s * rt::leave_surface(place.hit, out);
            if (actual == expected) continue;
            INFO(describe(place, out) << ", scaled by 2^" << power);
            INFO("Hint: a distance that does not come from the numbers at hand?");
            REQUIRE(text(actual) == text(expected));
        }
    }
}

TEST_CASE("04.6 a scene of any size gives the same picture", "[04.6][hard]") {
    constexpr int width = 24, height = 16;
    // Two spheres that touch, a third that stands half in the ground.
    const auto picture = [](Real scale) {
        const auto sphere = [&](Real x, Real y, Real z, Real r) {
            return rt::SceneSphere{{scale * Vec3{x, y, z}, scale * r}, 0};
        };
        const rt::SphereList world{{sphere(0, -1000, 0, 1000), sphere(-1, 1, 0, 1),
                                    sphere(1, 1, 0, 1), sphere(0, 0, 2, real(0.5))}};
        const rt::MaterialList<rt::Lambertian> gray{{{{real(0.5), real(0.6), real(0.7)}}}};
        const rt::Camera camera = rt::make_camera(
            {scale * Vec3{0, 2, 6}, scale * Vec3{0, 1, 0}, {0, 1, 0}, rt::pi / 4}, width, height);
        return rt::make_image(width, height, [&](int column, int row) {
            return rt::render_pixel(camera, world, gray, rt::GradientSky{{1, 1, 1}, {0, 0, 1}},
                                    rt::SkyEnding{}, {16, 8, 1}, column, row);
        });
    };
    const rt::Image image = picture(1);
    const auto different_pixels = [&](Real scale, Real step) {
        const rt::Image scaled = picture(scale);
        int count = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Color a = image.at(x, y), b = scaled.at(x, y);
                REQUIRE(rt::is_finite(b));
                count += !(std::max({std::abs(a.r - b.r), std::abs(a.g - b.g),
                                     std::abs(a.b - b.b)}) <= step);
            }
        return count;
    };
    INFO("Hint: some length in your code does not scale with the scene");
    for (const int power : {-30, 30}) {
        INFO("scaled by 2^" << power << ", which rounds nothing: not a bit may differ");
        CHECK(different_pixels(std::scalbn(Real(1), power), 0) == 0);
    }
    // Other factors round every number of the scene. In double no path notices; in float one in
    // some thousand meets another sphere than before, which shows as noise in its pixel.
    for (const Real scale : {real(1e-9), real(1e9)}) {
        INFO("scaled by " << text(scale));
        CHECK(different_pixels(scale, 1 / Real(255)) <= for_this_precision(width * height / 50, 0));
    }
}
