#include <rt/jitter.hpp>
#include <rt/rng.hpp>

#include "checkpoint.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Color, rt::Vec2;

namespace {

const Real largest = 1 - rt::epsilon / 2;  // the largest number that uniform() gives

// The cell of n along one side that an offset lies in: k / n <= x < (k + 1) / n; -1 if in none.
int cell_of(Real x, int n) {
    for (int k = 0; k < n; ++k)
        if (static_cast<Real>(k) / static_cast<Real>(n) <= x &&
            x < static_cast<Real>(k + 1) / static_cast<Real>(n))
            return k;
    return -1;
}

// The share of the pixel in which x cos + y sin < edge, exactly; cosine and sine greater than 0.
double coverage(double cosine, double sine, double edge) {
    const auto triangle = [&](double e) { return e > 0 ? e * e / (2 * cosine * sine) : 0; };
    return triangle(edge) - triangle(edge - cosine) - triangle(edge - sine) +
           triangle(edge - cosine - sine);
}

}  // namespace

TEST_CASE("04.4 jittered offsets lie one in each cell", "[04.4]") {
    rt::Rng rng{44, 1};
    for (int n = 1; n <= 16; ++n)
        for (int cell = 0; cell < n * n; ++cell) {
            const Vec2 place = rt::random_place(rng);
            const Vec2 offset = rt::jittered_offset(cell, n, place);
            INFO("cell " << cell << " of " << n << " x " << n << " with place (" << text(place.x)
                         << ", " << text(place.y) << ") gives (" << text(offset.x) << ", "
                         << text(offset.y) << ")");
            {
                INFO(
                    "Hint: the column of a cell is cell % n, its row cell / n in whole numbers. "
                    "Every other division needs a Real: (column + 1) / n of whole numbers drops "
                    "the fraction");
                REQUIRE(cell_of(offset.x, n) == cell % n);
                REQUIRE(cell_of(offset.y, n) == cell / n);
            }
            INFO("Hint: the place within the cell is part of the offset");
            const Real x = (static_cast<Real>(cell % n) + place.x) / static_cast<Real>(n);
            const Real y = (static_cast<Real>(cell / n) + place.y) / static_cast<Real>(n);
            REQUIRE(std::abs(offset.x - x) <= 2 * rt::epsilon);
            REQUIRE(std::abs(offset.y - y) <= 2 * rt::epsilon);
        }
}

TEST_CASE("04.4 the average takes each cell once and all samples", "[04.4]") {
    for (const int samples : {1, 2, 3, 4, 5, 8, 9, 10, 16, 100, 120, 1024}) {
        rt::Rng rng{44, 2};
        const int n = static_cast<int>(std::sqrt(samples));
        std::vector<int> counts(static_cast<std::size_t>(n * n));
        int calls = 0, outside = 0;
        const Color average = rt::pixel_average(samples, rng, [&](Vec2 offset) {
            const int column = cell_of(offset.x, n), row = cell_of(offset.y, n);
            if (column < 0 || row < 0)
                ++outside;
            else if (calls < n * n)
                ++counts[static_cast<std::size_t>(row * n + column)];
            ++calls;
            return Color{static_cast<Real>(calls), 1, real(0.25)};
        });
        INFO(samples << " samples: a grid of " << n << " x " << n << " cells, " << samples - n * n
                     << " more samples anywhere");
        CHECK(calls == samples);
        CHECK(outside == 0);
        {
            INFO("Hint: the first n * n samples go one into each cell");
            CHECK(std::all_of(counts.begin(), counts.end(), [](int c) { return c == 1; }));
        }
        INFO("Hint: the average is the sum divided by the number of samples; yours gives "
             << average);
        CHECK(average == Color{static_cast<Real>(samples + 1) / 2, 1, real(0.25)});
    }
}

TEST_CASE("04.4 an edge pixel shows how much of it is covered", "[04.4]") {
    const Real cosine = real(0.8), sine = real(0.6), edge = real(0.55);
    const double covered = coverage(0.8, 0.6, 0.55);
    for (const int samples : {1, 4, 16, 20}) {
        Mean jittered;
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            rt::Rng rng{seed, 5};
            const Color average = rt::pixel_average(samples, rng, [&](Vec2 offset) {
                const bool inside = offset.x * cosine + offset.y * sine < edge;
                return inside ? Color{1, 1, 1} : Color{};
            });
            jittered.add(static_cast<double>(average.g));
        }
        INFO(samples << " samples, 100 seeds: mean " << jittered.mean() << ", covered " << covered
                     << ", standard error " << jittered.standard_error());
        // Right code stays within 4 standard errors in all but one of 15000 runs.
        CHECK(std::abs(jittered.mean() - covered) <= 4 * jittered.standard_error());
        if (samples < 16) continue;
        INFO("the variance is " << jittered.variance() << ", without the grid it is "
                                << covered * (1 - covered) / samples);
        CHECK(jittered.variance() < covered * (1 - covered) / samples / 2);
    }
}

TEST_CASE("04.4 no rounding moves a sample into the next cell", "[04.4][hard]") {
    for (int n = 1; n <= 100; ++n)
        for (int k = 0; k < n; ++k)
            for (const Real x : {Real(0), rt::epsilon / 2, largest}) {
                const Vec2 offset = rt::jittered_offset(k * n + k, n, {x, x});
                INFO("cell " << k << " of " << n << " with place " << text(x) << " gives "
                             << text(offset.x));
                const bool too_small =
                    offset.x < static_cast<Real>(k) / static_cast<Real>(n) || offset.x < 0;
                INFO("Hint: " << (too_small
                                      ? "below its own cell. Whole numbers divide without a "
                                        "fraction: make them Real before you divide"
                                      : "the sum is rounded, and the division once more: limit the "
                                        "quotient, not the sum, to the largest number below "
                                        "(k + 1) / n"));
                REQUIRE(cell_of(offset.x, n) == k);
                REQUIRE(cell_of(offset.y, n) == k);
            }
}
