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

using checkpoint::text;

// A ray that hits the sphere, from up to `far` radii away or from inside, with its t. Some rays all
// but graze the sphere, some meet it where they leave it, and their directions have any length.
struct Shot {
    Sphere sphere;
    Ray ray;
    Real t;
};

// A direction at a right angle to v, or nearly.
Vec3 across(Vec3 v, rt::Rng& rng) {
    for (;;) {
        const Vec3 a = any_direction(rng);
        const Vec3 c{v.y * a.z - v.z * a.y, v.z * a.x - v.x * a.z, v.x * a.y - v.y * a.x};
        const Real size = std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z);
        if (size > real(0.1)) return c / size;
    }
}

Vec3 any_axis(rt::Rng& rng) {
    const Real sign = rng() & 1 ? Real(1) : Real(-1);
    const unsigned axis = rng() % 3;
    return {axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0};
}

template <class Check>
void for_shots(int count, Real far_power, Real far, Check check) {
    rt::Rng rng{41, 1};
    const Real sizes = for_this_precision(9, 40), lengths = for_this_precision(3, 9);
    for (int i = 0; i < count;) {
        const Real radius = any_size(rng, -sizes, sizes);
        Sphere sphere{radius * any_size(rng, -1, far_power) * any_direction(rng), radius};
        if (rng() % 16 == 0) sphere.center = {};
        const Vec3 side = rng() % 8 ? any_direction(rng) : any_axis(rng);
        const Real start = i % 2 ? rng.uniform() : any_size(rng, 0, std::log10(far));
        Vec3 from = start * side, aim = rng.uniform() * any_direction(rng);
        if (rng() % 16 == 0) aim = {};
        if (rng() % 4 == 0) {  // the line comes this close to the surface, where it is closest
            aim = (1 - any_size(rng, -12, -1)) * side;
            from = aim + start * across(side, rng);
        }
        if (aim == from) continue;
        const Ray ray{sphere.center + radius * from,
                      any_size(rng, -lengths, lengths) * (aim - from)};
        auto t = rt::hit_sphere(sphere, ray, {});
        if (t && rng() % 4 == 0)  // the point where it leaves
            t = rt::hit_sphere(sphere, ray, {std::nextafter(*t, rt::infinity), rt::infinity});
        if (!t) continue;
        ++i;
        check(Shot{sphere, ray, *t});
    }
}

std::string text(const Shot& shot) {
    return "sphere at " + text(shot.sphere.center) + " with radius " + text(shot.sphere.radius) +
           ", ray from " + text(shot.ray.origin) + " along " + text(shot.ray.direction) +
           ", t = " + text(shot.t);
}

// From the center to the point at t, in radii, without a detour through the scene's origin.
ExactVec3 exact_outward(const Shot& shot) {
    const auto along = [&](Real o, Real c, Real d) {
        return (Exact(o) - Exact(c) + Exact(shot.t) * Exact(d)) / Exact(shot.sphere.radius);
    };
    const auto& [o, d] = shot.ray;
    const Vec3 c = shot.sphere.center;
    return {along(o.x, c.x, d.x), along(o.y, c.y, d.y), along(o.z, c.z, d.z)};
}

// How far the ray starts from the center, in radii.
double start_in_radii(const Shot& shot) {
    const Vec3 f = (shot.ray.origin - shot.sphere.center) / shot.sphere.radius;
    return static_cast<double>(rt::max_component(rt::abs(f)));
}

const double epsilon = static_cast<double>(rt::epsilon);

// Where the ray grazes the sphere by less than the error of t, either answer will do.
void check_side(const Shot& shot, const Hit& hit) {
    const ExactVec3 n = exact_outward(shot);
    const Vec3 d = shot.ray.direction;
    const Exact cosine = (n.x * Exact(d.x) + n.y * Exact(d.y) + n.z * Exact(d.z)) /
                         (exact_length(n) * exact_length({d.x, d.y, d.z}));
    if (std::abs(cosine.high) < std::sqrt(16 * epsilon * (1 + start_in_radii(shot)))) return;
    if (hit.front != (cosine.high < 0)) {
        UNSCOPED_INFO(text(shot));
        UNSCOPED_INFO(
            "the cosine of the angle between the direction and the outward normal is "
            << cosine.high
            << ".\nHint: the hit is in front if the ray's direction points against the outward "
               "normal, however slightly");
    }
    REQUIRE(hit.front == (cosine.high < 0));
}

}  // namespace

TEST_CASE("04.1 a hit from outside has the outward normal and is in front", "[04.1]") {
    const Sphere sphere{{1, 2, 3}, 2};
    const Hit hit = rt::surface_hit(sphere, {{1, 2, 10}, {0, 0, -1}}, 5);
    CHECK(hit.t == 5);
    if (const Real length = std::sqrt(dot(hit.normal, hit.normal));
        std::abs(length - 1) > real(0.01)) {
        INFO("Hint: normalize the vector from the center to the point");
        const std::string length_of_normal = text(length);
        REQUIRE(length_of_normal == "1");
    }
    {
        INFO(EXPECTED "the point (1, 2, 5), " ACTUAL
             << text(hit.point)
             << ".\nHint: the way from the center to the point is (ray.origin - sphere.center) + t "
                "* ray.direction");
        CHECK(hit.point == Vec3{1, 2, 5});
    }
    INFO(EXPECTED "the normal (0, 0, 1), " ACTUAL
         << text(hit.normal) << ".\nHint: normalize the vector from the center to the point");
    CHECK(hit.normal == Vec3{0, 0, 1});
    INFO(EXPECTED
         "front to be true, " ACTUAL
         "false.\nHint: the ray came from outside if its direction points against the normal");
    CHECK(hit.front);
}

TEST_CASE("04.1 a hit from inside has the outward normal and is not in front", "[04.1]") {
    const Sphere sphere{{1, 2, 3}, 2};
    const Hit hit = rt::surface_hit(sphere, {{1, 3, 3}, {0, 2, 0}}, real(0.5));
    INFO("a ray that starts in the sphere and leaves it upward: " EXPECTED
         "the point (1, 4, 3), " ACTUAL
         << text(hit.point)
         << ".\nHint: the point is the center plus the radius times the normal, which points "
            "outward even if seen from inside");
    CHECK(hit.point == Vec3{1, 4, 3});
    INFO("the normal points outward, even if seen from inside: " EXPECTED "(0, 1, 0), " ACTUAL
         << text(hit.normal));
    CHECK(hit.normal == Vec3{0, 1, 0});
    INFO(EXPECTED "front to be false, " ACTUAL "true: the ray runs along the normal");
    CHECK_FALSE(hit.front);
}

TEST_CASE("04.1 front and t and material are correct for every ray", "[04.1]") {
    for_shots(5000, 2, 100, [](const Shot& shot) {
        const Hit hit = rt::surface_hit(shot.sphere, shot.ray, shot.t);
        if (hit.t != shot.t) {
            INFO(text(shot));
            INFO("Hint: pass t on unchanged; it counts multiples of the direction");
            REQUIRE(text(hit.t) == text(shot.t));
        }
        if (hit.material != 0) {
            INFO("Hint: leave the material at 0; the list of spheres sets it");
            REQUIRE(hit.material == 0);
        }
        check_side(shot, hit);
    });
}

TEST_CASE("04.1 the point is moved onto the surface", "[04.1]") {
    rt::Rng rng{41, 3};
    for (int i = 0; i < 200; ++i) {
        // From far away, where t is too large for all digits of the point.
        const Sphere sphere{3 * any_direction(rng), rng.uniform(1, 2)};
        const Vec3 from = 1000 * any_direction(rng);
        const Ray ray{from, rt::normalize(sphere.center - from)};
        const auto t = rt::hit_sphere(sphere, ray, {});
        REQUIRE(t);
        const Hit hit = rt::surface_hit(sphere, ray, *t);
        const Real off = rt::length(hit.point - sphere.center) - sphere.radius;
        const bool is_unit = std::abs(rt::length(hit.normal) - 1) <= 16 * rt::epsilon;
        INFO("the ray comes from 1000 units away; the point is "
             << text(off) << " off the surface, and point_error is " << text(hit.point_error)
             << ".\nHint: "
             << (is_unit ? "the point is center + radius * normal; origin + t * direction only "
                           "serves to find the normal"
                         : "the normal's length is not quite 1: normalize it; dividing it by the "
                           "radius keeps the rounding of t"));
        REQUIRE(std::abs(off) <= hit.point_error);
    }
}

TEST_CASE("04.1 point_error grows with the radius and the distance from the origin", "[04.1]") {
    for_shots(2000, 2, 100, [](const Shot& shot) {
        const Hit hit = rt::surface_hit(shot.sphere, shot.ray, shot.t);
        const Vec3 p = hit.point, n = hit.normal;
        const Real expected = rt::rounding_bound(16) * (std::sqrt(dot(p, p)) + shot.sphere.radius);
        // The sharper bound of the star will do, too.
        const Real least =
            rt::epsilon / 2 * (dot(rt::abs(p), rt::abs(n)) + 16 * shot.sphere.radius);
        const bool is_right =
            real(0.999) * least <= hit.point_error && hit.point_error <= real(1.001) * expected;
        if (!is_right) {
            INFO(text(shot));
            HINT(expected, hit.point_error,
                 "point_error is rounding_bound(16) * (length(hit.point) + sphere.radius): set it "
                 "after the point");
            REQUIRE(text(hit.point_error) == text(expected));
        }
        REQUIRE(is_right);
    });
}

TEST_CASE("04.1 the member front is correct unless rounding errors hide the side", "[04.1][hard]") {
    const Real far = 1 / (16 * rt::epsilon);
    for_shots(20000, 2, far, [](const Shot& shot) {
        check_side(shot, rt::surface_hit(shot.sphere, shot.ray, shot.t));
    });
}

TEST_CASE("04.1 normals have length 1 and lead from the center to the point", "[04.1][hard]") {
    for_shots(20000, 6, 1000, [](const Shot& shot) {
        const Hit hit = rt::surface_hit(shot.sphere, shot.ray, shot.t);
        const Vec3 n = hit.normal;
        const double off = (exact_length({n.x, n.y, n.z}) - Exact(1)).high;
        // In epsilons, since numbers as small as an error are all printed as 0.0.
        const double off_in_epsilons = std::abs(off) / epsilon;
        if (!(off_in_epsilons <= 2)) {
            INFO(text(shot));
            INFO("the normal is "
                 << text(n) << ", its length differs from 1 by " << off
                 << ".\nHint: normalize the vector from the center to the point. t is rounded, "
                    "so that vector is not quite as long as the radius: dividing by the radius "
                    "is not enough");
            REQUIRE(off_in_epsilons <= 2);
        }

        const ExactVec3 to = exact_outward(shot);
        const Exact size = exact_length(to);
        // Three roundings of numbers as large as the distance, and those of normalize.
        const double allowed = epsilon * (4 + 4 * start_in_radii(shot));
        const double error_over_allowed = std::max({std::abs((to.x / size - Exact(n.x)).high),
                                                    std::abs((to.y / size - Exact(n.y)).high),
                                                    std::abs((to.z / size - Exact(n.z)).high)}) /
                                          allowed;
        if (!(error_over_allowed <= 1)) {
            UNSCOPED_INFO(text(shot));
            UNSCOPED_HINT(
                (ExactVec3{to.x / size, to.y / size, to.z / size}), n,
                "take (origin - center) + t * direction. The point itself, far from the scene's "
                "origin, has already lost digits when the center is subtracted");
        }
        REQUIRE(error_over_allowed <= 1);
    });
}

TEST_CASE("04.1 the point lies on the surface within its error bound", "[04.1][hard]") {
    for_shots(20000, 6, 1000, [](const Shot& shot) {
        const Hit hit = rt::surface_hit(shot.sphere, shot.ray, shot.t);
        const Vec3 c = shot.sphere.center;
        const double off = distance_from_surface(shot.sphere, hit.point);
        const double size = static_cast<double>(rt::max_component(rt::abs(hit.point)));
        const double radius = static_cast<double>(shot.sphere.radius);
        const double off_over_allowed = off / (2 * epsilon * (2 * size + 8 * radius));
        const double off_over_bound = off / static_cast<double>(hit.point_error);
        // Along the surface: the point is where the normal says.
        const auto beside = [&](Real p, Real center, Real n) {
            const Exact place = Exact(center) + Exact(shot.sphere.radius) * Exact(n);
            return std::abs((place - Exact(p)).high);
        };
        const double far = size + radius * (1 + start_in_radii(shot)) +
                           static_cast<double>(rt::max_component(rt::abs(c)));
        const double beside_over_allowed = std::max({beside(hit.point.x, c.x, hit.normal.x),
                                                     beside(hit.point.y, c.y, hit.normal.y),
                                                     beside(hit.point.z, c.z, hit.normal.z)}) /
                                           (8 * epsilon * far);
        const bool is_right =
            off_over_allowed <= 1 && off_over_bound <= 1 && beside_over_allowed <= 1;
        if (!is_right) {
            INFO(text(shot));
            INFO("the point " << text(hit.point) << " is " << off
                              << " off the surface; its bound is " << hit.point_error
                              << ", its normal " << text(hit.normal));
            {
                INFO(
                    "Hint: move the point onto the surface, to center + radius * normal: only the "
                    "rounding of this sum is left");
                REQUIRE(off_over_allowed <= 1);
                REQUIRE(beside_over_allowed <= 1);
            }
            INFO(
                "Hint: each coordinate of the point was rounded, and so was everything that "
                "depends on the radius");
            REQUIRE(off_over_bound <= 1);
        }
        REQUIRE(is_right);
    });
}

TEST_CASE("04.1 the error bound equals the one derived in the text", "[04.1][hard]") {
    // Not far from the origin, where both parts of the bound count.
    for_shots(20000, 0, 1000, [](const Shot& shot) {
        const Hit hit = rt::surface_hit(shot.sphere, shot.ray, shot.t);
        const Vec3 p = hit.point, n = hit.normal;
        const Real sum = std::abs(p.x * n.x) + std::abs(p.y * n.y) + std::abs(p.z * n.z);
        const Real expected = rt::epsilon / 2 * (sum + 16 * shot.sphere.radius);
        // Beyond the formula's own rounding there is a bit to spare, as in rounding_bound.
        const Real allowed = for_this_precision(real(1e-4), real(1e-9));
        const Real relative = std::abs(hit.point_error - expected) / expected;
        if (!(relative <= allowed)) {
            INFO(text(shot));
            INFO("the point is " << text(p) << ", the normal " << text(n));
            HINT(expected, hit.point_error,
                 "the bound is u (|Px nx| + |Py ny| + |Pz nz|) + 16 u r with u = epsilon / 2. A "
                 "smaller bound "
                 "lets rays start inside, since hit_sphere rounds too; a larger one lets them "
                 "start beyond other surfaces");
            REQUIRE(text(hit.point_error) == text(expected));
        }
        REQUIRE(relative <= allowed);
    });
}

TEST_CASE("04.1 a ray that grazes the sphere counts as in front", "[04.1][hard]") {
    const Hit hit = rt::surface_hit({{0, 0, 0}, 1}, {{-2, 0, 1}, {1, 0, 0}}, 2);
    INFO(
        "direction (1, 0, 0), normal (0, 0, 1): their dot product is 0.\nHint: front is true if "
        "the dot product is not greater than 0; a ray from inside cannot graze");
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
            const bool is_same = scaled.point == s * hit.point && scaled.normal == hit.normal &&
                                 scaled.front == hit.front &&
                                 scaled.point_error == s * hit.point_error;
            if (!is_same) {
                INFO(text(shot));
                INFO("scaled by 2^" << power << ".\nHint: use no constant length, such as 0.001");
                REQUIRE(text(scaled.point) == text(s * hit.point));
                REQUIRE(text(scaled.normal) == text(hit.normal));
                REQUIRE(scaled.front == hit.front);
                REQUIRE(text(scaled.point_error) == text(s * hit.point_error));
            }
            REQUIRE(is_same);
        }
    });
}

TEST_CASE("04.1 a sphere too far away to be seen still has a normal", "[04.1][hard]") {
    // Rounding swallows the radius: origin + t * direction is the center itself.
    rt::Rng rng{41, 2};
    const auto any_number = [&] { return static_cast<Real>(rng() % 33) - 16; };
    for (int i = 0; i < 1000; ++i) {
        const Vec3 d{any_number(), any_number(), any_number()};
        const Vec3 center{any_number(), any_number(), any_number()};
        if (d == Vec3{}) continue;
        const Real t = 4096, radius = std::scalbn(Real(1), -70 + i % 20);
        const Ray ray{center - t * d, d};
        const Exact length = exact_length({d.x, d.y, d.z});
        const ExactVec3 expected{Exact(-d.x) / length, Exact(-d.y) / length, Exact(-d.z) / length};
        INFO("sphere at " << text(center) << " with radius " << text(radius) << ", ray from "
                          << text(ray.origin) << " along " << text(d) << ", t = 4096");
        const Hit hit = [&] {
            INFO(
                "the vector from the center to the point is (0, 0, 0) here.\nHint: compare with "
                "the zero vector, == Vec3{}, before you normalize");
            return rt::surface_hit({center, radius}, ray, t);
        }();
        {
            HINT(expected, hit.normal,
                 "the zero vector has no direction; such a hit counts as head on: take the "
                 "reversed direction of the ray, with length 1");
            REQUIRE(error_in_ulp(hit.normal, expected) <= 8);
        }
        INFO("Hint: a sphere that is hit head on is hit from outside");
        REQUIRE(hit.front);
        const auto place = [&](Real c, Real n) { return Exact(c) + Exact(radius) * Exact(n); };
        const Vec3 n = hit.normal;
        const ExactVec3 point{place(center.x, n.x), place(center.y, n.y), place(center.z, n.z)};
        {
            HINT(point, hit.point, "the point is center + radius * normal, as for every other hit");
            REQUIRE(error_in_ulp(hit.point, point) <= 2);
        }
        const Vec3 p = hit.point;
        const Real sum = std::abs(p.x * n.x) + std::abs(p.y * n.y) + std::abs(p.z * n.z);
        const Real expected_error = rt::epsilon / 2 * (sum + 16 * radius);
        const Real error_over_expected = hit.point_error / expected_error;
        HINT(expected_error, hit.point_error, "point_error is the same formula as for other hits");
        REQUIRE(std::abs(error_over_expected - 1) <= real(1e-4));
    }
}
