#include <rt/lambertian.hpp>
#include <stdexcept>

#include "density.hpp"
#include "hemisphere.hpp"

using namespace checkpoint;
using rt::Color;
using rt::Hit;
using rt::Lambertian;

namespace {

const Lambertian clay{{real(0.75), real(0.5), real(0.25)}};

Hit hit_with(Vec3 normal, bool front) {
    return {2, Vec3{1, 2, 3} + normal, normal, front, rt::epsilon, 0};
}

// A direction in which a ray may arrive on this side.
Vec3 toward(const Hit& hit, rt::Rng& rng) {
    const Vec3 d = any_direction(rng);
    return (Grid::dot(d, hit.normal) <= 0) == hit.front ? d : -d;
}

rt::Scatter bounce(const Lambertian& material, Vec3 incoming, const Hit& hit, auto& random) {
    try {
        const std::optional<rt::Scatter> scattered = rt::scatter(material, incoming, hit, random);
        if (scattered) return *scattered;
    } catch (const std::domain_error&) {
        INFO("normal " << text(hit.normal) << ", hit from " << (hit.front ? "outside" : "inside"));
        FAIL(EXPECTED
             "a direction, actual: an attempt to normalize the zero vector.\nHint: the sum of the "
             "normal and a unit vector may be zero; cosine_direction (04.3) never returns zero");
    }
    FAIL(EXPECTED
         "a Scatter, actual: none.\nHint: a matte surface does not absorb whole paths at random: "
         "the attenuation already accounts for what it absorbs");
    return {};
}

// Gives two fixed numbers first, then random ones, and counts them.
struct Scripted {
    Vec2 place;
    int drawn = 0;
    rt::Rng rest{44, 9};

    Real uniform() {
        ++drawn;
        return drawn == 1 ? place.x : drawn == 2 ? place.y : rest.uniform();
    }
    Real uniform(Real low, Real high) { return low + (high - low) * uniform(); }
};

// What the core allows a length to be off, in epsilon: as much as the core of 04.3 does.
constexpr double off_in_core = 100;

// Returns the cosine with the normal on the side that the ray came from.
double check_direction(const Hit& hit, Vec3 d, double most_off = off_in_core) {
    const double cosine = Grid::dot(d, hit.normal) * (hit.front ? 1 : -1);
    const double off = length_error(d) / static_cast<double>(rt::epsilon);
    if (rt::is_finite(d) && off <= most_off && cosine > 0) return cosine;
    INFO("normal " << text(hit.normal) << ", hit from " << (hit.front ? "outside" : "inside")
                   << ": " EXPECTED "a direction of length 1 on that side, " ACTUAL << text(d)
                   << ", whose cosine with the normal there is " << cosine);
    {
        INFO("Hint: NaN comes from normalizing the zero vector by hand");
        REQUIRE(rt::is_finite(d));
    }
    {
        INFO("Hint: facing_normal(hit) is the normal on the side that the ray came from");
        REQUIRE(cosine > 0);
    }
    INFO("the direction's length differs from 1 by "
         << off << " epsilon, " EXPECTED "at most " << most_off
         << ".\nHint: does your cosine_direction (04.3) normalize its result?");
    REQUIRE(off <= most_off);
    return cosine;
}

// Counts the bounces of many surfaces, hit from one side, and compares with cos / pi.
void check_distribution(bool front, std::uint64_t stream) {
    rt::Rng rng{44, stream};
    std::vector<Grid> grids{Grid{{0, 0, 1}}, Grid{{0, -1, 0}}};
    while (grids.size() < 20) grids.emplace_back(any_direction(rng));
    for (int i = 0; i < samples; ++i) {
        Grid& grid = grids[static_cast<std::size_t>(i) % grids.size()];
        const Hit hit = hit_with(front ? grid.pole : -grid.pole, front);
        const Vec3 d = bounce(clay, toward(hit, rng), hit, rng).direction;
        check_direction(hit, d);
        grid.add(d, ring_of_angle);
    }
    std::vector<long> counts(turns * rings);
    for (const Grid& grid : grids)
        for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += grid.counts[i];
    const double statistic = chi_square(counts, expected_by_cosine());
    INFO("chi-square of a 20 x 10 grid of the hemisphere against cos / pi: "
         << statistic << ", " EXPECTED "less than " << chi_square_limit(turns * rings - 1)
         << ".\nHint: cosine_direction (04.3) turns random places in the unit square into "
            "directions distributed by their cosine: pass it random_place(random)");
    CHECK(statistic < chi_square_limit(turns * rings - 1));
}

}  // namespace

TEST_CASE("04.4 the attenuation is the albedo", "[04.4]") {
    rt::Rng rng{44, 1};
    for (int i = 0; i < 2000; ++i) {
        const auto channel = [&] {
            return i % 4 == 0 ? static_cast<Real>(rng() % 2) : rng.uniform();
        };
        const Lambertian material{{channel(), channel(), channel()}};
        const Hit hit = hit_with(any_direction(rng), rng() % 2 == 0);
        const Color attenuation = bounce(material, toward(hit, rng), hit, rng).attenuation;
        if (!(attenuation == material.albedo))
            UNSCOPED_INFO("albedo "
                          << material.albedo << ", attenuation " << attenuation
                          << ".\nHint: the attenuation is the albedo itself, in each channel: the "
                             "cosine and 1 / pi are in the density of the directions");
        REQUIRE(attenuation == material.albedo);
    }
}

TEST_CASE("04.4 light is scattered to the side that the ray came from", "[04.4]") {
    rt::Rng rng{44, 2};
    double lowest = 1;
    for (int i = 0; i < 20'000; ++i) {
        const Hit hit = hit_with(any_direction(rng), i % 2 == 0);
        const Vec3 d = bounce(clay, toward(hit, rng), hit, rng).direction;
        lowest = std::min(lowest, check_direction(hit, d));
    }
    CHECK(lowest > 0);
}

TEST_CASE("04.4 bounces off the outer side follow the cosine distribution", "[04.4]") {
    check_distribution(true, 3);
}

TEST_CASE("04.4 bounces off the inner side follow the cosine distribution", "[04.4]") {
    check_distribution(false, 4);
}

TEST_CASE("04.4 the bounce does not depend on the direction of the ray", "[04.4]") {
    rt::Rng rng{44, 5};
    for (int i = 0; i < 2000; ++i) {
        const Hit hit = hit_with(any_direction(rng), rng() % 2 == 0);
        rt::Rng one{44, 100}, other{44, 100};
        const Vec3 a = bounce(clay, toward(hit, rng), hit, one).direction;
        const Vec3 b = bounce(clay, toward(hit, rng), hit, other).direction;
        if (!(a == b))
            UNSCOPED_INFO("with the same random numbers two rays give "
                          << text(a) << " and " << text(b)
                          << ".\nHint: for a matte surface, the incoming direction does not "
                             "matter; draw all random numbers from `random`");
        REQUIRE(a == b);
    }
}

TEST_CASE("04.4 each bounce draws new random numbers", "[04.4]") {
    const Hit hit = hit_with({0, 0, 1}, true);
    rt::Rng rng{44, 6};
    // Around the pole, this bounce and the next one are independent.
    PairCounts pairs;
    const auto turn = [&] {
        const Vec3 d = bounce(clay, {0, 0, -1}, hit, rng).direction;
        return static_cast<Real>(std::atan2(static_cast<double>(d.y), static_cast<double>(d.x)) /
                                     6.283185307179586 +
                                 0.5);
    };
    PairCounts heights;
    const auto height = [&] {
        const Vec3 d = bounce(clay, {0, 0, -1}, hit, rng).direction;
        return 1 - d.z * d.z;
    };
    for (int i = 0; i < 50'000; ++i) {
        const Real first = turn(), second = turn();
        pairs.add(first, second);
        const Real low = height(), high = height();
        heights.add(low, high);
    }
    INFO("chi-square of one bounce against the next, around the normal: "
         << pairs.chi_square() << ", along it: " << heights.chi_square()
         << "; " EXPECTED "less than " << PairCounts::limit()
         << ".\nHint: draw a new place in every call: random_place(random)");
    CHECK(pairs.chi_square() < PairCounts::limit());
    CHECK(heights.chi_square() < PairCounts::limit());
}

TEST_CASE("04.4 equal parts of the square become directions with the density cos over pi",
          "[04.4]") {
    rt::Rng rng{44, 7};
    for (int i = 0; i < 4000; ++i) {
        Spot spot = any_spot(rng, i);
        const Vec2 place = spot.place;
        const Hit hit = hit_with(any_normal(rng, i / 4), rng() % 2 == 0);
        const Vec3 pole = hit.front ? hit.normal : -hit.normal;
        int most = 0;
        const auto direction = [&](Vec2 p) {
            Scripted random{p};
            const Vec3 d = bounce(clay, -pole, hit, random).direction;
            most = std::max(most, random.drawn);
            return d;
        };
        const double cosine = Grid::dot(direction(place), pole);
        const double computed = area_ratio(direction, place, spot.reach);
        if (most != 2) {
            SUCCEED("directions drawn in another way: the counts above test them");
            return;
        }
        const double expected = 3.14159265358979323846 / cosine;
        // Close to the horizon, and where normal and unit vector all but cancel, rounding counts.
        const Real z = 1 - 2 * place.x, radius = std::sqrt(1 - z * z), turn = 2 * rt::pi * place.y;
        const Vec3 unit{radius * std::cos(turn), radius * std::sin(turn), z};
        if (cosine < 0.2 || Grid::dot(unit, pole) < -0.5) continue;
        spot.allowed *= 1 + 0.1 / cosine;
        const double error = area_error(
            direction,
            [&](Vec2 p) { return 3.14159265358979323846 / Grid::dot(direction(p), pole); }, spot);
        if (!(error <= spot.allowed))
            UNSCOPED_INFO("normal "
                          << text(pole) << ": a small square of sample points around ("
                          << text(place.x) << ", " << text(place.y)
                          << ") becomes a patch of the sphere: " EXPECTED << expected
                          << " times as large, " ACTUAL << computed
                          << " times as large.\nHint: the density is cos / pi, like that of "
                             "cosine_direction (04.3)");
        REQUIRE(error <= spot.allowed);
    }
}

TEST_CASE("04.4 the bounce does not depend on the hit's position or distance", "[04.4]") {
    rt::Rng rng{44, 8};
    for (int i = 0; i < 1000; ++i) {
        Hit hit = hit_with(any_direction(rng), rng() % 2 == 0);
        const Vec3 incoming = toward(hit, rng);
        rt::Rng one{44, 200}, other{44, 200};
        const Vec3 a = bounce(clay, incoming, hit, one).direction;
        hit.point = any_size(rng, -9, 9) * any_direction(rng);
        hit.t = any_size(rng, -9, 9);
        hit.material = static_cast<int>(rng() % 100);
        hit.point_error = any_size(rng, -9, 0);
        const Vec3 b = bounce(clay, incoming, hit, other).direction;
        if (!(a == b))
            UNSCOPED_INFO(
                "the same surface at another position gives "
                << text(b) << " instead of " << text(a)
                << ".\nHint: the direction depends on the normal and the random numbers alone");
        REQUIRE(a == b);
    }
}

TEST_CASE("04.4 no random numbers lead to the zero vector", "[04.4][hard]") {
    rt::Rng rng{44, 10};
    double lowest = 1;
    const auto check = [&](Vec3 pole, Vec2 place) {
        const bool front = rng() % 2 == 0;
        const Hit hit = hit_with(front ? pole : -pole, front);
        Scripted random{place};
        const Vec3 d = bounce(clay, -pole, hit, random).direction;
        lowest = std::min(lowest, check_direction(hit, d, 2));
    };
    const auto check_all = [&](Vec3 pole) {
        for (const Vec2 place : corners) check(pole, place);
        for (const Vec2 place : edges) check(pole, place);
        // Where a uniform direction would be the opposite of the normal, or the normal itself; and
        // close to it.
        for (const Vec3 d : {-pole, pole}) {
            const Real x = std::clamp((1 - d.z) / 2, Real(0), largest);
            const Real turn = std::atan2(d.y, d.x) / (2 * rt::pi);
            const Real y = std::clamp(turn < 0 ? turn + 1 : turn, Real(0), largest);
            for (int i = 0; i < 20; ++i) {
                const Real away = i == 0 ? 0 : any_size(rng, for_this_precision(-8, -17), -2);
                const Real off_x = away * rng.uniform(-1, 1), off_y = away * rng.uniform(-1, 1);
                check(pole, {std::clamp(x + off_x, Real(0), largest),
                             std::clamp(y + off_y, Real(0), largest)});
            }
        }
    };
    for (const Real one : {Real(1), Real(-1)})
        for (const Vec3 axis : {Vec3{one, 0, 0}, Vec3{0, one, 0}, Vec3{0, 0, one}}) check_all(axis);
    for (int i = 0; i < 3000; ++i) check_all(any_normal(rng, i));
    CHECK(lowest > 0);
}
