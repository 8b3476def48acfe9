#include <rt/hit_sphere.hpp>
#include <rt/surface_hit.hpp>

#include "checkpoint.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Hit, rt::Ray, rt::Sphere;

namespace {

Exact exact_length(const ExactVec3& v) {
    return sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

// How far the point is off the sphere's surface, in twice the digits of double.
double distance_from_surface(const Sphere& sphere, Vec3 p) {
    const ExactVec3 v{Exact(p.x) - Exact(sphere.center.x), Exact(p.y) - Exact(sphere.center.y),
                      Exact(p.z) - Exact(sphere.center.z)};
    return std::abs((exact_length(v) - Exact(sphere.radius)).high);
}

// A ray that hits the sphere, from up to `far` radii away or from inside, with its t.
struct Shot {
    Sphere sphere;
    Ray ray;
    Real t;
};

template <class Check>
void for_shots(int count, Real far_power, Real far, Check check) {
    rt::Rng rng{41, 1};
    for (int i = 0; i < count;) {
        const Real radius = any_size(rng, -9, 9);
        const Sphere sphere{radius * any_size(rng, -1, far_power) * any_direction(rng), radius};
        const Real start = i % 2 ? rng.uniform() : any_size(rng, 0, std::log10(far));
        const Vec3 origin = sphere.center + radius * start * any_direction(rng);
        const Vec3 aim = sphere.center + radius * rng.uniform() * any_direction(rng);
        if (aim == origin) continue;
        const Ray ray{origin, (aim - origin) / radius};
        const auto t = rt::hit_sphere(sphere, ray, {});
        if (!t) continue;
        ++i;
        INFO("sphere at " << text(sphere.center) << " with radius " << text(radius) << ", ray from "
                          << text(origin) << " along " << text(ray.direction));
        check(Shot{sphere, ray, *t});
    }
}

}  // namespace

TEST_CASE("04.1 a hit from outside has the outward normal and is in front", "[04.1]") {
    const Sphere sphere{{1, 2, 3}, 2};
    const Hit hit = rt::surface_hit(sphere, {{1, 2, 10}, {0, 0, -1}}, 5);
    CHECK(hit.t == 5);
    {
        INFO("expected the point (1, 2, 5), yours is " << text(hit.point));
        CHECK(hit.point == Vec3{1, 2, 5});
    }
    INFO("expected the normal (0, 0, 1), yours is "
         << text(hit.normal) << ".\nHint: from the center to the point, then normalize");
    CHECK(hit.normal == Vec3{0, 0, 1});
    INFO("Hint: the ray came from outside when its direction is against the normal");
    CHECK(hit.front);
}

TEST_CASE("04.1 a hit from inside has the outward normal and is not in front", "[04.1]") {
    const Sphere sphere{{1, 2, 3}, 2};
    const Hit hit = rt::surface_hit(sphere, {{1, 3, 3}, {0, 2, 0}}, real(0.5));
    INFO("a ray that starts in the sphere and leaves it upwards meets the point (1, 4, 3)");
    CHECK(hit.point == Vec3{1, 4, 3});
    INFO("Hint: the normal stays outward, also seen from inside: yours is " << text(hit.normal));
    CHECK(hit.normal == Vec3{0, 1, 0});
    CHECK_FALSE(hit.front);
}

TEST_CASE("04.1 the side is told for every ray", "[04.1]") {
    for_shots(2000, 2, 100, [](const Shot& shot) {
        const Hit hit = rt::surface_hit(shot.sphere, shot.ray, shot.t);
        const Vec3 f = (shot.ray.origin - shot.sphere.center) / shot.sphere.radius;
        const Real squared = f.x * f.x + f.y * f.y + f.z * f.z;
        // Where the ray starts on the surface or grazes it, either answer will do.
        const Vec3 d = shot.ray.direction, n = hit.normal;
        const Real cosine =
            (d.x * n.x + d.y * n.y + d.z * n.z) / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
        if (std::abs(squared - 1) < real(0.01) || std::abs(cosine) < real(0.01)) return;
        INFO("Hint: compare the ray's direction with the outward normal");
        REQUIRE(hit.front == (squared > 1));
    });
}

TEST_CASE("04.1 normals have length 1 and lead from the center to the point", "[04.1][hard]") {
    for_shots(20000, 6, 1000, [](const Shot& shot) {
        const Hit hit = rt::surface_hit(shot.sphere, shot.ray, shot.t);
        const Vec3 n = hit.normal;
        const double off = (exact_length({n.x, n.y, n.z}) - Exact(1)).high;
        // In epsilons, since numbers as small as an error are all printed as 0.0.
        const double off_in_epsilons = std::abs(off) / static_cast<double>(rt::epsilon);
        {
            INFO("the normal is "
                 << text(n) << ", its length is off 1 by " << off
                 << ".\nHint: normalize the vector from the center to the point. t is "
                    "rounded, so that vector is not quite as long as the radius: "
                    "dividing by the radius is not enough");
            REQUIRE(off_in_epsilons <= 2);
        }

        // The place that t tells, without a detour over the scene's origin, which is far away.
        const auto along = [&](Real o, Real c, Real d) {
            return (Exact(o) - Exact(c) + Exact(shot.t) * Exact(d)) / Exact(shot.sphere.radius);
        };
        const auto& [o, d] = shot.ray;
        const Vec3 c = shot.sphere.center;
        const ExactVec3 to{along(o.x, c.x, d.x), along(o.y, c.y, d.y), along(o.z, c.z, d.z)};
        const Exact size = exact_length(to);
        const Vec3 f = (o - c) / shot.sphere.radius;
        // Three roundings of numbers as large as the distance, and those of normalize.
        const double allowed = static_cast<double>(rt::epsilon) *
                               (4 + 4 * static_cast<double>(rt::max_component(rt::abs(f))));
        const double error = std::max({std::abs((to.x / size - Exact(n.x)).high),
                                       std::abs((to.y / size - Exact(n.y)).high),
                                       std::abs((to.z / size - Exact(n.z)).high)});
        INFO(
            "Hint: take (origin - center) + t * direction. The point itself, far from the scene's "
            "origin, has already lost digits when the center is subtracted");
        REQUIRE(error <= allowed);
    });
}

TEST_CASE("04.1 the point lies on the surface within its error bound", "[04.1][hard]") {
    for_shots(20000, 6, 1000, [](const Shot& shot) {
        const Hit hit = rt::surface_hit(shot.sphere, shot.ray, shot.t);
        const double off = distance_from_surface(shot.sphere, hit.point);
        const double size = static_cast<double>(rt::max_component(rt::abs(hit.point)));
        const double radius = static_cast<double>(shot.sphere.radius);
        INFO("the point " << text(hit.point) << " is " << off << " off the surface, its bound is "
                          << hit.point_error);
        {
            INFO(
                "Hint: move the point onto the surface, to center + radius * normal: what is left "
                "is the rounding of that");
            REQUIRE(off <= static_cast<double>(rt::rounding_bound(4)) * (2 * size + 8 * radius));
        }
        {
            INFO(
                "Hint: each coordinate of the point was rounded, and so was what hangs on the "
                "radius");
            REQUIRE(off <= static_cast<double>(hit.point_error));
        }
    });
}

TEST_CASE("04.1 the error bound is the one that the text derives", "[04.1][hard]") {
    // Not far from the origin, where both parts of the bound count.
    for_shots(20000, 0, 1000, [](const Shot& shot) {
        const Hit hit = rt::surface_hit(shot.sphere, shot.ray, shot.t);
        const Vec3 p = hit.point, n = hit.normal;
        const Real sum = std::abs(p.x * n.x) + std::abs(p.y * n.y) + std::abs(p.z * n.z);
        const Real expected = rt::epsilon / 2 * (sum + 16 * shot.sphere.radius);
        const Real ratio = hit.point_error / expected;
        HINT(expected, hit.point_error,
             "u (|Px nx| + |Py ny| + |Pz nz|) + 16 u r with u = epsilon / 2. A smaller bound lets "
             "rays start inside, since hit_sphere rounds too; a larger one lets them start beyond "
             "other surfaces");
        REQUIRE(ratio >= 1 - 8 * rt::epsilon);  // the formula's own rounding
        REQUIRE(ratio <= real(1.2));
    });
}

TEST_CASE("04.1 a ray that grazes the sphere counts as in front", "[04.1][hard]") {
    const Hit hit = rt::surface_hit({{0, 0, 0}, 1}, {{-2, 0, 1}, {1, 0, 0}}, 2);
    INFO(
        "direction (1, 0, 0), normal (0, 0, 1): their dot product is 0.\nHint: front holds if it "
        "is not greater than 0; a ray from inside cannot graze");
    CHECK(hit.normal == Vec3{0, 0, 1});
    CHECK(hit.front);
}

TEST_CASE("04.1 a scene 2^30 times larger or smaller gives the same hits", "[04.1][hard]") {
    for_shots(2000, 3, 100, [](const Shot& shot) {
        const Hit hit = rt::surface_hit(shot.sphere, shot.ray, shot.t);
        for (const int power : {-30, 30}) {
            const Real s = std::scalbn(Real(1), power);
            const Hit scaled =
                rt::surface_hit({s * shot.sphere.center, s * shot.sphere.radius},
                                {s * shot.ray.origin, s * shot.ray.direction}, shot.t);
            INFO("scaled by 2^" << power << ". Hint: a constant length somewhere, such as 0.001?");
            REQUIRE(scaled.point == s * hit.point);
            REQUIRE(scaled.normal == hit.normal);
            REQUIRE(scaled.front == hit.front);
            REQUIRE(scaled.point_error == s * hit.point_error);
        }
    });
}

TEST_CASE("04.1 a sphere too far away to be seen has a normal all the same", "[04.1][hard]") {
    // Rounding swallows the radius: origin + t * direction is the center itself.
    const Sphere sphere{{0, 0, 0}, real(1e-9)};
    INFO(
        "from the center to the point it is (0, 0, 0) here.\nHint: compare with the zero vector, "
        "== Vec3{}, before you normalize");
    const Hit hit = rt::surface_hit(sphere, {{0, 0, 1e9f}, {0, 0, -1}}, 1e9f);
    INFO("Hint: the zero vector has no direction; such a sphere is hit head on. Yours gives "
         << text(hit.normal));
    CHECK(hit.normal == Vec3{0, 0, 1});
    CHECK(hit.front);
    CHECK(hit.point == Vec3{0, 0, real(1e-9)});
}
