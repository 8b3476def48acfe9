#include <rt/directions.hpp>

#include "checkpoint.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Vec2;

namespace {

constexpr int samples = 200'000;
constexpr int turns = 20, rings = 10;  // the grid: cells around the pole, rings from it

const Real largest = 1 - rt::epsilon / 2;  // the largest number that uniform() gives
const Vec2 corners[] = {{0, 0}, {largest, 0}, {0, largest}, {largest, largest}};
const Vec2 edges[] = {{0, real(0.25)},         {largest, real(0.7)}, {real(0.5), 0},
                      {real(0.5), largest},    {rt::epsilon / 2, 0}, {largest, real(0.125)},
                      {real(1e-20), real(0.3)}};

// How far the length is off 1.
double length_error(Vec3 v) {
    const Exact squared =
        Exact(v.x) * Exact(v.x) + Exact(v.y) * Exact(v.y) + Exact(v.z) * Exact(v.z);
    return std::abs((squared - Exact(1)).high / 2);  // sqrt(1 + x) is 1 + x / 2 for tiny x
}

// Directions on a hemisphere about `pole`, counted on a grid of equal angles. What the cells should
// hold: `share` of an angle is the share of directions within that angle from the pole.
struct Grid {
    Vec3 pole, x, y;
    double lowest_pole_cosine = 0;
    std::vector<long> counts = std::vector<long>(turns * rings);

    explicit Grid(Vec3 p) : pole{p} {
        // Any direction across the pole will do, and a third across both.
        const Vec3 helper = std::abs(p.x) < real(0.7) ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        x = across(helper, p);
        const Real size = std::sqrt(x.x * x.x + x.y * x.y + x.z * x.z);
        x /= size;
        y = across(p, x);
    }
    static Vec3 across(Vec3 a, Vec3 b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    static double dot(Vec3 a, Vec3 b) {
        return static_cast<double>(a.x * b.x + a.y * b.y + a.z * b.z);
    }

    // ring_of(cosine) in [0, rings)
    template <class RingOf>
    void add(Vec3 d, RingOf ring_of) {
        const double turn = std::atan2(dot(d, y), dot(d, x)) / (2 * 3.141592653589793) + 0.5;
        const int column = std::clamp(static_cast<int>(turn * turns), 0, turns - 1);
        const int row = std::clamp(static_cast<int>(ring_of(dot(d, pole))), 0, rings - 1);
        ++counts[static_cast<std::size_t>(row * turns + column)];
    }
};

// Rings of 9 degrees each.
double ring_of_angle(double cosine) {
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * rings / (3.141592653589793 / 2);
}

// How many of the samples a cell of each ring holds when the density is cos / pi: the integral of
// cos sin / pi over the cell.
std::vector<double> expected_by_cosine() {
    std::vector<double> expected;
    for (int ring = 0; ring < rings; ++ring) {
        const auto within = [](int r) {
            const double sine = std::sin(r * 3.141592653589793 / 2 / rings);
            return sine * sine;
        };
        const double share = within(ring + 1) - within(ring);
        expected.insert(expected.end(), turns, samples * share / turns);
    }
    return expected;
}

// Places in a small rectangle become directions in a small patch of the sphere. This is the patch's
// area divided by the rectangle's: the density of directions is 1 over it, whichever number of the
// place turns, and from where. The rectangle reaches `reach` of the way to the square's edges.
template <class Direction>
double area_ratio(const Direction& direction, Vec2 place, Real reach) {
    const Real h = reach * std::min(place.x, 1 - place.x),
               k = reach * std::min(place.y, 1 - place.y);
    const Vec3 along = direction({place.x + h, place.y}) - direction({place.x - h, place.y});
    const Vec3 other = direction({place.x, place.y + k}) - direction({place.x, place.y - k});
    const double rectangle = static_cast<double>((place.x + h) - (place.x - h)) *
                             static_cast<double>((place.y + k) - (place.y - k));
    const Vec3 patch = Grid::across(along, other);
    return std::sqrt(Grid::dot(patch, patch)) / rectangle;
}

// Any place of the square, or one close to an edge, with a reach and the error that it allows.
struct Spot {
    Vec2 place;
    Real reach;
    double allowed;
};
Spot any_spot(rt::Rng& rng, int i) {
    const auto inner = [&] { return rng.uniform(real(0.1), real(0.9)); };
    const auto outer = [&] {
        const Real x = any_size(rng, for_this_precision(-2, -9), -1);
        return rng() & 1 ? x : 1 - x;
    };
    const double coarse = for_this_precision(0.05, 1e-3), fine = for_this_precision(0.02, 1e-8);
    if (i % 4 == 0) return {{inner(), outer()}, for_this_precision(real(0.1), real(1e-3)), coarse};
    if (i % 4 == 1) return {{outer(), inner()}, for_this_precision(real(0.1), real(1e-3)), coarse};
    return {{inner(), inner()}, for_this_precision(real(0.05), real(1e-5)), fine};
}

// Any normal, or an axis or a diagonal, or one close to these.
Vec3 any_normal(rt::Rng& rng, int i) {
    const Vec3 any = any_direction(rng);
    if (i % 2) return any;
    const auto sign = [&] { return rng() & 1 ? Real(1) : Real(-1); };
    Vec3 special{sign(), sign(), sign()};
    if (i % 4) {
        const unsigned axis = rng() % 3;
        special = {axis == 0 ? special.x : 0, axis == 1 ? special.y : 0, axis == 2 ? special.z : 0};
    }
    const Vec3 v = special + (rng() % 4 ? any_size(rng, -9, -1) : 0) * any;
    return v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

void check_area_ratio(Vec2 place, double expected, double computed, double allowed,
                      const char* hint) {
    const double error_over_allowed = std::abs(computed / expected - 1) / allowed;
    if (error_over_allowed <= 1) return;
    INFO("a small square of places around ("
         << text(place.x) << ", " << text(place.y)
         << ") becomes a patch of the sphere that should be " << text(static_cast<Real>(expected))
         << " times as large; yours is " << text(static_cast<Real>(computed))
         << " times as large.\nHint: " << hint);
    REQUIRE(error_over_allowed <= 1);
}

}  // namespace

TEST_CASE("04.3 uniform directions cover the sphere evenly", "[04.3]") {
    rt::Rng rng{43, 1};
    Grid grid{{0, 0, 1}};
    double worst = 0;
    for (int i = 0; i < samples; ++i) {
        const Vec3 d = rt::uniform_direction(rt::random_place(rng));
        worst = std::max(worst, length_error(d) / static_cast<double>(rt::epsilon));
        // Slices of equal height have equal surface.
        grid.add(d, [](double cosine) { return (1 - cosine) / 2 * rings; });
    }
    {
        INFO("lengths are off 1 by up to " << worst << " epsilon, expected are 2 at most");
        CHECK(worst <= 2);
    }
    const double statistic = chi_square(
        grid.counts,
        std::vector<double>(turns * rings, static_cast<double>(samples) / turns / rings));
    INFO("chi-square of 200 cells of equal surface: "
         << statistic
         << ".\nHint: z is spread evenly from -1 to 1, the angle about the z axis from 0 to 2 pi; "
            "angles from the pole that are spread evenly crowd the poles");
    CHECK(statistic < chi_square_limit(turns * rings - 1));
}

TEST_CASE("04.3 bounces follow the cosine about any normal", "[04.3]") {
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
        INFO(below << " of " << samples << " directions point below the surface.\nHint: "
                   << (below == samples
                           ? "they are upside down: the height is +sqrt(1 - x), along the normal"
                           : "x, y and z of the hemisphere are those of the normal's basis: "
                             "orthonormal_basis(normal).to_world({...}) turns them"));
        REQUIRE(below == 0);
    }
    {
        INFO("lengths are off 1 by up to " << worst << " epsilon, expected are 2 at most");
        CHECK(worst <= 2);
    }
    const double statistic = chi_square(counts, expected_by_cosine());
    // The hint depends on the three inner rings: the share sin^2 lies within an angle.
    long close = 0;
    for (std::size_t i = 0; i < 3 * turns; ++i) close += counts[i];
    const double sine = std::sin(3 * 3.141592653589793 / 2 / rings);
    const double expected = samples * sine * sine, noise = 5 * std::sqrt(expected);
    const double surplus = static_cast<double>(close) - expected;
    const char* hint =
        surplus > noise
            ? "too many along the normal: the radius on the disk is the square ROOT of x, since x "
              "itself crowds the middle of the disk"
        : surplus < -noise
            ? "too few along the normal: evenly spread directions, also when those below are "
              "flipped up, do not follow the cosine. Radius sqrt(x), height sqrt(1 - x)"
            : "as many along the normal as there should be, but not evenly around it, or not near "
              "the horizon: the angle goes once around, 2 pi y; the height is sqrt(1 - x)";
    INFO("chi-square of a 20 x 10 grid of the hemisphere against cos / pi: "
         << statistic << "; within 27 degrees of the normal are " << close << " directions of "
         << samples << ", expected " << expected << ".\nHint: " << hint);
    CHECK(statistic < chi_square_limit(turns * rings - 1));
}

TEST_CASE("04.3 equal parts of the square become equally likely directions", "[04.3]") {
    rt::Rng rng{43, 3};
    const double pi = 3.14159265358979323846;
    for (int i = 0; i < 2000; ++i) {
        const auto [place, reach, allowed] = any_spot(rng, i);
        check_area_ratio(place, 4 * pi, area_ratio(rt::uniform_direction, place, reach), allowed,
                         "uniform_direction turns once around, by 2 pi y, neither more nor less, "
                         "and z goes evenly from one pole to the other: the whole square becomes "
                         "the whole sphere, whose area is 4 pi");
    }
    for (int i = 0; i < 2000; ++i) {
        const auto [place, reach, allowed] = any_spot(rng, i);
        const Vec3 normal = any_normal(rng, i / 4);
        const auto bounce = [&](Vec2 p) { return rt::cosine_direction(normal, p); };
        const double expected = pi / Grid::dot(bounce(place), normal);
        const double computed = area_ratio(bounce, place, reach);
        // Close to the horizon the cosine, too, is rounded.
        const double rounded = static_cast<double>(rt::epsilon) * expected;
        INFO("normal " << text(normal));
        check_area_ratio(place, expected, computed, allowed + 100 * rounded,
                         "cosine_direction turns once around, by 2 pi y, the height is sqrt(1 - x) "
                         "and the distance from the normal sqrt(x): the density is cos / pi");
    }
}

TEST_CASE("04.3 the corners of the square give directions too", "[04.3][hard]") {
    const auto check = [](Vec2 place) {
        const Vec3 d = rt::uniform_direction(place);
        INFO("place (" << text(place.x) << ", " << text(place.y) << ") gives " << text(d));
        REQUIRE(rt::is_finite(d));
        const double off_in_epsilons = length_error(d) / static_cast<double>(rt::epsilon);
        INFO("its length is off 1 by so many epsilon; 2 are allowed");
        REQUIRE(off_in_epsilons <= 2);
    };
    for (const Vec2 place : corners) check(place);
    for (const Vec2 place : edges) check(place);
    // Close to a pole, whichever axis that is on, and whichever number of the place leads there.
    rt::Rng rng{43, 5};
    for (int i = 0; i < 2000; ++i) {
        // A multiple of epsilon, as random numbers are.
        const Real step =
            std::max(Real(1), std::round(any_size(rng, 0, for_this_precision(5, 14))));
        const Real x = i % 2 ? step * rt::epsilon : 1 - step * rt::epsilon;
        const Real y = rng.uniform(real(0.1), real(0.4));
        const Vec2 place = i % 4 < 2 ? Vec2{x, y} : Vec2{y, x};
        const Vec3 d = rt::uniform_direction(place), a = rt::abs(d);
        const Real height = std::max({a.x, a.y, a.z});
        if (height < real(0.999)) continue;
        const auto from_axis = static_cast<double>(height == a.x   ? std::hypot(a.y, a.z)
                                                   : height == a.y ? std::hypot(a.x, a.z)
                                                                   : std::hypot(a.x, a.y));
        const double expected = static_cast<double>(2 * std::sqrt(x * (1 - x)));
        const double off_in_epsilons =
            std::abs(from_axis / expected - 1) / static_cast<double>(rt::epsilon);
        if (off_in_epsilons <= 8) continue;
        INFO("place (" << text(place.x) << ", " << text(place.y) << ") gives " << text(d));
        HINT(static_cast<Real>(expected), static_cast<Real>(from_axis),
             "this is the distance from the axis. Near the poles 1 - z^2 cancels; (1 - z) (1 + z) "
             "does not, and neither does 4 x (1 - x)");
        REQUIRE(off_in_epsilons <= 8);
    }
}

TEST_CASE("04.3 bounces stay above the surface at any normal", "[04.3][hard]") {
    rt::Rng rng{43, 4};
    const auto check = [](Vec3 normal, Vec2 place) {
        const auto direction = [&] {
            INFO("normal " << text(normal) << ", place (" << text(place.x) << ", " << text(place.y)
                           << ").\nHint: normal plus uniform direction may be the zero vector, "
                              "which cannot be normalized; the lifted disk has no such place");
            return rt::cosine_direction(normal, place);
        };
        const Vec3 d = direction();
        const double in_epsilons = length_error(d) / static_cast<double>(rt::epsilon);
        if (rt::is_finite(d) && in_epsilons <= 2 &&
            d.x * normal.x + d.y * normal.y + d.z * normal.z > 0)
            return;
        INFO("normal " << text(normal) << ", place (" << text(place.x) << ", " << text(place.y)
                       << ") gives " << text(d));
        REQUIRE(rt::is_finite(d));
        {
            INFO("its length is off 1 by " << length_error(d)
                                           << ".\nHint: normalize the result, since the basis is "
                                              "exact to 8 epsilon only");
            REQUIRE(in_epsilons <= 2);
        }
        INFO("Hint: even at the rim of the disk the height is sqrt(1 - x) > 0");
        REQUIRE(d.x * normal.x + d.y * normal.y + d.z * normal.z > 0);
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
