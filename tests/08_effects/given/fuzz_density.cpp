// The density of rough metal: scatter() takes directions as often as it says.

#include <algorithm>
#include <array>
#include <cmath>
#include <rt/fuzz_density.hpp>
#include <rt/rng.hpp>

#include "checkpoint.hpp"

namespace {

using namespace rt;

Hit floor_hit() {
    Hit hit;
    hit.normal = {0, 1, 0};
    hit.front = true;
    return hit;
}
Vec3 arriving(Real sine) {
    return {sine, -std::sqrt((1 - sine) * (1 + sine)), 0};
}

}  // namespace

TEST_CASE("metal takes directions as often as its density says") {
    // Directions of the density p, weighted by u / (u + p), are as many in each cell as directions
    // of the even density u, weighted by p / (u + p). Neither weight exceeds 1.
    const Hit hit = floor_hit();
    constexpr double sphere = 4 * 3.14159265358979323846;
    constexpr int slices = 8, sectors = 8, draws = 200'000, tries = 1'000'000;
    const auto cell = [](Vec3 d) {
        const int slice = std::clamp(static_cast<int>(d.y * slices), 0, slices - 1);
        const double turn = 2 * std::atan2(static_cast<double>(d.z), static_cast<double>(d.x));
        const int sector = static_cast<int>((turn / (sphere / 2) + 1) / 2 * sectors);
        return static_cast<std::size_t>(slice * sectors + std::min(sector, sectors - 1));
    };
    struct Sum {
        double values = 0, squares = 0;
        void add(double value) {
            values += value;
            squares += value * value;
        }
    };
    // From above and grazing, where much is folded back.
    for (const Real sine : {Real(0), Real(0.6), Real(0.99)})
        for (const Real fuzz : {Real(0.2), Real(0.5), Real(1)}) {
            const Vec3 incoming = arriving(sine);
            const Metal metal{{1, 1, 1}, fuzz};
            std::array<Sum, slices * sectors + 1> actual{}, expected{};
            Rng random{8, 4};
            for (int i = 0; i < draws; ++i) {
                const Vec3 direction = scatter(metal, incoming, hit, random)->direction;
                const auto p =
                    static_cast<double>(scatter_density(metal, incoming, hit, direction));
                const double value = 1 / (1 + sphere * p);
                actual[cell(direction)].add(value / draws);
                actual.back().add(value / draws);
            }
            for (int i = 0; i < tries; ++i) {
                const Vec3 direction = uniform_direction(random_place(random));
                const auto p =
                    static_cast<double>(scatter_density(metal, incoming, hit, direction));
                const double value = sphere * p / (1 + sphere * p);
                expected[cell(direction)].add(value / tries);
                expected.back().add(value / tries);
            }
            for (std::size_t i = 0; i < actual.size(); ++i) {
                INFO("sine " << sine << ", fuzz " << fuzz << ", cell " << i
                             << ", of which the last is all: share by density "
                             << expected[i].values << ", by scatter " << actual[i].values);
                // Chance exceeds this once in 10^6 times; 3 of the draws may be alone in a cell.
                const double error = 5 * std::sqrt(actual[i].squares + expected[i].squares);
                CHECK(std::abs(actual[i].values - expected[i].values) <= error + 3.0 / draws);
            }
        }
}

TEST_CASE("every direction that metal takes has a density") {
    const Hit hit = floor_hit();
    Rng random{8, 5};
    for (const Real fuzz : {Real(0.2), Real(0.3), Real(1)})
        for (int i = 0; i < 20'000; ++i) {
            const Vec3 incoming = arriving(random.uniform());
            const Metal metal{{1, 1, 1}, fuzz};
            const Vec3 direction = scatter(metal, incoming, hit, random)->direction;
            const Real density = scatter_density(metal, incoming, hit, direction);
            if (density > 0 && std::isfinite(density)) continue;
            INFO("fuzz " << fuzz << ": the density is " << density);
            REQUIRE(density > 0);
            REQUIRE(std::isfinite(density));
        }
}

TEST_CASE("the density of metal in numbers") {
    const Hit hit = floor_hit();
    const auto density = [&](Real fuzz, Vec3 direction) {
        return scatter_density(Metal{{1, 1, 1}, fuzz}, {0, -1, 0}, hit, direction);
    };
    const auto is_near = [](Real a, Real b) { return std::abs(a - b) <= 64 * epsilon * b; };
    // Along the mirror direction: c is 1 and s is the fuzz.
    CHECK(is_near(density(Real(0.5), {0, 1, 0}), Real(1.25) / (2 * pi * Real(0.25))));
    // With fuzz 1 it is Lambert's density, cos / pi.
    CHECK(is_near(density(1, {Real(0.6), Real(0.8), 0}), Real(0.8) / pi));
    // Outside of the cone, and below the surface.
    CHECK(density(Real(0.5), {Real(0.8), Real(0.6), 0}) == 0);
    CHECK(density(1, {Real(0.6), Real(-0.8), 0}) == 0);
    // Of smoother metal.
    CHECK(density(0, {0, 1, 0}) == 0);
    CHECK(density(Real(0.1), {0, 1, 0}) == 0);
}
