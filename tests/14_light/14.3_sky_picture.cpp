#include <rt/length.hpp>
#include <rt/rng.hpp>
#include <rt/sky_picture.hpp>
#include <rt/vec3.hpp>
#include <statistics.hpp>
#include <vector>

#include "checkpoint.hpp"

using namespace checkpoint;
using rt::Color;
using rt::Image;
using rt::LightSample;
using rt::SkyPixel;
using rt::SkyTable;
using rt::Vec2;

namespace {

constexpr double pi = 3.14159265358979323846;

using checkpoint::text;
std::string text(SkyPixel pixel) {
    return "column " + std::to_string(pixel.column) + ", row " + std::to_string(pixel.row);
}
std::string size_of(const Image& picture) {
    return "a picture of " + std::to_string(picture.width()) + " x " +
           std::to_string(picture.height()) + " pixels";
}

// The direction at these shares of the picture's width and height.
Vec3 towards(double across, double down) {
    const double turn = 2 * pi * (across - 0.5), angle = pi * down;
    return {real(std::sin(angle) * std::sin(turn)), real(std::cos(angle)),
            real(-std::sin(angle) * std::cos(turn))};
}
Vec3 middle_of(const Image& picture, SkyPixel pixel) {
    return towards((pixel.column + 0.5) / picture.width(), (pixel.row + 0.5) / picture.height());
}

// sin((a + b) / 2) sin((b - a) / 2) never cancels.
double solid_angle(const Image& picture, int row) {
    const int from_pole = std::min(row, picture.height() - 1 - row);
    const double step = pi / picture.height();
    return 4 * pi / picture.width() * std::sin(step * (from_pole + 0.5)) * std::sin(step / 2);
}

double luminance_of(Color c) {
    return 0.2126 * static_cast<double>(c.r) + 0.7152 * static_cast<double>(c.g) +
           0.0722 * static_cast<double>(c.b);
}

template <class Use>
void for_each(const Image& picture, const Use& use) {
    for (int row = 0; row < picture.height(); ++row)
        for (int column = 0; column < picture.width(); ++column) use(SkyPixel{column, row});
}

// The light of the whole sky.
double total(const Image& picture) {
    double sum = 0;
    for_each(picture, [&](SkyPixel p) {
        sum += luminance_of(picture.at(p.column, p.row)) * solid_angle(picture, p.row);
    });
    return sum;
}
double share_of(const Image& picture, SkyPixel p) {
    return luminance_of(picture.at(p.column, p.row)) * solid_angle(picture, p.row) / total(picture);
}

// Colors of very different brightness; some are black.
Image any_sky(int width, int height, std::uint64_t seed) {
    rt::Rng rng{143, seed};
    return rt::make_image(width, height, [&](int x, int y) {
        const Real light = any_size(rng, -2, 1);
        const bool is_black = rng() % 4 == 0 && x + y > 0;
        const Real red = rng.uniform(), green = rng.uniform();
        return is_black ? Color{} : light * Color{red, green, real(0.5)};
    });
}
// Only these pixels shine.
template <class Shines>
Image partly_black(int width, int height, const Shines& shines) {
    return rt::make_image(width, height, [&](int x, int y) {
        return shines(x, y) ? Color{1, 1, 1} : Color{};
    });
}

LightSample sampled(const SkyTable& table, Vec2 place) {
    const std::optional<LightSample> sample = rt::sample_sky(table, place);
    INFO("sample_sky at " << text(place.x) << ", " << text(place.y) << ": " EXPECTED "a sample, "
                          << ACTUAL "none");
    REQUIRE(sample);
    return *sample;
}

void check_pixel(const Image& picture, Vec3 direction, SkyPixel expected, const char* hint) {
    const SkyPixel found = rt::sky_pixel(picture, direction);
    INFO("sky_pixel for " << text(direction) << " in " << size_of(picture) << ": " EXPECTED
                          << text(expected) << ", " ACTUAL << text(found) << ".\nHint: " << hint);
    REQUIRE(found == expected);
}

void check_near(double computed, double expected, double relative) {
    const bool is_near = std::abs(computed - expected) <= relative * std::abs(expected);
    REQUIRE(is_near);
}

constexpr double rounding = for_this_precision(5e-5, 1e-13);

}  // namespace

TEST_CASE("14.3 the middle of the picture is straight ahead and its top row is up", "[14.3]") {
    const Image picture{8, 4};
    const char* const hint =
        "the turn from -z toward +x is atan2(x, -z), from -pi to pi; half a turn is the right edge";
    check_pixel(picture, rt::normalize(Vec3{real(0.1), real(0.1), -1}), {4, 1}, hint);
    check_pixel(picture, rt::normalize(Vec3{real(-0.1), real(0.1), -1}), {3, 1}, hint);
    check_pixel(picture, rt::normalize(Vec3{1, real(-0.1), real(-0.1)}), {5, 2}, hint);
    check_pixel(picture, rt::normalize(Vec3{-1, real(-0.1), real(-0.1)}), {2, 2}, hint);
    check_pixel(picture, rt::normalize(Vec3{real(0.1), real(0.1), 1}), {7, 1}, hint);
    check_pixel(picture, rt::normalize(Vec3{real(-0.1), real(0.1), 1}), {0, 1}, hint);
    check_pixel(picture, rt::normalize(Vec3{real(0.1), 1, real(-0.2)}), {4, 0},
                "row 0 is at the top, where y is 1");
    check_pixel(picture, rt::normalize(Vec3{real(0.1), -1, real(-0.2)}), {4, 3},
                "the last row is at the bottom, where y is -1");
}

TEST_CASE("14.3 each pixel is seen in its middle", "[14.3]") {
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {8, 4}, {5, 7}, {64, 32}}) {
        const Image picture{width, height};
        for_each(picture, [&](SkyPixel pixel) {
            check_pixel(picture, middle_of(picture, pixel), pixel,
                        "rows are bands of equal angle: the angle from +y, divided by pi, times "
                        "the height; columns are slices of equal angle");
        });
    }
}

TEST_CASE("14.3 all pixels together fill the sky", "[14.3]") {
    for (const auto& [width, height] : {std::pair{1, 1}, {4, 2}, {5, 7}, {64, 32}}) {
        const Image picture{width, height};
        double sum = 0;
        for (int row = 0; row < height; ++row) {
            const double expected = solid_angle(picture, row);
            const Real computed = rt::sky_solid_angle(picture, row);
            INFO("the solid angle of a pixel in row " << row << " of " << size_of(picture));
            HINT(real(expected), computed,
                 "2 pi / width times cos a - cos b, where a and b are the angles of the row's "
                 "edges from straight up");
            check_near(static_cast<double>(computed), expected, rounding);
            sum += static_cast<double>(computed) * width;
        }
        INFO("the sum of all solid angles must be 4 pi");
        check_near(sum, 4 * pi, rounding);
    }
}

TEST_CASE("14.3 a pixel is as likely as its light", "[14.3]") {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Image picture = any_sky(9, 6, seed);
        const SkyTable table = rt::make_sky_table(picture);
        INFO(size_of(picture));
        REQUIRE(table.picture == &picture);
        REQUIRE(table.rows.size() == 6);
        REQUIRE(table.columns.size() == 6);
        for (int row = 0; row < 6; ++row) {
            const auto r = static_cast<std::size_t>(row);
            REQUIRE(table.columns[r].size() == 9);
            double of_row = 0;
            for (int column = 0; column < 9; ++column) of_row += share_of(picture, {column, row});
            const Real computed = rt::probability_of(table.rows, r);
            INFO("the probability of row " << row);
            {
                HINT(real(of_row), computed,
                     "the sum of the row's luminances, times sky_solid_angle: pixels near the "
                     "poles are small");
                check_near(static_cast<double>(computed), of_row, rounding);
            }
            for (int column = 0; column < 9; ++column) {
                const double expected = share_of(picture, {column, row}) / of_row;
                const Real in_row =
                    rt::probability_of(table.columns[r], static_cast<std::size_t>(column));
                INFO("the probability of column " << column << " in row " << row);
                HINT(real(expected), in_row, "its luminance, divided by that of the whole row");
                const bool is_near = std::abs(static_cast<double>(in_row) - expected) <= rounding;
                REQUIRE(is_near);
            }
        }
    }
}

TEST_CASE("14.3 the density is the probability over the solid angle", "[14.3]") {
    for (const std::uint64_t seed : {4, 5, 6}) {
        const Image picture = any_sky(8, 5, seed);
        const SkyTable table = rt::make_sky_table(picture);
        for_each(picture, [&](SkyPixel p) {
            const double expected = luminance_of(picture.at(p.column, p.row)) / total(picture);
            const Real computed = rt::sky_density(table, middle_of(picture, p));
            INFO("sky_density in the middle of " << text(p) << " of " << size_of(picture));
            HINT(real(expected), computed,
                 "the probability of the row times that of the pixel in it, divided by "
                 "sky_solid_angle");
            const bool is_near =
                std::abs(static_cast<double>(computed) - expected) <= rounding * (1 + expected);
            REQUIRE(is_near);
        });
    }
    // Of a white sky: 1 / (4 pi), everywhere.
    const Image white{6, 9, {1, 1, 1}};
    const SkyTable table = rt::make_sky_table(white);
    for_each(white, [&](SkyPixel p) {
        const Real computed = rt::sky_density(table, middle_of(white, p));
        INFO("in a white sky, " << text(p));
        HINT(real(1 / (4 * pi)), computed, "a white sky is drawn evenly: 1 / (4 pi)");
        check_near(static_cast<double>(computed), 1 / (4 * pi), rounding);
    });
}

TEST_CASE("14.3 pixels are drawn as often as they are likely", "[14.3]") {
    constexpr int samples = 100'000;
    for (const std::uint64_t seed : {7, 8}) {
        const Image picture = any_sky(12, 6, seed);
        const SkyTable table = rt::make_sky_table(picture);
        rt::Rng rng{143, seed};
        std::vector<long> counts(73);
        for (int i = 0; i < samples; ++i) {
            const Real x = rng.uniform(), y = rng.uniform();
            const LightSample sample = sampled(table, {x, y});
            const SkyPixel pixel = rt::sky_pixel(picture, sample.direction);
            ++counts[static_cast<std::size_t>(12 * pixel.row + pixel.column)];
            if (i % 100 > 0) continue;
            const double expected =
                luminance_of(picture.at(pixel.column, pixel.row)) / total(picture);
            INFO("a sample in " << text(pixel) << ", direction " << text(sample.direction));
            {
                HINT(real(expected), sample.density, "the density of a sample is sky_density");
                check_near(static_cast<double>(sample.density), expected,
                           for_this_precision(0.01, 1e-8));
            }
            {
                INFO("Hint: a direction has length 1");
                REQUIRE(std::abs(rt::length(sample.direction) - 1) <=
                        for_this_precision(real(1e-4), real(1e-9)));
            }
            INFO("Hint: the sky is infinitely far away: rt::infinity");
            REQUIRE(sample.distance == rt::infinity);
        }
        Cells cells;
        std::vector<double> expected(72);
        for_each(picture, [&](SkyPixel p) {
            const auto cell = static_cast<std::size_t>(12 * p.row + p.column);
            expected[cell] = samples * share_of(picture, p);
            cells.add(counts[cell], expected[cell]);
        });
        INFO(pictured(counts, expected, 12));
        auto& [seen, wanted] = cells;
        wanted[0] += 1;
        const double found = chi_square(seen, wanted),
                     limit = chi_square_limit(static_cast<int>(seen.size()));
        INFO("of " << samples << " samples in " << size_of(picture)
                   << ", counted by pixel: a chi-square of at most " << limit << " is "
                   << EXPECTED "; " ACTUAL << found
                   << ".\nHint: place.y chooses the row, place.x the pixel in it");
        CHECK(found < limit);
    }
}

TEST_CASE("14.3 within a pixel samples are spread evenly over the sky", "[14.3]") {
    constexpr int samples = 40'000, side = 10;
    rt::Rng rng{143, 9};
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {3, 2}}) {
        const Image white{width, height, {1, 1, 1}};
        const SkyTable table = rt::make_sky_table(white);
        std::vector<long> counts(side * side);
        for (int i = 0; i < samples; ++i) {
            const Real x = rng.uniform(), y = rng.uniform();
            const Vec3 d = sampled(table, {x, y}).direction;
            const double turn =
                std::atan2(static_cast<double>(d.x), static_cast<double>(-d.z)) / (2 * pi) + 0.5;
            const auto cell = [](double share) {
                return std::clamp(static_cast<int>(share * side), 0, side - 1);
            };
            ++counts[static_cast<std::size_t>(side * cell((1 - static_cast<double>(d.y)) / 2) +
                                              cell(turn))];
        }
        const std::vector<double> expected(side * side, samples / double{side * side});
        const double found = chi_square(counts, expected);
        INFO(pictured(counts, expected, side));
        INFO("a white sky as " << size_of(white) << ", in cells of equal solid angle: a "
                               << "chi-square of at most " << chi_square_limit(side * side - 1)
                               << " is " EXPECTED "; " ACTUAL << found
                               << ".\nHint: spread the heights evenly between cos a and cos b of "
                                  "the row, not the angles");
        CHECK(found < chi_square_limit(side * side - 1));
    }
}

TEST_CASE("14.3 a sample lies where the picks say", "[14.3]") {
    // In a white sky, place.y is the share of the sky above the sample, and place.x that to its
    // left.
    for (const int height : {2, 7}) {
        const Image white{4, height, {1, 1, 1}};
        const SkyTable table = rt::make_sky_table(white);
        for (const auto& [x, y] : {std::pair{0.05, 0.1}, {0.3, 0.3}, {0.6, 0.6}, {0.95, 0.9}}) {
            const Vec3 expected = towards(x, std::acos(1 - 2 * y) / pi);
            const Vec3 found = sampled(table, {real(x), real(y)}).direction;
            INFO("sample_sky at " << x << ", " << y << " in " << size_of(white) << ", all white");
            INFO(EXPECTED << text(expected) << ", " ACTUAL << text(found)
                          << ".\nHint: rest goes from the left edge of the pixel to the right one, "
                             "and from the height of its upper edge to that of the lower one");
            const bool is_near =
                max_component(expected - found) <= for_this_precision(real(1e-5), real(1e-14));
            REQUIRE(is_near);
        }
    }
}

TEST_CASE("14.3 a small sun gets its share of the samples", "[14.3]") {
    Image picture{32, 16, {1, 1, 1}};
    picture.at(20, 5) = {100'000, 100'000, 100'000};
    const SkyTable table = rt::make_sky_table(picture);
    const double share = share_of(picture, {20, 5});
    rt::Rng rng{143, 10};
    int in_sun = 0;
    constexpr int samples = 20'000;
    for (int i = 0; i < samples; ++i) {
        const Real x = rng.uniform(), y = rng.uniform();
        const bool found =
            rt::sky_pixel(picture, sampled(table, {x, y}).direction) == SkyPixel{20, 5};
        in_sun += found ? 1 : 0;
    }
    INFO("of " << samples << " samples, " << in_sun << " are in the sun; " << EXPECTED
               << share * samples);
    CHECK(std::abs(in_sun - share * samples) <=
          5 * std::sqrt(samples * share * (1 - share)) + samples * 1e-3);
}

TEST_CASE("14.3 black pixels are never drawn", "[14.3]") {
    const Image picture = partly_black(10, 6, [](int x, int y) { return (x + y) % 3 == 0; });
    const SkyTable table = rt::make_sky_table(picture);
    rt::Rng rng{143, 11};
    for (int i = 0; i < 5000; ++i) {
        const Real x = rng.uniform(), y = rng.uniform();
        const Vec3 direction = sampled(table, {x, y}).direction;
        const SkyPixel pixel = rt::sky_pixel(picture, direction);
        INFO("sample_sky at " << text(x) << ", " << text(y) << " leads to " << text(pixel)
                              << ", which is black");
        REQUIRE(picture.at(pixel.column, pixel.row).r > 0);
    }
    for_each(picture, [&](SkyPixel p) {
        if (picture.at(p.column, p.row).r > 0) return;
        const Real computed = rt::sky_density(table, middle_of(picture, p));
        INFO("sky_density in the black pixel " << text(p));
        HINT(Real(0), computed, "what is never drawn has the density 0");
        REQUIRE(computed == 0);
    });
}

TEST_CASE("14.3 a black sky has no samples", "[14.3][hard]") {
    const Image black{5, 3};
    const SkyTable table = rt::make_sky_table(black);
    for (const Real x : {Real(0), real(0.5), 1 - rt::epsilon / 2}) {
        const auto sample = rt::sample_sky(table, {x, x});
        INFO("sample_sky of a black picture: " EXPECTED "none, " ACTUAL "a sample");
        REQUIRE_FALSE(sample);
        const Real density = rt::sky_density(table, towards(static_cast<double>(x), 0.3));
        HINT(Real(0), density, "nothing is drawn from a black sky");
        REQUIRE(density == 0);
    }
    // A single row that shines.
    const Image horizon = partly_black(5, 3, [](int, int y) { return y == 1; });
    const SkyTable of_horizon = rt::make_sky_table(horizon);
    for (const double down : {0.1, 0.5, 0.9}) {
        const Real density = rt::sky_density(of_horizon, towards(0.3, down));
        const Real expected = down == 0.5 ? 1 / (5 * rt::sky_solid_angle(horizon, 1)) : 0;
        INFO("the density at the share " << down << " of the height, where only the middle row "
                                         << "shines");
        HINT(expected, density, "a black row has the probability 0, and so has each pixel in it");
        CHECK(std::abs(density - expected) <= 100 * rt::epsilon);
    }
}

TEST_CASE("14.3 every direction sees a pixel of the picture", "[14.3][hard]") {
    rt::Rng rng{143, 12};
    const Real tiny = std::numeric_limits<Real>::min();
    std::vector<Vec3> directions;
    for (const Real x : {Real(0), -Real(0), tiny, -tiny, Real(1), Real(-1)})
        for (const Real y : {Real(0), -Real(0), tiny, -tiny, Real(1), Real(-1)})
            for (const Real z : {Real(0), -Real(0), tiny, -tiny, Real(1), Real(-1)})
                if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == 1)
                    directions.push_back(rt::normalize(Vec3{x, y, z}));
    for (int i = 0; i < 2000; ++i) {
        const auto component = [&] { return rng.uniform(-1, 1) * any_size(rng, -20, 0); };
        const Vec3 v{component(), component(), component()};
        directions.push_back(rt::normalize(v));
    }
    // A direction whose y is rounded to more than 1.
    directions.push_back({0, 1 + rt::epsilon, 0});
    directions.push_back({rt::epsilon, -1 - rt::epsilon, 0});
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {4096, 64}, {64, 4096}}) {
        const Image picture{width, height};
        for (const Vec3 direction : directions) {
            const SkyPixel pixel = rt::sky_pixel(picture, direction);
            INFO("sky_pixel for " << text(direction) << " in " << size_of(picture) << ": " ACTUAL
                                  << text(pixel)
                                  << ".\nHint: a share that is rounded to 1 is that of the last "
                                     "pixel; acos of more than 1 is NaN");
            const bool is_inside =
                0 <= pixel.column && pixel.column < width && 0 <= pixel.row && pixel.row < height;
            REQUIRE(is_inside);
        }
        check_pixel(picture, {0, 1, 0}, {rt::sky_pixel(picture, {0, 1, 0}).column, 0},
                    "straight up is row 0");
        check_pixel(picture, {0, -1, 0}, {rt::sky_pixel(picture, {0, -1, 0}).column, height - 1},
                    "straight down is the last row");
    }
}

TEST_CASE("14.3 pixels end exactly at their edges", "[14.3][hard]") {
    const double near = for_this_precision(0.01, 1e-9);  // pixels
    const int many = for_this_precision(4096, 65'536);
    for (const auto& [width, height] : {std::pair{many, 16}, {16, many}}) {
        const Image picture{width, height};
        for (const int column : {1, width / 3, width / 2 + 5, width - 2})
            for (const int row : {1, height / 3, height / 2 + 3, height - 2})
                for (const double x : {column + near, column + 1 - near})
                    for (const double y : {row + near, row + 1 - near})
                        check_pixel(picture, towards(x / width, y / height), {column, row},
                                    "keep all digits of both angles, until they are pixels");
    }
}

TEST_CASE("14.3 both poles are exact in a picture of many rows", "[14.3][hard]") {
    for (const int height : {2048, 4095}) {
        const Image picture{16, height};
        for (const int from_pole : {0, 1, 2, 5, 100})
            for (const int row : {from_pole, height - 1 - from_pole}) {
                const double expected = solid_angle(picture, row);
                const Real computed = rt::sky_solid_angle(picture, row);
                INFO("the solid angle of a pixel in row " << row << " of " << size_of(picture));
                HINT(real(expected), computed,
                     "cos a - cos b loses its digits at the poles: it is 2 sin((a + b) / 2) "
                     "sin((b - a) / 2); take the angle from the nearer pole");
                check_near(static_cast<double>(computed), expected,
                           20 * static_cast<double>(rt::epsilon));
                const double turn = 0.53, down = (row + 0.3) / height;
                const double near = from_pole == row ? down : 1 - down;
                const Vec3 up = towards(turn, near);
                check_pixel(
                    picture, {up.x, from_pole == row ? up.y : -up.y, up.z}, {8, row},
                    "acos has no digits at the poles: the angle is atan2(hypot(x, z), |y|)");
            }
    }
}

TEST_CASE("14.3 samples at the poles have all their digits", "[14.3][hard]") {
    rt::Rng rng{143, 13};
    for (const int height : {256, 2048})
        for (const int lit : {0, height - 1}) {
            const Image picture = partly_black(1, height, [&](int, int y) { return y == lit; });
            const SkyTable table = rt::make_sky_table(picture);
            const double half = std::sin(pi / height / 2), depth = 2 * half * half;
            for (int i = 0; i < 500; ++i) {
                const Real x = rng.uniform(), y = rng.uniform();
                const Vec3 d = sampled(table, {x, y}).direction;
                INFO("place.y = " << text(y) << ", the lit row " << lit << " of " << height
                                  << ": direction " << text(d));
                const double part = static_cast<double>(lit == 0 ? y : 1 - y) * depth;
                const double expected = std::sqrt(part * (2 - part));
                const Real radius = std::sqrt(d.x * d.x + d.z * d.z);
                {
                    HINT(real(expected), radius,
                         "the distance from the pole: with k = 1 - cos a, it is sqrt(k (2 - k)), "
                         "and k is 2 sin^2(a / 2)");
                    check_near(static_cast<double>(radius), expected,
                               for_this_precision(1e-4, 1e-12));
                }
                INFO("Hint: the length must be 1");
                REQUIRE(std::abs(rt::length(d) - 1) <= 5 * rt::epsilon);
            }
        }
}

TEST_CASE("14.3 no sample leaves its pixel", "[14.3][hard]") {
    const Real last = 1 - rt::epsilon / 2;
    rt::Rng rng{143, 14};
    for (const auto& [width, height] : {std::pair{2, 2}, {6, 5}, {100, 51}, {1024, 512}}) {
        const Image picture =
            partly_black(width, height, [](int x, int y) { return (x + y) % 2 == 0; });
        const SkyTable table = rt::make_sky_table(picture);
        for (int i = 0; i < 4000; ++i) {
            // Where a share ends, a pixel ends, too.
            const auto& rows = table.rows;
            const std::size_t row = rng() % rows.size();
            const auto& columns = table.columns[row];
            const auto edge = [&](const std::vector<Real>& shares, std::size_t of) {
                const Real share = shares[of];
                const Real before = share - rt::epsilon / 2;
                return std::clamp(i % 2 == 0 ? share : before, Real(0), last);
            };
            const Vec2 place{i % 3 == 0 ? rng.uniform() : edge(columns, rng() % columns.size()),
                             i % 5 == 0 ? rng.uniform() : edge(rows, row)};
            const LightSample sample = sampled(table, place);
            const SkyPixel pixel = rt::sky_pixel(picture, sample.direction);
            INFO("sample_sky at " << text(place.x) << ", " << text(place.y) << " in "
                                  << size_of(picture) << ": its direction "
                                  << text(sample.direction) << " sees " << text(pixel)
                                  << ", which is black.\nHint: if sky_pixel finds another pixel "
                                     "than the one drawn, take the middle of the one drawn");
            REQUIRE(picture.at(pixel.column, pixel.row).r > 0);
            const Real density = rt::sky_density(table, sample.direction);
            HINT(density, sample.density, "the sample's density is sky_density of its direction");
            check_near(static_cast<double>(sample.density), static_cast<double>(density),
                       50 * static_cast<double>(rt::epsilon));
        }
    }
}

TEST_CASE("14.3 a sun a million times as bright leaves the rest its due", "[14.3][hard]") {
    Image picture{64, 32, {1, 1, 1}};
    picture.at(40, 10) = {1e6, 1e6, 1e6};
    const SkyTable table = rt::make_sky_table(picture);
    double sum = 0;
    for_each(picture, [&](SkyPixel p) {
        const Real density = rt::sky_density(table, middle_of(picture, p));
        INFO("sky_density in " << text(p) << " must be above 0: the pixel shines");
        REQUIRE(density > 0);
        sum += static_cast<double>(density) * solid_angle(picture, p.row);
    });
    INFO("the integral of sky_density over the sky: " EXPECTED "1, " ACTUAL << sum);
    CHECK(std::abs(sum - 1) <= for_this_precision(1e-5, 1e-12));
}
