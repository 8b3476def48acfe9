#include <algorithm>
#include <cmath>
#include <random>
#include <rt/rng.hpp>
#include <vector>

#include "checkpoint.hpp"

// The statistical tests below use fixed seeds, so they pass always or never. Each bound is set so
// that a perfect generator would miss it with a probability below 1e-6 for a seed drawn at random.

namespace {

using checkpoint::Real;

// The number that a chi-square statistic with this many degrees of freedom exceeds
// with a probability of 5e-7. Source: Wilson and Hilferty, "The distribution of
// chi-square", PNAS 17, 1931.
double chi_square_limit(double degrees, double z) {
    const double a = 2 / (9 * degrees);
    return degrees * std::pow(1 - a + z * std::sqrt(a), 3);
}

// True when the counts could come from equally likely cells: neither too uneven nor too even.
bool could_be_uniform(const std::vector<int>& counts) {
    double total = 0, chi_square = 0;
    for (const int count : counts) total += count;
    const double expected = total / static_cast<double>(counts.size());
    for (const int count : counts) chi_square += (count - expected) * (count - expected) / expected;
    const double degrees = static_cast<double>(counts.size()) - 1, z = 4.9;
    INFO("chi-square " << chi_square << " with " << degrees << " degrees of freedom");
    CHECK(chi_square > chi_square_limit(degrees, -z));
    CHECK(chi_square < chi_square_limit(degrees, z));
    return chi_square > chi_square_limit(degrees, -z) && chi_square < chi_square_limit(degrees, z);
}

std::size_t cell(Real u, int cells) {
    return static_cast<std::size_t>(u * static_cast<Real>(cells));
}

// The correlation of n numbers of each stream: 0 for independent ones, give or take 1 / sqrt(n).
double correlation(rt::Rng a, rt::Rng b, int n) {
    double sum = 0;
    for (int i = 0; i < n; ++i)
        sum += (static_cast<double>(a.uniform()) - 0.5) * (static_cast<double>(b.uniform()) - 0.5);
    return 12 * sum / n;
}

// The state from which the generator of this stream draws 0xffffffff next.
rt::Rng about_to_give_all_ones(std::uint64_t stream) {
    const std::uint64_t wanted = ((1ull << 18) - 1) << 41, factor = 6364136223846793005u,
                        increment = stream << 1 | 1;
    std::uint64_t inverse = factor;  // modulo 2^64: each step doubles the number of right bits
    for (int i = 0; i < 6; ++i) inverse *= 2 - factor * inverse;
    return {(wanted - increment) * inverse - increment, stream};
}

}  // namespace

// The first outputs of the demo program that comes with the generator's publication, for state 42
// and stream 54.
TEST_CASE("pcg32 gives its author's check values", "[rng]") {
    rt::Rng rng{42, 54};
    for (const std::uint32_t expected :
         {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u, 0xbfa4784bu, 0xcbed606eu})
        CHECK(rng() == expected);
}

// The first outputs of the authors' generator for seed 1234567; its state grows by a constant.
TEST_CASE("mix_bits gives the values of SplitMix64", "[rng]") {
    std::uint64_t state = 1234567;
    for (const std::uint64_t expected :
         {6457827717110365317u, 3203168211198807973u, 9817491932198370423u, 4593380528125082431u,
          16408922859458223821u}) {
        CHECK(rt::mix_bits(state) == expected);
        state += 0x9e3779b97f4a7c15u;
    }
}

TEST_CASE("the generator works with the standard library", "[rng]") {
    static_assert(std::uniform_random_bit_generator<rt::Rng>);
    rt::Rng rng{1, 2};
    const int die = std::uniform_int_distribution<int>{1, 6}(rng);
    CHECK(die >= 1);
    CHECK(die <= 6);
}

TEST_CASE("uniform never gives 1, even where all bits are set", "[rng]") {
    for (const std::uint64_t stream : {0ull, 54ull, 123456789ull}) {
        rt::Rng rng = about_to_give_all_ones(stream), same = rng;
        REQUIRE(same() == 0xffffffffu);
        const Real u = rng.uniform();
        CHECK(u < 1);
        CHECK(1 - u <= Real(0x1p-24));  // float keeps 24 of the 32 bits
    }
    static_assert(((1ull << std::numeric_limits<Real>::digits) - 1) * (rt::epsilon / 2) < 1);
}

TEST_CASE("uniform keeps to its interval", "[rng]") {
    rt::Rng rng{7, 8};
    for (int i = 0; i < 100'000; ++i) {
        const Real u = rng.uniform(), v = rng.uniform(Real(-3), Real(5));
        REQUIRE((0 <= u && u < 1));
        REQUIRE((-3 <= v && v <= 5));
    }
}

TEST_CASE("uniform is equally distributed in one and in two dimensions", "[rng]") {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        rt::Rng rng = rt::pixel_rng(seed, 0, 0);
        std::vector<int> line(1024), plane(32 * 32);
        for (int i = 0; i < 200'000; ++i) {
            const Real x = rng.uniform(), y = rng.uniform();
            ++line[cell(x, 1024)];
            ++plane[cell(x, 32) * 32 + cell(y, 32)];
        }
        CHECK(could_be_uniform(line));
        CHECK(could_be_uniform(plane));
    }
}

TEST_CASE("the low bits of uniform are as random as the high ones", "[rng]") {
    rt::Rng rng{3, 4};
    std::vector<int> counts(64);
    constexpr Real scale = 1 / (rt::epsilon / 2) / 64;  // leaves the last 6 bits behind the point
    for (int i = 0; i < 200'000; ++i) {
        const Real x = rng.uniform() * scale;
        ++counts[cell(x - std::floor(x), 64)];
    }
    CHECK(could_be_uniform(counts));
}

TEST_CASE("the first numbers of neighboring pixels are equally distributed", "[rng]") {
    for (const std::uint64_t seed : {0u, 1u}) {
        std::vector<int> line(1024), plane(32 * 32);
        for (int y = 0; y < 400; ++y)
            for (int x = 0; x < 400; ++x) {
                rt::Rng rng = rt::pixel_rng(seed, x, y);
                const Real u = rng.uniform(), v = rng.uniform();
                ++line[cell(u, 1024)];
                ++plane[cell(u, 32) * 32 + cell(v, 32)];
            }
        CHECK(could_be_uniform(line));
        CHECK(could_be_uniform(plane));
    }
}

TEST_CASE("pixels and seeds share no outputs", "[rng]") {
    // 2^16 numbers of 64 bits: two would be equal by chance with a probability of 1e-10.
    std::vector<std::uint64_t> outputs;
    for (const std::uint64_t seed : {0ull, 1ull, 2ull, 0xffffffffffffffffull})
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                rt::Rng rng = rt::pixel_rng(seed, x, y);
                for (int i = 0; i < 4; ++i) {
                    const std::uint64_t high = rng();
                    outputs.push_back(high << 32 | rng());
                }
            }
    std::sort(outputs.begin(), outputs.end());
    CHECK(std::adjacent_find(outputs.begin(), outputs.end()) == outputs.end());
}

TEST_CASE("neighboring pixels and seeds are not correlated", "[rng]") {
    constexpr int n = 4096;
    const double limit = 6.5 / std::sqrt(n);  // for all 1500 pairs together
    const auto check = [&](rt::Rng a, rt::Rng b) {
        REQUIRE(std::abs(correlation(a, b, n)) < limit);
    };
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x) {
            const auto here = rt::pixel_rng(5, x, y);
            check(here, rt::pixel_rng(5, x + 1, y));
            check(here, rt::pixel_rng(5, x, y + 1));
            check(here, rt::pixel_rng(6, x, y));
            if (x != y) check(here, rt::pixel_rng(5, y, x));
        }
}

TEST_CASE("a pixel's stream depends on seed and pixel alone", "[rng]") {
    rt::Rng a = rt::pixel_rng(9, 3, 4), b = rt::pixel_rng(9, 3, 4);
    for (int i = 0; i < 10; ++i) CHECK(a() == b());
}
