#include <rt/jitter.hpp>
#include <rt/rng.hpp>

#include "checkpoint.hpp"
#include "density.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Color, rt::Vec2;

namespace {

const Real largest = 1 - rt::epsilon / 2;  // the largest number that uniform() gives

// Cell k of n along one side: k / n <= x < (k + 1) / n.
bool is_in_cell(Real x, int k, int n) {
    const auto count = static_cast<Real>(n);
    return static_cast<Real>(k) / count <= x && x < static_cast<Real>(k + 1) / count;
}

// The cell of n along one side that an offset lies in; -1 if in none.
int cell_of(Real x, int n) {
    if (!(0 <= x && x < 1)) return -1;
    const int near = static_cast<int>(x * static_cast<Real>(n));
    for (int k = std::max(near - 1, 0); k <= std::min(near + 1, n - 1); ++k)
        if (is_in_cell(x, k, n)) return k;
    return -1;
}

// The share of the pixel in which x cos + y sin < edge, exactly; cosine and sine greater than 0.
double coverage(double cosine, double sine, double edge) {
    const auto triangle = [&](double e) { return e > 0 ? e * e / (2 * cosine * sine) : 0; };
    return triangle(edge) - triangle(edge - cosine) - triangle(edge - sine) +
           triangle(edge - cosine - sine);
}

// Checks that the offset of a place in a cell lies in that cell, and where it should.
void check_offset(int cell, int n, Vec2 place) {
    const Vec2 offset = rt::jittered_offset(cell, n, place);
    const int column = cell % n, row = cell / n;
    const auto expected = [&](int k, Real x) {
        return (static_cast<Real>(k) + x) / static_cast<Real>(n);
    };
    const Vec2 sum{expected(column, place.x), expected(row, place.y)};
    const auto is_near = [](Real a, Real b) { return std::abs(a - b) <= 2 * rt::epsilon; };
    const bool near_x = is_near(offset.x, sum.x), near_y = is_near(offset.y, sum.y);
    const bool in_x = is_in_cell(offset.x, column, n), in_y = is_in_cell(offset.y, row, n);
    const bool is_right = near_x && near_y && in_x && in_y;
    if (!is_right) {
        const auto all = [](Vec2 p) { return '(' + text(p.x) + ", " + text(p.y) + ')'; };
        INFO("cell " << cell << " of " << n << " x " << n << " is in column " << column
                     << " and row " << row << ": with place " << all(place) << " your offset is "
                     << all(offset));
        if (!near_x || !near_y) {
            INFO(
                EXPECTED "the offset ((column + x) / n, (row + y) / n), where (x, y) is the place: "
                << all(sum)
                << ".\nHint: the column of a cell is cell % n, and its row is cell / n in whole "
                   "numbers. "
                   "Every other division needs a Real: (column + 1) / n of whole numbers drops the "
                   "fraction");
            REQUIRE(all(offset) == all(sum));
        }
        INFO(
            "Hint: your offset lies on the next cell's edge. The sum is rounded, and so is the "
            "quotient: limit "
            "the quotient, not the sum, to the largest number below (k + 1) / n, in x and in y");
        if (!in_x) REQUIRE(text(offset.x) == "less than " + text(expected(column + 1, 0)));
        REQUIRE(text(offset.y) == "less than " + text(expected(row + 1, 0)));
    }
    REQUIRE(is_right);
}

}  // namespace

TEST_CASE("04.5 a place in the unit square becomes an offset in the cell", "[04.5]") {
    rt::Rng rng{44, 1};
    for (int n = 1; n <= 16; ++n)
        for (int cell = 0; cell < n * n; ++cell) check_offset(cell, n, rt::random_place(rng));
    for (int i = 0; i < 10000; ++i) {
        const int n = 1 + static_cast<int>(rng() % 2000);
        const int cell = static_cast<int>(rng() % static_cast<unsigned>(n * n));
        check_offset(cell, n, rt::random_place(rng));
    }
}

TEST_CASE("04.5 each cell gets one sample and every sample counts in the average", "[04.5]") {
    rt::Rng rng{44, 2};
    for (int i = 1; i <= 134; ++i) {
        const int more[] = {1000, 1023, 1024, 1025}, samples = i <= 130 ? i : more[i - 131];
        const int n = static_cast<int>(std::sqrt(samples));
        std::vector<int> counts(static_cast<std::size_t>(n * n));
        int calls = 0, outside = 0;
        Color sum;
        const Color average = rt::pixel_average(samples, rng, [&](Vec2 offset) {
            const int column = cell_of(offset.x, n), row = cell_of(offset.y, n);
            if (column < 0 || row < 0)
                ++outside;
            else
                ++counts[static_cast<std::size_t>(row * n + column)];
            ++calls;
            // Samples return different light, and some are very bright.
            const auto light = static_cast<Real>(calls * calls % 101);
            const Color color{light, samples % 7 ? 1000 * light : 0, light == 5 ? Real(1e6) : 1};
            sum += color;
            return color;
        });
        INFO("samples: " << samples << ", in a grid of " << n << " x " << n << " cells and "
                         << samples - n * n << " more anywhere; calls of sample: " << calls);
        const int empty_cells = static_cast<int>(std::count(counts.begin(), counts.end(), 0));
        REQUIRE(calls == samples);
        REQUIRE(outside == 0);
        {
            INFO("Hint: one sample in each cell of the grid");
            REQUIRE(empty_cells == 0);
        }
        const Color expected = sum / static_cast<Real>(samples);
        const auto off = [&](Real a, Real b) {
            return std::abs(a - b) <= 4 * static_cast<Real>(samples) * rt::epsilon * std::abs(b);
        };
        if (off(average.r, expected.r) && off(average.g, expected.g) && off(average.b, expected.b))
            continue;
        const auto all = [](Color c) {
            return "rgb(" + text(c.r) + ", " + text(c.g) + ", " + text(c.b) + ')';
        };
        INFO("Hint: the average is the sum divided by the number of samples");
        REQUIRE(all(average) == all(expected));
    }
}

TEST_CASE("04.5 many samples have a grid as fine as possible", "[04.5]") {
    rt::Rng rng{44, 7};
    for (const int samples : {5000, 258 * 258}) {
        const int n = static_cast<int>(std::sqrt(samples));
        std::vector<int> counts(static_cast<std::size_t>(n * n));
        rt::pixel_average(samples, rng, [&](Vec2 offset) {
            const int column = cell_of(offset.x, n), row = cell_of(offset.y, n);
            if (column >= 0 && row >= 0) ++counts[static_cast<std::size_t>(row * n + column)];
            return Color{};
        });
        const auto empty = std::count(counts.begin(), counts.end(), 0);
        INFO(samples << " samples: " << empty << " of " << n << " x " << n << " cells are empty");
        CHECK(empty < n * n / 100);  // rounding may move a few samples into the next cell
    }
}

TEST_CASE("04.5 each sample is uniform in its cell and independent of the others", "[04.5]") {
    rt::Rng rng{44, 3};
    constexpr int pixels = 5000;
    // Both coordinates of all samples of a pixel, each from 0 to 1 across its cell. For any two of
    // them, all pairs of values must be equally likely.
    const auto check_pairs = [&](int samples, int n, const char* hint) {
        const auto size = static_cast<std::size_t>(2 * samples);
        std::vector<PairCounts> pairs(size * size);
        for (int pixel = 0; pixel < pixels; ++pixel) {
            std::vector<Real> all(size);
            std::size_t calls = 0;
            rt::pixel_average(samples, rng, [&](Vec2 offset) {
                const Real x = offset.x * static_cast<Real>(n), y = offset.y * static_cast<Real>(n);
                // The cell tells which sample it is; without a grid, the order does.
                const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
                const std::size_t place = 2 * (n > 1 ? 3 * row + column : calls);
                if (++calls <= size / 2 && place + 1 < size) {
                    all[place] = x - std::floor(x);
                    all[place + 1] = y - std::floor(y);
                }
                return Color{};
            });
            for (std::size_t i = 0; i < size; ++i)
                for (std::size_t j = i + 1; j < size; ++j) pairs[i * size + j].add(all[i], all[j]);
        }
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t j = i + 1; j < size; ++j) {
                const double statistic = pairs[i * size + j].chi_square();
                if (statistic < PairCounts::limit()) continue;
                const auto name = [&](std::size_t k) {
                    return std::string{k % 2 ? "y" : "x"} + " of sample " + std::to_string(k / 2);
                };
                INFO(samples << " samples per pixel: " << name(i) << " and " << name(j)
                             << ", each from 0 to 1 across its cell, are not independent or not "
                                "spread evenly: the chi-square of their pairs is "
                             << statistic << ".\nHint: " << hint);
                REQUIRE(statistic < PairCounts::limit());
            }
    };
    check_pairs(9, 3, "each cell gets a random_place(random) of its own, with two numbers");
    check_pairs(3, 1, "each sample left over gets a random_place(random) of its own");

    // Those left over: every point of the pixel is equally likely.
    PairCounts places;
    for (int pixel = 0; pixel < pixels; ++pixel)
        rt::pixel_average(7, rng, [&](Vec2 offset) {
            places.add(offset.x, offset.y);
            return Color{};
        });
    INFO("7 samples per pixel, 3 of them left over: the chi-square of all points in the pixel is "
         << places.chi_square() << ".\nHint: the samples left over go anywhere in the pixel");
    CHECK(places.chi_square() < PairCounts::limit());
}

TEST_CASE("04.5 a pixel at an edge is as bright as its covered fraction", "[04.5]") {
    const Real cosine = real(0.8), sine = real(0.6), edge = real(0.55);
    const double covered = coverage(0.8, 0.6, 0.55);
    for (const int samples : {1, 4, 16, 20}) {
        Mean jittered;
        for (std::uint64_t seed = 0; seed < 400; ++seed) {
            rt::Rng rng{seed, 5};
            const Color average = rt::pixel_average(samples, rng, [&](Vec2 offset) {
                const bool inside = offset.x * cosine + offset.y * sine < edge;
                return inside ? Color{1, 1, 1} : Color{};
            });
            jittered.add(static_cast<double>(average.g));
        }
        INFO(samples << " samples, 400 seeds: actual mean " << jittered.mean() << ", " EXPECTED
                     << covered << ", standard error " << jittered.standard_error());
        // Correct code stays within 6 standard errors in all but one of 500 million runs.
        CHECK(std::abs(jittered.mean() - covered) <= 6 * jittered.standard_error());
        if (samples < 16) continue;
        INFO("the variance is " << jittered.variance() << "; without the grid it is "
                                << covered * (1 - covered) / samples);
        CHECK(jittered.variance() < covered * (1 - covered) / samples / 2);
    }
}

TEST_CASE("04.5 rounding never moves a sample into the next cell", "[04.5][hard]") {
    for (int n = 1; n <= 100; ++n)
        for (int k = 0; k < n; ++k)
            for (const Real x : {Real(0), rt::epsilon / 2, largest})
                check_offset(k * n + k, n, {x, x});
    rt::Rng rng{44, 4};
    for (int i = 0; i < 10000; ++i) {
        const int n = 1 + static_cast<int>(rng() % 2000);
        const int cell = static_cast<int>(rng() % static_cast<unsigned>(n * n));
        const Real close = any_size(rng, for_this_precision(-7, -16), -1);
        check_offset(cell, n, {std::min(1 - close, largest), close});
        check_offset(cell, n, {close, std::min(1 - close, largest)});
    }
}

TEST_CASE("04.5 the average of a million samples is accurate even in float", "[04.5][hard]") {
    rt::Rng rng{44, 6};
    for (const int samples : {1 << 18, 1'000'000}) {
        double red = 0, blue = 0;
        const Color average = rt::pixel_average(samples, rng, [&](Vec2) {
            const Color color{real(0.7), 0, rng.uniform() < real(0.01) ? 90 : rng.uniform()};
            red += static_cast<double>(color.r);
            blue += static_cast<double>(color.b);
            return color;
        });
        INFO(samples << " samples.\nHint: a large float sum has no digits left for a small sample. "
                        "Add up with a ColorSum, or add up each row of cells separately");
        const auto check = [&](Real actual, double sum) {
            const double expected = sum / samples;
            INFO(EXPECTED << expected << ", " ACTUAL << actual);
            const auto float_epsilon = static_cast<double>(std::numeric_limits<float>::epsilon());
            REQUIRE(std::abs(static_cast<double>(actual) - expected) <=
                    100 * float_epsilon * expected);
        };
        check(average.r, red);
        check(average.b, blue);
    }
}
