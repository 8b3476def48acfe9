#include <functional>
#include <rt/microfacets.hpp>
#include <rt/rng.hpp>
#include <rt/vec3.hpp>
#include <statistics.hpp>
#include <vector>

#include "checkpoint.hpp"

using namespace checkpoint;
using rt::Color;
using rt::Vec2;

namespace {

constexpr double pi = 3.14159265358979323846;

// The formulas of the text, in double and with exact sines.
double sine_squared(Vec3 v) {
    return static_cast<double>(v.x) * static_cast<double>(v.x) +
           static_cast<double>(v.y) * static_cast<double>(v.y);
}
double d_of(Vec3 facet, double alpha) {
    const double z = static_cast<double>(facet.z);
    const double root = sine_squared(facet) / (alpha * alpha) + z * z;
    return 1 / (pi * alpha * alpha * root * root);
}
double masked(Vec3 v, double alpha) {
    const double z = static_cast<double>(v.z);
    return (std::sqrt(1 + alpha * alpha * sine_squared(v) / (z * z)) - 1) / 2;
}
double share_of(Vec3 out, Vec3 in, double alpha) {
    const double o = masked(out, alpha), i = masked(in, alpha);
    return (1 + o) / (1 + o + i);
}
Vec3 halfway(Vec3 a, Vec3 b) {
    return rt::normalize(a + b);
}
double density_of(Vec3 out, Vec3 in, double alpha) {
    return d_of(halfway(out, in), alpha) / (1 + masked(out, alpha)) /
           (4 * static_cast<double>(out.z));
}

// A direction at this cosine to the normal, turned by a fraction of a full turn.
Vec3 at(Real cosine, Real turn) {
    const Real sine = std::sqrt((1 - cosine) * (1 + cosine));
    const auto angle = static_cast<double>(turn) * 2 * pi;
    return {sine * real(std::cos(angle)), sine * real(std::sin(angle)), cosine};
}

Vec3 mirrored(Vec3 out, Vec3 facet) {
    return 2 * rt::dot(out, facet) * facet - out;
}

std::string words(Vec3 out, Real alpha) {
    return "the roughness " + text(alpha) + ", seen from " + text(out);
}

// The message before it says what was computed and expected: Catch2 shows few digits.
void check_near(double computed, double expected, double relative) {
    const bool is_near = std::abs(computed - expected) <= relative * std::abs(expected);
    CHECK(is_near);
}

const Real usual_alphas[] = {1, real(0.5), real(0.2)};
const Real usual_cosines[] = {1, real(0.8), real(0.4), real(0.15)};

// Directions in cells of equal solid angle: heights from the top down by turns. The last cell is
// for those below the surface.
constexpr int rings = 10, turns = 16;
std::size_t cell_of(Vec3 v) {
    if (!(v.z > 0)) return rings * turns;
    const double turn = std::atan2(static_cast<double>(v.y), static_cast<double>(v.x)) / (2 * pi);
    const int column = std::clamp(static_cast<int>((turn + 0.5) * turns), 0, turns - 1);
    const int row = rings - 1 - std::clamp(static_cast<int>(v.z * rings), 0, rings - 1);
    return static_cast<std::size_t>(row * turns + column);
}

// The integral of a density over each cell, and what is left to 1.
std::vector<double> integrals(const std::function<double(Vec3)>& density) {
    constexpr int steps = 24;
    std::vector<double> of_cell(rings * turns + 1);
    double rest = 1;
    for (int row = 0; row < rings * steps; ++row)
        for (int column = 0; column < turns * steps; ++column) {
            const double z = 1 - (row + 0.5) / (rings * steps),
                         angle = ((column + 0.5) / (turns * steps) - 0.5) * 2 * pi,
                         sine = std::sqrt(1 - z * z);
            const Vec3 v{real(sine * std::cos(angle)), real(sine * std::sin(angle)), real(z)};
            const double part = density(v) * 2 * pi / (rings * steps * turns * steps);
            of_cell[static_cast<std::size_t>(row / steps * turns + column / steps)] += part;
            rest -= part;
        }
    of_cell.back() = std::max(0.0, rest);
    return of_cell;
}

constexpr int samples = 100'000;

// Compares samples with the expected share of each cell. Cells that expect few samples are one.
void check_counts(const std::vector<long>& counts, const std::vector<double>& shares,
                  const char* hint) {
    Cells cells;
    std::vector<double> expected;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        expected.push_back(shares[i] * samples);
        cells.add(counts[i], expected[i]);
    }
    INFO(pictured(counts, expected, turns));
    auto& [seen, wanted] = cells;
    // The integrals are sums, and a little off.
    wanted[0] += 5;
    const double found = chi_square(seen, wanted),
                 limit = chi_square_limit(static_cast<int>(seen.size())) * 1.1;
    INFO("of " << samples << " samples, counted in " << seen.size()
               << " cells: a chi-square of at most " << limit << " is " EXPECTED << "; " ACTUAL
               << found << ".\nHint: " << hint);
    CHECK(found < limit);
}

// The integral of D cos over the hemisphere is the surface's own area, 1.
double projected_area(Real alpha) {
    double sum = 0;
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) {
        const double z = (i + 0.5) / steps;
        const Vec3 facet{real(std::sqrt(1 - z * z)), 0, real(z)};
        sum += static_cast<double>(rt::facet_density(facet, alpha)) * z * 2 * pi / steps;
    }
    return sum;
}

}  // namespace

TEST_CASE("14.4 facets face in the directions that GGX says", "[14.4]") {
    {
        const Real head_on = rt::facet_density({0, 0, 1}, real(0.5));
        HINT(real(4 / pi), head_on, "for a level facet it is 1 / (pi alpha^2)");
        check_near(static_cast<double>(head_on), 4 / pi, 1e-5);
    }
    for (const Real alpha : usual_alphas)
        for (const Real cosine : {Real(1), real(0.9), real(0.6), real(0.1)}) {
            const Vec3 facet = at(cosine, real(0.3));
            const double expected = d_of(facet, static_cast<double>(alpha));
            const Real computed = rt::facet_density(facet, alpha);
            INFO("facet_density for " << text(facet) << " and the roughness " << text(alpha));
            HINT(real(expected), computed,
                 "alpha^2 / (pi (z^2 (alpha^2 - 1) + 1)^2): the whole bracket is squared");
            check_near(static_cast<double>(computed), expected, for_this_precision(1e-3, 1e-12));
        }
}

TEST_CASE("14.4 no facet faces downward", "[14.4]") {
    for (const Vec3 facet : {at(real(-0.5), 0), Vec3{0, 0, -1}, Vec3{1, 0, 0}}) {
        const Real computed = rt::facet_density(facet, real(0.5));
        HINT(Real(0), computed, "below the surface there are no facets");
        CHECK(computed == 0);
    }
}

TEST_CASE("14.4 seen from above the facets cover the surface once", "[14.4]") {
    for (const Real alpha : usual_alphas) {
        const double area = projected_area(alpha);
        INFO("the integral of facet_density times the cosine, for the roughness " << text(alpha));
        HINT(Real(1), real(area), "a factor is missing or too much, such as pi or alpha^2");
        CHECK(std::abs(area - 1) < 1e-3);
    }
}

TEST_CASE("14.4 a drawn facet has length 1 and is seen from out", "[14.4]") {
    rt::Rng rng{144, 1};
    for (const Real alpha : usual_alphas)
        for (const Real cosine : usual_cosines)
            for (int i = 0; i < 200; ++i) {
                const Vec3 out = at(cosine, rng.uniform());
                const Vec2 place{rng.uniform(), real(0.999) * rng.uniform()};
                const Vec3 facet = rt::visible_facet(out, alpha, place);
                const Real length = rt::length(facet);
                INFO(words(out, alpha) << ", place " << text(place.x) << ", " << text(place.y)
                                       << ": the facet " << text(facet));
                {
                    INFO("Hint: normalize the facet, after it was pressed back");
                    REQUIRE(std::abs(length - 1) <= 5 * rt::epsilon);
                }
                {
                    INFO("Hint: a facet's normal is above the surface");
                    REQUIRE(facet.z >= 0);
                }
                INFO("Hint: a facet that faces away from `out` cannot be seen");
                REQUIRE(rt::dot(facet, out) > 0);
            }
}

TEST_CASE("14.4 a facet is drawn as often as it is seen", "[14.4]") {
    rt::Rng rng{144, 2};
    for (const Real alpha : {Real(1), real(0.4)})
        for (const Real cosine : usual_cosines) {
            const Vec3 out = at(cosine, real(0.1));
            std::vector<long> counts(rings * turns + 1);
            for (int i = 0; i < samples; ++i)
                ++counts[cell_of(rt::visible_facet(out, alpha, {rng.uniform(), rng.uniform()}))];
            const auto a = static_cast<double>(alpha);
            INFO(words(out, alpha));
            check_counts(counts, integrals([&](Vec3 facet) {
                             const double seen =
                                 std::max(0.0, static_cast<double>(rt::dot(facet, out)));
                             return seen * d_of(facet, a) / (1 + masked(out, a)) /
                                    static_cast<double>(out.z);
                         }),
                         "three steps: press `out` and normalize it; add a point of the cap above "
                         "-from.z; press the sum in the same way and normalize it");
        }
}

TEST_CASE("14.4 facets hide what is behind them", "[14.4]") {
    rt::Rng rng{144, 3};
    for (const Real alpha : usual_alphas)
        for (const Real cosine : usual_cosines)
            for (const Real other : usual_cosines) {
                const Vec3 out = at(cosine, rng.uniform()), in = at(other, rng.uniform());
                const double expected = share_of(out, in, static_cast<double>(alpha));
                const Real computed = rt::unshadowed(out, in, alpha);
                INFO("unshadowed for " << words(out, alpha) << ", lit from " << text(in));
                HINT(real(expected), computed,
                     "G2 / G1 = (1 + L(out)) / (1 + L(out) + L(in)), with L = (sqrt(1 + alpha^2 "
                     "tan^2) - 1) / 2; of out's shadow only what in has as well is counted twice");
                check_near(static_cast<double>(computed), expected,
                           for_this_precision(1e-4, 1e-12));
            }
}

TEST_CASE("14.4 the density says how often a reflected direction is drawn", "[14.4]") {
    rt::Rng rng{144, 4};
    for (const Real alpha : {Real(1), real(0.4)})
        for (const Real cosine : usual_cosines) {
            const Vec3 out = at(cosine, real(0.6));
            std::vector<long> counts(rings * turns + 1);
            for (int i = 0; i < samples; ++i) {
                const Vec2 place{rng.uniform(), rng.uniform()};
                ++counts[cell_of(mirrored(out, rt::visible_facet(out, alpha, place)))];
            }
            INFO(words(out, alpha));
            check_counts(counts, integrals([&](Vec3 in) {
                             return static_cast<double>(rt::reflection_density(out, in, alpha));
                         }),
                         "the density of a facet is G1 D (out . facet) / out.z; that of the "
                         "direction is 1 / (4 (out . facet)) times as large");
        }
}

TEST_CASE("14.4 the density of a direction is that of its facet over 4 cosines", "[14.4]") {
    rt::Rng rng{144, 5};
    for (const Real alpha : usual_alphas)
        for (const Real cosine : usual_cosines) {
            const Vec3 out = at(cosine, rng.uniform()), in = at(rng.uniform(real(0.1), 1), 0);
            const double expected = density_of(out, in, static_cast<double>(alpha));
            const Real computed = rt::reflection_density(out, in, alpha);
            INFO("reflection_density for " << words(out, alpha) << ", lit from " << text(in));
            HINT(real(expected), computed,
                 "G1 D / (4 out.z), where D is that of the facet halfway between out and in");
            check_near(static_cast<double>(computed), expected, for_this_precision(5e-5, 1e-13));
        }
    for (const Real below : {real(-0.1), Real(-1)}) {
        const Real computed = rt::reflection_density(at(real(0.5), 0), at(below, 0), 1);
        INFO("for a direction below the surface");
        HINT(Real(0), computed, "no light leaves into the surface");
        CHECK(computed == 0);
    }
}

TEST_CASE("14.4 the light from one direction to another is the same both ways", "[14.4]") {
    rt::Rng rng{144, 6};
    for (int i = 0; i < 200; ++i) {
        const Real alpha = rng.uniform(real(0.2), 1);
        const Vec3 out = at(rng.uniform(real(0.1), 1), rng.uniform()),
                   in = at(rng.uniform(real(0.1), 1), rng.uniform());
        const auto reflected = [&](Vec3 to, Vec3 from) {
            return static_cast<double>(rt::reflection_density(to, from, alpha)) *
                   static_cast<double>(rt::unshadowed(to, from, alpha) / from.z);
        };
        const double one = reflected(out, in), other = reflected(in, out);
        INFO("density times unshadowed over in.z, for " << words(out, alpha) << ", lit from "
                                                        << text(in));
        HINT(real(other), real(one),
             "with out and in exchanged it must be the same: Helmholtz reciprocity");
        check_near(one, other, for_this_precision(5e-5, 1e-13));
    }
}

TEST_CASE("14.4 metal reflects its color head-on and all light at a grazing angle", "[14.4]") {
    const Color gold{1, real(0.75), real(0.25)};
    const auto check = [&](Real cosine, Color expected, const char* hint) {
        const Color computed = rt::metal_reflectance(gold, cosine);
        const Vec3 wanted{expected.r, expected.g, expected.b},
            found{computed.r, computed.g, computed.b};
        INFO("metal_reflectance of (1, 0.75, 0.25) at the cosine " << text(cosine));
        INFO(EXPECTED << text(wanted) << ", " ACTUAL << text(found) << ".\nHint: " << hint);
        const bool is_near = rt::length(wanted - found) <= 10 * rt::epsilon;
        CHECK(is_near);
    };
    check(1, gold, "head-on, it is the metal's color");
    check(0, {1, 1, 1}, "at a grazing angle, any surface is white");
    check(real(0.3),
          {1, real(0.75 + 0.25 * std::pow(0.7, 5)), real(0.25 + 0.75 * std::pow(0.7, 5))},
          "color + (1 - color) (1 - cosine)^5");
    check(real(0.5), {1, real(0.75 + 0.25 / 32), real(0.25 + 0.75 / 32)},
          "color + (1 - color) (1 - cosine)^5");
}

TEST_CASE("14.4 a single bounce in a white furnace loses light", "[14.4]") {
    rt::Rng rng{144, 7};
    // Known shares: sums over a million facets, by the formulas of the text.
    const struct {
        Real alpha, cosine;
        double kept;
    } known[] = {
        {1, 1, 0.30685}, {1, real(0.4), 0.49890}, {real(0.5), 1, 0.68785}, {real(0.2), 1, 0.94766}};
    for (const auto& [alpha, cosine, kept] : known) {
        const Vec3 out = at(cosine, 0);
        Mean mean;
        for (int i = 0; i < 40'000; ++i) {
            const Vec3 in =
                mirrored(out, rt::visible_facet(out, alpha, {rng.uniform(), rng.uniform()}));
            mean.add(in.z > 0 ? static_cast<double>(rt::unshadowed(out, in, alpha)) : 0);
        }
        INFO("the share of the light that comes back, for " << words(out, alpha));
        HINT(real(kept), real(mean.mean()),
             "light that meets a second facet is lost: the weight of a direction is unshadowed, "
             "and 0 below the surface");
        CHECK(std::abs(mean.mean() - kept) < 5 * mean.standard_error() + 5e-4);
    }
}

TEST_CASE("14.4 light that nothing hides needs no compensation", "[14.4]") {
    for (const Color color : {Color{1, 1, 1}, Color{1, real(0.5), 0}}) {
        const Color factor = rt::compensation(color, 1);
        INFO("compensation(color, 1): " EXPECTED "1 for each channel, " ACTUAL << factor);
        CHECK(factor == Color{1, 1, 1});
    }
    for (const Real kept : {real(0.3), real(0.9)}) {
        const Color factor = rt::compensation({1, real(0.5), 0}, kept);
        INFO("compensation may add light, and never takes any away: " ACTUAL << factor);
        CHECK((factor.r >= 1 && factor.g >= 1 && factor.b >= 1));
    }
}

TEST_CASE("14.4 with the star a white furnace stays white", "[14.4][hard]") {
    for (const Real kept : {real(0.3), real(0.75), real(0.999)}) {
        const Color factor = rt::compensation({1, real(0.5), 0}, kept);
        INFO("compensation for the color (1, 0.5, 0), if " << text(kept) << " is kept");
        {
            HINT(1 / kept, factor.r, "white metal: kept times the factor is 1");
            check_near(static_cast<double>(factor.r), 1 / static_cast<double>(kept), 1e-6);
        }
        {
            HINT((1 + 1 / kept) / 2, factor.g,
                 "each further bounce costs the metal's color once more: color (1 - kept) / kept");
            check_near(static_cast<double>(factor.g), (1 + 1 / static_cast<double>(kept)) / 2,
                       1e-6);
        }
        HINT(Real(1), factor.b, "a black metal reflects nothing, and gains nothing");
        CHECK(factor.b == 1);
    }
}

TEST_CASE("14.4 facets of smooth metal have all their digits", "[14.4][hard]") {
    rt::Rng rng{144, 8};
    for (int i = 0; i < 2000; ++i) {
        const Real alpha = any_size(rng, -4, 0), slope = alpha * any_size(rng, -2, 2);
        const Vec3 facet = rt::normalize(Vec3{slope, slope * rng.uniform(-1, 1), 1});
        const double expected = d_of(facet, static_cast<double>(alpha));
        const Real computed = rt::facet_density(facet, alpha);
        INFO("facet_density for " << text(facet) << " and the roughness " << text(alpha));
        HINT(real(expected), computed,
             "z^2 (alpha^2 - 1) + 1 has no digits left where z is nearly 1: it is x^2 + y^2 + "
             "alpha^2 z^2");
        check_near(static_cast<double>(computed), expected, 30 * static_cast<double>(rt::epsilon));
    }
}

TEST_CASE("14.4 nothing overflows at grazing angles", "[14.4][hard]") {
    rt::Rng rng{144, 9};
    const Real last = 1 - rt::epsilon / 2;
    for (int i = 0; i < 4000; ++i) {
        const Real alpha = i % 5 == 0 ? Real(1) : any_size(rng, -4, 0);
        const Real cosine = i % 3 == 0 ? Real(0) : any_size(rng, for_this_precision(-30, -100), 0);
        const Vec3 out = at(cosine, rng.uniform());
        const auto coordinate = [&](int k) {
            return i % k == 0 ? Real(0) : i % k == 1 ? last : rng.uniform();
        };
        const Vec2 place{coordinate(7), coordinate(11)};
        const Vec3 facet = rt::visible_facet(out, alpha, place);
        INFO(words(out, alpha) << ", place " << text(place.x) << ", " << text(place.y)
                               << ": the facet " << text(facet));
        {
            INFO("Hint: the radius of the cap is the root of a number that may be below 0");
            REQUIRE(std::abs(rt::length(facet) - 1) <= 5 * rt::epsilon);
            REQUIRE(facet.z >= 0);
            REQUIRE(rt::dot(facet, out) >= 0);
        }
        const Vec3 in = mirrored(out, facet);
        if (!(in.z > 0)) continue;
        const Real density = rt::reflection_density(out, in, alpha);
        INFO("in " << text(in) << ": the density is " << text(density));
        INFO("Hint: G1 / out.z has a form without a division by out.z");
        REQUIRE(std::isfinite(density));
        REQUIRE(density > 0);
        const Real share = rt::unshadowed(out, in, alpha);
        INFO("unshadowed is " << text(share) << ".\nHint: multiply G2 / G1 by both cosines");
        REQUIRE(share >= 0);
        REQUIRE(share <= 1 + 10 * rt::epsilon);
    }
}

TEST_CASE("14.4 shadows have all their digits at grazing angles", "[14.4][hard]") {
    rt::Rng rng{144, 10};
    const auto exact_length = [](Vec3 v, Real alpha) {
        const Exact x = Exact(v.x) * Exact(alpha), y = Exact(v.y) * Exact(alpha), z = Exact(v.z);
        return sqrt(x * x + y * y + z * z);
    };
    for (int i = 0; i < 2000; ++i) {
        const Real alpha = any_size(rng, -4, 0);
        const Vec3 out = at(i % 4 == 0 ? Real(0) : any_size(rng, -9, 0), rng.uniform()),
                   in = at(any_size(rng, -9, 0), rng.uniform());
        const Exact o = exact_length(out, alpha), to = exact_length(in, alpha);
        const Exact expected =
            Exact(in.z) * (Exact(out.z) + o) / (Exact(out.z) * to + Exact(in.z) * o);
        const Real computed = rt::unshadowed(out, in, alpha);
        INFO("unshadowed for " << words(out, alpha) << ", lit from " << text(in));
        HINT(expected, computed, "the tangent of a grazing direction is infinite: multiply it out");
        check_near(static_cast<double>(computed), expected.high,
                   30 * static_cast<double>(rt::epsilon));
    }
}

TEST_CASE("14.4 smooth metal scatters by its roughness and no more", "[14.4][hard]") {
    rt::Rng rng{144, 11};
    // Half of the facets seen head-on have a slope below alpha, since each is as likely as its
    // area, seen from above.
    for (const Real alpha : {real(1e-4), real(0.01), Real(1)}) {
        int below = 0;
        constexpr int count = 20'000;
        for (int i = 0; i < count; ++i) {
            const Vec3 facet = rt::visible_facet({0, 0, 1}, alpha, {rng.uniform(), rng.uniform()});
            const double slope = std::sqrt(sine_squared(facet)) / static_cast<double>(facet.z);
            below += slope < static_cast<double>(alpha) ? 1 : 0;
        }
        INFO("of " << count << " facets of the roughness " << text(alpha) << ", seen head-on, "
                   << below << " have a slope below alpha; half are expected");
        CHECK(std::abs(below - count / 2) < 4 * std::sqrt(count / 4.0));
    }
}
