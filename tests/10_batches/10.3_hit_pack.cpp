#include <cstring>
#include <rt/hit_pack.hpp>
#include <rt/hit_sphere.hpp>

#include "random_inputs.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::pack_size;
using rt::PackInteger;
using rt::Sphere;

namespace {

Vec3 in_cube(rt::Rng& rng) {
    const Real x = rng.uniform(-1, 1), y = rng.uniform(-1, 1), z = rng.uniform(-1, 1);
    return {x, y, z};
}

template <class Value>
bool same_bits(const Value& a, const Value& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

struct OneRay {
    rt::Ray ray;
    Real t = rt::infinity;
    PackInteger sphere = -1;
};
using Rays = std::array<OneRay, pack_size>;

// What hit_sphere of 03.2 makes of it, one ray at a time.
bool expected_hit(const Sphere& sphere, PackInteger number, OneRay& one) {
    const auto t = rt::hit_sphere(sphere, one.ray, {0, one.t});
    if (!t || (*t == one.t && one.sphere > number)) return false;
    one.t = *t;
    one.sphere = number;
    return true;
}

std::string state(bool hits, Real t, PackInteger sphere) {
    return std::string(hits ? "the sphere counts as met" : "the sphere does not count as met") +
           "; the ray's nearest is sphere " + std::to_string(sphere) + " at t = " + text(t);
}

void check_pack(const Sphere& sphere, PackInteger number, const Rays& rays, const char* hint) {
    rt::RayPack pack;
    for (std::size_t i = 0; i < pack_size; ++i) {
        set(pack.origin, i, rays[i].ray.origin);
        set(pack.direction, i, rays[i].ray.direction);
        pack.t[i] = rays[i].t;
        pack.sphere[i] = rays[i].sphere;
    }
    const rt::RayPack before = pack;
    const rt::PackMask hit = rt::hit_pack(sphere, number, pack);
    for (std::size_t i = 0; i < pack_size; ++i) {
        OneRay expected = rays[i];
        const bool hits = expected_hit(sphere, number, expected);
        const bool same = same_bits(pack.t[i], expected.t) && pack.sphere[i] == expected.sphere &&
                          hit[i] == (hits ? -1 : 0);
        if (same) continue;
        INFO("sphere " << number << " at " << text(sphere.center) << " of radius "
                       << text(sphere.radius) << "; ray " << i << " of the pack, from "
                       << text(rays[i].ray.origin) << " along " << text(rays[i].ray.direction)
                       << ", nearest so far is sphere " << rays[i].sphere
                       << " at t = " << text(rays[i].t));
        INFO("expected: " << state(hits, expected.t, expected.sphere)
                          << "\nactual: " << state(hit[i] != 0, pack.t[i], pack.sphere[i]));
        INFO("Hint: " << hint);
        {
            INFO("the returned mask is -1 where the ray hits this sphere, and 0 elsewhere");
            REQUIRE(hit[i] == (hits ? -1 : 0));
        }
        REQUIRE(text(pack.t[i]) == text(expected.t));
        REQUIRE(pack.sphere[i] == expected.sphere);
        REQUIRE(same_bits(pack.t[i], expected.t));
    }
    const bool rest_is_same =
        same_bits(pack.origin, before.origin) && same_bits(pack.direction, before.direction);
    if (!rest_is_same) {
        INFO(
            "Hint: change only the members t and sphere of the pack: the next sphere needs the "
            "other members unchanged");
        REQUIRE(same_bits(pack.origin, before.origin));
        REQUIRE(same_bits(pack.direction, before.direction));
    }
    CHECK(rest_is_same);
}

// A ray toward the sphere or past it, from outside or from inside.
rt::Ray any_ray(rt::Rng& rng, const Sphere& sphere, Real largest_distance) {
    const Real r = sphere.radius;
    const Vec3 from = rng() % 4 == 0 ? Real(0.7) * r * in_cube(rng) / 2
                                     : r * any_size(rng, 0, largest_distance) * any_direction(rng);
    const Vec3 aim = Real(1.1) * r * any_direction(rng) * rng.uniform();
    const Vec3 along = (rng() % 4 == 0 ? Real(-1) : Real(1)) * (aim - from);
    const Real length = rt::max_component(along);
    return {sphere.center + from, any_size(rng, -2, 2) / length * along};
}

// Rays that already have another sphere as their nearest hit, at the very same t. Its number is one
// of `count`, from `lowest` on.
void check_ties(rt::Rng& rng, PackInteger number, PackInteger lowest, PackInteger count,
                const char* hint) {
    const Sphere sphere{5 * in_cube(rng), rng.uniform(Real(0.5), 3)};
    Rays rays;
    for (OneRay& one : rays) {
        one.ray = any_ray(rng, sphere, 1);
        OneRay found = one;
        expected_hit(sphere, number, found);
        one.t = found.t;
        one.sphere = lowest + static_cast<PackInteger>(rng() % static_cast<unsigned>(count));
    }
    check_pack(sphere, number, rays, hint);
}

}  // namespace

TEST_CASE("10.3 rays from all sides give the hits of hit_sphere", "[10.3]") {
    rt::Rng rng{103, 1};
    for (int round = 0; round < 5000; ++round) {
        const Real radius = any_size(rng, -3, 3);
        const Sphere sphere{Real(10) * radius * in_cube(rng), radius};
        Rays rays;
        for (OneRay& one : rays) {
            one.ray = any_ray(rng, sphere, 2);
            // An origin that is no sum of the center and another vector.
            one.ray.origin = rng.uniform(real(0.999), real(1.001)) * one.ray.origin;
        }
        check_pack(sphere, round, rays,
                   "use the operations of hit_sphere in the same order, each for all rays at once");
    }
}

TEST_CASE("10.3 rays from inside hit the far side", "[10.3]") {
    rt::Rng rng{103, 9};
    for (int round = 0; round < 1000; ++round) {
        const Sphere sphere{5 * in_cube(rng), rng.uniform(Real(0.5), 3)};
        Rays rays;
        for (OneRay& one : rays)
            one.ray = {sphere.center + sphere.radius / 2 * in_cube(rng), any_direction(rng)};
        check_pack(sphere, 7, rays,
                   "from inside, the smaller solution is negative, and the larger one counts");
    }
}

TEST_CASE("10.3 rays that start on a sphere hit it at t = 0", "[10.3]") {
    rt::Rng rng{103, 10};
    for (int round = 0; round < 100; ++round) {
        const auto whole = [&] { return static_cast<Real>(rng() % 9) - 4; };
        const Vec3 from{whole(), whole(), whole()};
        const Sphere sphere{from + Vec3{0, 0, -2}, 2};
        Rays rays;
        for (OneRay& one : rays)
            one.ray = {from, {whole(), whole(), rng() % 2 ? Real(-1) : Real(1)}};
        check_pack(sphere, 7, rays, "the interval begins at 0, and both of its ends belong to it");
    }
}

TEST_CASE("10.3 only hits that are nearer than before count", "[10.3]") {
    rt::Rng rng{103, 2};
    for (int round = 0; round < 5000; ++round) {
        const Sphere sphere{5 * in_cube(rng), rng.uniform(Real(0.5), 3)};
        Rays rays;
        for (OneRay& one : rays) {
            one.ray = any_ray(rng, sphere, 1);
            OneRay found = one;
            const bool hits = expected_hit(sphere, 7, found);
            one.sphere = static_cast<PackInteger>(rng() % 15);
            // Nearer than the hit, farther, or somewhere.
            one.t = hits && rng() % 3 != 0 ? found.t * rng.uniform(Real(0.9), Real(1.1))
                                           : any_size(rng, -2, 3);
        }
        check_pack(sphere, 7, rays,
                   "the interval is from 0 to rays.t; a hit beyond it does not count");
    }
}

TEST_CASE("10.3 of two equally near spheres the one with the higher number is kept", "[10.3]") {
    rt::Rng rng{103, 3};
    for (int round = 0; round < 3000; ++round)
        check_ties(rng, 7, 8, 7, "at exactly the same t, a sphere with a higher number is kept");
}

TEST_CASE("10.3 of two equally near spheres the one with the lower number is replaced", "[10.3]") {
    rt::Rng rng{103, 7};
    for (int round = 0; round < 3000; ++round)
        check_ties(
            rng, 7, 0, 7,
            "at exactly the same t, the higher number counts, and here the new sphere has it");
}

TEST_CASE("10.3 the same sphere at the same t counts as met", "[10.3]") {
    rt::Rng rng{103, 8};
    for (int round = 0; round < 300; ++round)
        check_ties(rng, 7, 7, 1,
                   "the ray keeps its old hit only if the sphere of that hit has a higher number");
}

TEST_CASE("10.3 each ray of a pack hits or misses independently", "[10.3]") {
    const Sphere sphere{{1, 2, 3}, 1};
    const OneRay meets{{{1, 2, -3}, {0, 0, 2}}, 1000, 4}, misses{{{4, 2, -3}, {0, 0, 2}}, 1000, 4};
    for (std::size_t k = 0; k < pack_size; ++k)
        for (const bool one_meets : {true, false}) {
            Rays rays;
            rays.fill(one_meets ? misses : meets);
            rays[k] = one_meets ? meets : misses;
            check_pack(sphere, 7, rays,
                       "each ray counts by itself: if one misses, the others must go on");
        }
}

TEST_CASE("10.3 distant spheres and grazing rays give the hits of hit_sphere", "[10.3][hard]") {
    rt::Rng rng{103, 4};
    for (int round = 0; round < 20'000; ++round) {
        const Real radius = any_size(rng, -6, 6);
        Sphere sphere{radius * any_size(rng, -1, 5) * any_direction(rng), radius};
        if (rng() % 2 == 0) sphere.center = {};
        Rays rays;
        for (OneRay& one : rays) {
            one.ray = any_ray(rng, sphere, 6);
            if (rng() % 8 == 0) one.t = 0;  // only a hit at the origin itself can count
            switch (rng() % 10) {
                case 0:  // it grazes, as far as numbers can
                    one.ray = {sphere.center + Vec3{-4 * radius, radius, 0}, {1, 0, 0}};
                    break;
                case 1:  // it starts on the surface, and only touches there: q is 0
                    one.ray = {sphere.center + Vec3{0, radius, 0}, {1, 0, real(-0.0)}};
                    break;
                case 2:  // it leads nowhere
                    one.ray.direction = {};
                    break;
                case 3:  // it starts in the middle
                    one.ray.origin = sphere.center;
                    break;
                case 4:  // it starts on the surface: one solution is 0, or nearly
                    one.ray = {sphere.center + Vec3{0, 0, radius}, any_direction(rng)};
                    break;
                case 5:  // it starts on the surface, straight in or out
                    one.ray = {sphere.center + Vec3{0, 0, radius},
                               {0, 0, rng() % 2 == 0 ? real(1) : real(-1)}};
                    break;
                default:
                    break;
            }
        }
        check_pack(sphere, 3, rays,
                   "if q is 0, both solutions are 0, and a t of 0 counts; a ray whose direction "
                   "has length 0 meets nothing");
    }
}

TEST_CASE("10.3 high sphere numbers are compared exactly", "[10.3][hard]") {
    rt::Rng rng{103, 6};
    for (const PackInteger number : {0, 1, 70'000, 16'777'217, 2'000'000'001})
        for (int round = 0; round < 300; ++round)
            check_ties(rng, number, number - 1, 3,
                       "compare the numbers as whole numbers: rays.sphere is a pack of them");
}

TEST_CASE("10.3 values in unused lanes do no harm", "[10.3][hard]") {
    rt::Rng rng{103, 5};
    const Real nothing = std::numeric_limits<Real>::quiet_NaN();
    for (int round = 0; round < 2000; ++round) {
        const Sphere sphere{5 * in_cube(rng), rng.uniform(Real(0.5), 3)};
        Rays rays;
        for (OneRay& one : rays) {
            one.ray = any_ray(rng, sphere, 1);
            if (rng() % 2 == 0) one = {{{nothing, 0, nothing}, {0, nothing, rt::infinity}}, 0, -1};
        }
        check_pack(sphere, 3, rays, "a ray that contains NaN meets nothing and disturbs no other");
    }
}
