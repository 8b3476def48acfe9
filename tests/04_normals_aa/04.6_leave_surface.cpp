#include <optional>
#include <rt/hit_sphere.hpp>
#include <rt/leave_surface.hpp>
#include <rt/rng.hpp>
#include <rt/surface_hit.hpp>

#include "checkpoint.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Hit, rt::Ray, rt::Sphere;

namespace {

// A point on a sphere of radius 10^-9 to 10^9, up to 10^6 radii from the scene's origin, as a ray
// hits it from outside or from inside.
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

TEST_CASE("04.6 the ray starts just off the surface on the side of its direction", "[04.6]") {
    Hit hit;
    hit.point = {3, -5, 1};
    hit.normal = {0, 0, 1};
    hit.point_error = 8 * rt::epsilon;
    for (const Vec3 up : {Vec3{0, 0, 1}, Vec3{real(0.6), 0, real(0.8)}, Vec3{0, 1, real(1e-6)}}) {
        const Vec3 out = rt::leave_surface(hit, up), in = rt::leave_surface(hit, -up);
        INFO("leaving (3, -5, 1) along " << text(up) << ": your ray starts at " << text(out)
                                         << ", and in the opposite direction at " << text(in));
        INFO("Hint: move along the normal, by twice the error of the point");
        CHECK(out.x == 3);
        CHECK(out.y == -5);
        CHECK(out.z >= 1 + 8 * rt::epsilon);
        CHECK(out.z <= 1 + 16 * rt::epsilon);
        {
            INFO("Hint: a ray against the normal goes into the sphere, and starts inside");
            CHECK(in.z <= 1 - 8 * rt::epsilon);
            CHECK(in.z >= 1 - 16 * rt::epsilon);
        }
    }
}

TEST_CASE("04.6 the start is moved along the normal by one to four error bounds", "[04.6]") {
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
        const bool is_right =
            1 - 1e-3 <= moved_in_errors && moved_in_errors <= 4 && aside_over_allowed <= 1;
        if (!is_right) {
            INFO("the point " << text(hit.point) << " with normal " << text(hit.normal)
                              << " and point_error " << text(hit.point_error) << ", left along "
                              << text(direction) << ": your ray starts at " << text(start));
            {
                INFO(
                    "Hint: the start is moved to the wrong side. The right side is the side to "
                    "which the "
                    "new direction points, however slightly");
                REQUIRE(moved_in_errors > 0);
            }
            {
                INFO("Hint: move by the error of the point plus the rounding error of the sum");
                REQUIRE(moved_in_errors >= 1 - 1e-3);
            }
            {
                INFO("Hint: the ray starts too far away: it may start beyond another surface");
                REQUIRE(moved_in_errors <= 4);
            }
            INFO("Hint: move along the normal, not along the direction");
            REQUIRE(aside_over_allowed <= 1);
        }
        REQUIRE(is_right);
    }
}

TEST_CASE("04.6 a million rays never meet the surface that they leave", "[04.6][hard]") {
    rt::Rng rng{46, 4};
    std::optional<Real> t;
    for (int i = 0; i < 1'000'000 && !t; ++i) {
        const Place place = any_place(rng);
        const Vec3 out = leaving(place.hit.normal, rng);
        const Ray ray{rt::leave_surface(place.hit, out), out};
        t = rt::hit_sphere(place.sphere, ray, {});
        if (t) {
            UNSCOPED_INFO(describe(place, out) << " is met again at t = " << text(*t));
            const double moved = exact_dot(ray.origin - place.hit.point, place.hit.normal);
            const double error = static_cast<double>(place.hit.point_error);
            UNSCOPED_INFO("the ray starts " << moved << " above the point, whose error is "
                                            << error);
            UNSCOPED_INFO(
                "Hint: " << (moved < 0 ? "the ray starts on the wrong side"
                             : moved < 2 * error
                                 ? "the sum point + distance * normal is rounded, too, which may "
                                   "undo a part of the move: add the rounding error to the distance"
                                 : "the distance must come from the error bound: a fixed one, "
                                   "such as 0.001, or a fixed smallest t, is right for scenes of "
                                   "one size only"));
        }
    }
    REQUIRE(!t);
}

TEST_CASE("04.6 a million rays meet a wall that is ten error bounds away", "[04.6][hard]") {
    rt::Rng rng{46, 5};
    Real farthest = 0;  // t of a hit, in radii
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
            INFO("Hint: start no farther off the surface than the error requires");
            REQUIRE(t);
            REQUIRE(*t < r);
        }
        farthest = std::max(farthest, *t / r);
    }
    CHECK(farthest <= 1);
}

TEST_CASE("04.6 a ray into the sphere meets its far side", "[04.6][hard]") {
    rt::Rng rng{46, 6};
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Place place = any_place(rng);
        const Vec3 in = -leaving(place.hit.normal, rng);
        // At steep angles only: a chord as short as the error bound may be rounded to 0.
        const double cosine = -exact_dot(in, place.hit.normal) / std::sqrt(exact_dot(in, in));
        if (cosine < 0.1) continue;
        const Ray ray{rt::leave_surface(place.hit, in), in};
        const auto t = rt::hit_sphere(place.sphere, ray, {});
        const double length = std::sqrt(exact_dot(in, in)), chord = 2 * cosine / length;
        const double r = static_cast<double>(place.sphere.radius);
        // The start is off by a few error bounds along the normal and along the surface.
        const double off = static_cast<double>(place.hit.point_error) / r;
        const double allowed = 100 * (off + static_cast<double>(rt::epsilon)) / length;
        const double found = t ? static_cast<double>(*t) / r : 0;
        const double off_over_allowed = std::abs(found - chord) / allowed;
        worst = std::max(worst, off_over_allowed);
        if (off_over_allowed <= 1) continue;
        INFO(describe(place, in));
        INFO(
            "Hint: the ray must start inside; it then meets the far end of its chord. The values "
            "are the distance to that end, in radii; the allowed error is "
            << allowed);
        REQUIRE(t);
        REQUIRE(text(static_cast<Real>(found)) == text(static_cast<Real>(chord)));
    }
    CHECK(worst <= 1);
}

TEST_CASE("04.6 a ray into a tiny sphere far from the scene's origin starts inside the sphere",
          "[04.6][hard]") {
    rt::Rng rng{46, 9};
    bool meets_far_side = true;
    for (int i = 0; i < 200'000 && meets_far_side; ++i) {
        // Many centers are next to a power of two, where the steps become twice as long.
        const auto coordinate = [&]() -> Real {
            if (rng() % 4 == 0) return rng.uniform(-2, 2);
            const Real beside =
                1 + static_cast<Real>(rng() % 9) * rt::epsilon / 2 - 3 * rt::epsilon;
            return rng() % 2 == 0 ? beside : -beside;
        };
        const Vec3 center{coordinate(), coordinate(), coordinate()};
        const Real step = std::scalbn(rt::epsilon, std::ilogb(rt::max_component(center)));
        const Sphere sphere{center, step * 8 * any_size(rng, 0, 3)};
        const Vec3 n = any_direction(rng);
        const Place place{
            sphere,
            rt::surface_hit(sphere, {center + 2 * sphere.radius * n, -sphere.radius * n}, 1)};
        const Vec3 in = -leaving(place.hit.normal, rng);
        const double cosine = -exact_dot(in, place.hit.normal) / std::sqrt(exact_dot(in, in));
        if (cosine * static_cast<double>(sphere.radius / step) < 8) continue;
        meets_far_side =
            rt::hit_sphere(sphere, {rt::leave_surface(place.hit, in), in}, {}).has_value();
        if (meets_far_side) continue;
        UNSCOPED_INFO(describe(place, in)
                      << ": the ray does not meet the far side. The radius is "
                      << sphere.radius / step
                      << " times the step from one coordinate to the next, and the cosine is "
                      << cosine);
        UNSCOPED_INFO(
            "Hint: move the start inward along the normal, by no more than the errors of the "
            "point and the sum");
    }
    REQUIRE(meets_far_side);
}

TEST_CASE("04.6 a scene 2^30 times larger or smaller scales the start of the ray", "[04.6][hard]") {
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
            if (!(actual == expected)) {
                INFO(describe(place, out) << ", scaled by 2^" << power);
                INFO("Hint: use no distance that does not come from the hit");
                REQUIRE(text(actual) == text(expected));
            }
            REQUIRE(actual == expected);
        }
    }
}
