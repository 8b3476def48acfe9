#include <rt/directions.hpp>

#include "hemisphere.hpp"

using namespace checkpoint;

TEST_CASE("04.3 bounces follow the cosine distribution around any normal", "[04.3]") {
    rt::Rng rng{43, 2};
    std::vector<Grid> grids{Grid{{0, 0, 1}}, Grid{{0, 0, -1}}};
    while (grids.size() < 20) grids.emplace_back(any_direction(rng));
    std::vector<long> counts(turns * rings);
    double worst = 0;
    long below = 0;
    for (int i = 0; i < samples; ++i) {
        Grid& grid = grids[static_cast<std::size_t>(i) % grids.size()];
        const Vec3 d = rt::cosine_direction(grid.pole, rt::random_place(rng));
        worst = std::max(worst, length_error(d) / static_cast<double>(rt::epsilon));
        below += !(Grid::dot(d, grid.pole) > 0);
        grid.add(d, ring_of_angle);
    }
    for (const Grid& grid : grids)
        for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += grid.counts[i];
    {
        INFO(below
             << " of " << samples << " directions point below the surface.\nHint: "
             << (below == samples
                     ? "the directions are upside down: the height along the normal is +sqrt(1 - x)"
                     : "x, y and z are components in the normal's basis: turn the direction with "
                       "orthonormal_basis(normal).to_world({a, b, height}): the normal is the "
                       "basis's third axis"));
        REQUIRE(below == 0);
    }
    {
        INFO("lengths differ from 1 by up to " << worst << " epsilon, " EXPECTED "at most 100");
        CHECK(worst <= 100);
    }
    const double statistic = chi_square(counts, expected_by_cosine());
    // The hint depends on the three inner rings: a share of sin^2 lies within an angle.
    long close = 0;
    for (std::size_t i = 0; i < 3 * turns; ++i) close += counts[i];
    const double sine = std::sin(3 * 3.141592653589793 / 2 / rings);
    const double expected = samples * sine * sine, noise = 5 * std::sqrt(expected);
    const double surplus = static_cast<double>(close) - expected;
    const char* hint =
        surplus > noise
            ? "too many directions are close to the normal: the radius on the disk is the square "
              "root of x; with x itself, points crowd in the middle of the disk"
        : surplus < -noise ? "too few directions are close to the normal: evenly spread directions "
                             "do not follow the cosine, even if those below are flipped up. Take "
                             "the radius sqrt(x) and the height sqrt(1 - x)"
                           : "the right number of directions is close to the normal, but they are "
                             "not spread evenly around it, or are wrong near the horizon: the "
                             "angle goes once around, 2 pi y; the height is sqrt(1 - x)";
    INFO("chi-square of a 20 x 10 grid of the hemisphere against cos / pi: "
         << statistic << "; within 27 degrees of the normal: actual " << close << " directions of "
         << samples << ", " EXPECTED << expected << ".\nHint: " << hint);
    CHECK(statistic < chi_square_limit(turns * rings - 1));
}

TEST_CASE("04.3 equal parts of the square become equally likely directions", "[04.3]") {
    rt::Rng rng{43, 3};
    const double pi = 3.14159265358979323846;
    for (int i = 0; i < 2000; ++i) {
        Spot spot = any_spot(rng, i);
        const Vec3 normal = any_normal(rng, i / 4);
        const auto bounce = [&](Vec2 p) { return rt::cosine_direction(normal, p); };
        const auto expected = [&](Vec2 p) { return pi / Grid::dot(bounce(p), normal); };
        // Close to the horizon the cosine, too, is rounded.
        spot.allowed += 100 * static_cast<double>(rt::epsilon) * expected(spot.place);
        INFO("normal " << text(normal));
        check_area_ratio(bounce, expected, spot,
                         "cosine_direction turns once around, by 2 pi y, the height is sqrt(1 - x) "
                         "and the distance from the normal sqrt(x): the density is cos / pi");
    }
}

TEST_CASE("04.3 bounces stay above the surface at any normal", "[04.3][hard]") {
    rt::Rng rng{43, 4};
    const auto check = [](Vec3 normal, Vec2 place) {
        const auto direction = [&] {
            INFO("normal " << text(normal) << ", place (" << text(place.x) << ", " << text(place.y)
                           << ").\nHint: normal plus uniform direction may be the zero vector, "
                              "which cannot be normalized; a point lifted from the disk never is");
            return rt::cosine_direction(normal, place);
        };
        const Vec3 d = direction();
        const double in_epsilons = length_error(d) / static_cast<double>(rt::epsilon);
        const bool is_right = rt::is_finite(d) && in_epsilons <= 2 &&
                              d.x * normal.x + d.y * normal.y + d.z * normal.z > 0;
        if (!is_right) {
            INFO("normal " << text(normal) << ", place (" << text(place.x) << ", " << text(place.y)
                           << ") gives " << text(d));
            REQUIRE(rt::is_finite(d));
            {
                INFO("the direction's length differs from 1 by "
                     << length_error(d)
                     << ".\nHint: normalize the result, since the "
                        "basis is accurate only to 8 epsilon");
                REQUIRE(in_epsilons <= 2);
            }
            INFO("Hint: even at the rim of the disk the height is sqrt(1 - x) > 0");
            REQUIRE(d.x * normal.x + d.y * normal.y + d.z * normal.z > 0);
        }
        REQUIRE(is_right);
    };
    for (int i = 0; i < 5000; ++i) {
        const Vec3 normal = any_direction(rng);
        for (const Vec2 place : corners) check(normal, place);
        for (const Vec2 place : edges) check(normal, place);
    }
    // Slanted normals whose bases are off by so much that it shows, one for each precision.
    check({real(-0.14009469946652822), real(-0.98497574208741823), real(-0.10097654520096865)},
          {real(0.71968524830426461), real(0.77553540705329527)});
    check({real(0.20083893835544586), real(0.97961544990539551), real(0.004179464653134346)},
          {real(0.58166730403900146), real(0.74020284414291382)});
    for (const Real one : {Real(1), Real(-1)})
        for (const Real zero : {Real(0), -Real(0)})
            for (const Vec2 place : corners) {
                check({one, zero, zero}, place);
                check({zero, one, zero}, place);
                check({zero, zero, one}, place);
            }
}
