#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <rt/rng.hpp>
#include <rt/sobol.hpp>
#include <string>
#include <vector>

#include "checkpoint.hpp"

using rt::FixedPoint2;

namespace {

std::string hex(std::uint32_t bits) {
    char buffer[16];
    std::snprintf(buffer, sizeof buffer, "0x%08x", static_cast<unsigned>(bits));
    return buffer;
}

std::string text(FixedPoint2 p) {
    char decimals[64];
    std::snprintf(decimals, sizeof decimals, ", which is (%.6g, %.6g)", p.x * 0x1p-32,
                  p.y * 0x1p-32);
    return '(' + hex(p.x) + ", " + hex(p.y) + ')' + decimals;
}

// One bit at a time, the slow way.
std::uint32_t mirrored(std::uint32_t x) {
    std::uint32_t result = 0;
    for (int i = 0; i < 32; ++i)
        if (x >> i & 1) result |= 0x80000000u >> i;
    return result;
}

// The definition: column k of y's matrix has the bits C(k, j) modulo 2, which by Lucas' theorem is
// 1 where the bits of j are among those of k.
FixedPoint2 expected_point(std::uint32_t index) {
    FixedPoint2 point{mirrored(index), 0};
    for (unsigned k = 0; k < 32; ++k)
        for (unsigned j = 0; j < 32; ++j)
            if ((index >> k & 1) && (k & j) == j) point.y ^= 0x80000000u >> j;
    return point;
}

void check_mirrored(std::uint32_t x) {
    const std::uint32_t actual = rt::reversed_bits(x), expected = mirrored(x);
    const bool is_right = actual == expected;
    if (!is_right) {
        INFO("reversed_bits(" << hex(x) << "): " EXPECTED << hex(expected) << ", " ACTUAL
                              << hex(actual));
        INFO(
            "Hint: all 32 bits change places: bit 0 becomes bit 31, bit 1 becomes bit 30, and so "
            "on. If you swap groups of 16, 8, 4, 2 bits and 1 bit, there are five steps, and each "
            "needs both shifts, >> and <<");
        REQUIRE(hex(actual) == hex(expected));
    }
    CHECK(is_right);
}

void check_point(std::uint32_t index) {
    const FixedPoint2 actual = rt::sobol_point(index), expected = expected_point(index);
    const bool is_right = actual == expected;
    if (!is_right) {
        const char* hint =
            "y is the exclusive or of one column for each bit of the index that is 1, beginning "
            "with the lowest bit. The columns are 0x80000000, 0xc0000000, 0xa0000000, 0xf0000000 "
            "and so on: each is c ^ c >> 1 of the column c before it, whether or not that column "
            "was used";
        if (actual.x != expected.x) hint = "x is reversed_bits(index)";
        // What is wrong, if the same thing is wrong at all of the first few points.
        const auto always = [](auto other) {
            for (std::uint32_t i = 0; i < 16; ++i)
                if (rt::sobol_point(i) != other(i)) return false;
            return true;
        };
        if (always([](std::uint32_t i) { return expected_point(i ^ i >> 1); }))
            hint =
                "this is the sequence in the order of a Gray code; point i must use the bits of i "
                "unchanged";
        else if (always([](std::uint32_t i) { return expected_point(i + 1); }))
            hint = "this is the next point: the first point is point 0, at (0, 0)";
        else if (always([](std::uint32_t i) {
                     const FixedPoint2 p = expected_point(i);
                     return FixedPoint2{p.y, p.x};
                 }))
            hint = "x and y are swapped";
        INFO("point " << index << ": " EXPECTED << text(expected) << ", " ACTUAL << text(actual));
        INFO("Hint: " << hint);
        REQUIRE(text(actual) == text(expected));
    }
    CHECK(is_right);
}

// How many bits two fractions have in common before the first that is different.
int common_bits(std::uint32_t a, std::uint32_t b) {
    return std::countl_zero(a ^ b);
}

void check_common_bits(std::uint32_t a, std::uint32_t b, std::uint32_t seed) {
    const std::uint32_t scrambled_a = rt::owen_scrambled(a, seed);
    const std::uint32_t scrambled_b = rt::owen_scrambled(b, seed);
    const int expected = common_bits(a, b), actual = common_bits(scrambled_a, scrambled_b);
    const bool is_right = actual == expected;
    if (!is_right) {
        INFO("with seed " << hex(seed) << ", " << hex(a) << " becomes " << hex(scrambled_a)
                          << " and " << hex(b) << " becomes " << hex(scrambled_b));
        INFO("the two had their first " << expected << " bits in common: " EXPECTED << expected
                                        << " afterward, " ACTUAL << actual);
        const char* hint =
            "a bit may depend only on itself and on the bits before it (to its left). Products and "
            "sums carry to the left: mirror the bits first, and mirror them back at the end";
        if (actual > expected)
            hint =
                "two different fractions must stay different, and their first different bit must "
                "stay in its place, because each bit is either flipped or not. In x ^= x * k, an "
                "odd k removes the last bit of x; k must be even";
        INFO("Hint: " << hint);
        REQUIRE(actual == expected);
    }
    CHECK(is_right);
}

// A beginning of a fraction: its first `length` bits.
struct Prefix {
    std::uint32_t bits;
    int length;
};

std::string text(Prefix p) {
    if (p.length == 0) return "the first bit";
    std::string all = "the bit after ";
    for (int i = 0; i < p.length; ++i) all += (p.bits << i & 0x80000000u) ? '1' : '0';
    return all;
}

// Whether the bit after a prefix is flipped, 0 or 1.
unsigned flip(Prefix p, std::uint32_t seed) {
    return (rt::owen_scrambled(p.bits, seed) ^ p.bits) >> (31 - p.length) & 1;
}

// A share of 256 seeds or more that should be one half. Independent flips miss it by more once in
// 10^29 times. The limit is wide because flips that agree three times out of four are good enough
// for a picture; widely used hashes have such pairs.
bool is_one_half(int count, int of) {
    return std::abs(static_cast<double>(count) / of - 0.5) < 0.35;
}

}  // namespace

TEST_CASE("11.4 reversed_bits reverses the order of all 32 bits", "[11.4]") {
    for (int i = 0; i < 32; ++i) check_mirrored(1u << i);
    rt::Rng random{114, 1};
    for (int i = 0; i < 100; ++i) check_mirrored(random());
}

TEST_CASE("11.4 the first points of the sequence are correct", "[11.4]") {
    for (std::uint32_t index = 0; index < 300; ++index) check_point(index);
}

TEST_CASE("11.4 scrambled fractions have as many first bits in common as before", "[11.4]") {
    rt::Rng random{114, 2};
    for (int length = 0; length < 32; ++length)
        for (int i = 0; i < 60; ++i) {
            // The same up to a bit that is different, and anything after it.
            const std::uint32_t a = random(), bit = 0x80000000u >> length;
            check_common_bits(a, a ^ bit ^ (random() & (bit - 1)), random());
        }
}

TEST_CASE("11.4 the flips of the first bits are random and independent", "[11.4]") {
    constexpr int seeds = 400;
    std::vector<Prefix> prefixes;
    for (int length = 0; length < 4; ++length)
        for (std::uint32_t i = 0; i < 1u << length; ++i)
            prefixes.push_back({length == 0 ? 0 : i << (32 - length), length});
    std::vector<std::vector<unsigned>> flips(prefixes.size());
    rt::Rng random{114, 3};
    for (int i = 0; i < seeds; ++i) {
        const std::uint32_t seed = random();
        for (std::size_t k = 0; k < prefixes.size(); ++k)
            flips[k].push_back(flip(prefixes[k], seed));
    }
    for (std::size_t k = 0; k < prefixes.size(); ++k) {
        int flipped = 0;
        for (const unsigned bit : flips[k]) flipped += static_cast<int>(bit);
        // A fair coin is off by more once in 10^13 times.
        INFO(text(prefixes[k]) << ": " EXPECTED "to be flipped by about half of " << seeds
                               << " random seeds, but your code flips it with " << flipped
                               << "\nHint: the seed must affect each bit, even the first");
        REQUIRE(std::abs(flipped - seeds / 2) < 75);
    }
    for (std::size_t k = 0; k < prefixes.size(); ++k)
        for (std::size_t j = 0; j < k; ++j) {
            int different = 0;
            for (std::size_t i = 0; i < seeds; ++i)
                different += static_cast<int>(flips[k][i] ^ flips[j][i]);
            INFO(text(prefixes[k]) << " and " << text(prefixes[j]) << ", with " << seeds
                                   << " random seeds: " EXPECTED
                                      "exactly one of them to be flipped about half of the time, "
                                      "but with your code that happens "
                                   << different << " times");
            INFO(
                "Hint: one flip determines the other. It is not enough to flip the same bits of "
                "all fractions (a digital shift): whether a bit is flipped must also depend on the "
                "bits before it, in a different way for each seed. So add the seed between the "
                "multiplications, instead of combining it by ^ before or after all of them");
            REQUIRE(is_one_half(different, seeds));
        }
}

TEST_CASE("11.4 every box has one scrambled point of each block", "[11.4]") {
    // As pixels use them: the order of the points is scrambled, too.
    rt::Rng random{114, 4};
    for (int m = 0; m <= 7; ++m)
        for (const std::uint32_t block : {0u, 1u, 6u, 1000u}) {
            const std::uint32_t order = random(), across = random(), down = random();
            std::vector<FixedPoint2> points;
            for (std::uint32_t i = block << m; i < (block + 1) << m; ++i) {
                const FixedPoint2 p = rt::sobol_point(rt::owen_scrambled(i, order));
                points.push_back({rt::owen_scrambled(p.x, across), rt::owen_scrambled(p.y, down)});
            }
            for (int columns = 0; columns <= m; ++columns) {
                std::vector<int> counts(std::size_t{1} << m);
                for (const FixedPoint2& p : points) {
                    const std::uint64_t column = std::uint64_t{p.x} << columns >> 32;
                    const std::uint64_t row = std::uint64_t{p.y} << (m - columns) >> 32;
                    ++counts[row << columns | column];
                }
                const auto empty = std::count(counts.begin(), counts.end(), 0);
                INFO("points " << (block << m) << " to " << ((block + 1) << m) - 1 << ", "
                               << (1 << columns) << " x " << (1 << (m - columns))
                               << " boxes: " EXPECTED "one point in each, but in yours " << empty
                               << " boxes are empty");
                INFO(
                    "Hint: the points of sobol_point are spread like this, and scrambling must "
                    "keep it. First make the test cases before this one pass");
                REQUIRE(empty == 0);
            }
        }
}

TEST_CASE("11.4 points late in the sequence are correct", "[11.4][hard]") {
    for (int i = 0; i < 32; ++i) {
        check_point(1u << i);
        check_point(0xffffffffu >> i);
    }
    rt::Rng random{114, 5};
    for (int i = 0; i < 100; ++i) check_point(random());
}

TEST_CASE("11.4 neighboring seeds give unrelated points", "[11.4][hard]") {
    constexpr int seeds = 40;
    constexpr std::uint32_t points = 64;
    rt::Rng random{114, 9};
    std::vector<std::uint32_t> all;
    for (int i = 0; i < seeds; ++i) all.push_back(random());
    // Both the coordinates of Sobol's points and their order are scrambled.
    const auto place = [](bool is_index, std::uint32_t i) { return is_index ? i : mirrored(i); };
    for (const bool is_index : {false, true})
        for (std::uint32_t shift = 0; shift < 3; ++shift)
            for (const bool is_later : {false, true}) {
                int same = 0;
                for (const std::uint32_t seed : all)
                    for (std::uint32_t i = 0; i < points; ++i) {
                        const std::uint32_t a = place(is_index, is_later ? i : i + shift);
                        const std::uint32_t b = place(is_index, is_later ? i + shift : i);
                        same += rt::owen_scrambled(a, seed) == rt::owen_scrambled(b, seed + 1);
                    }
                // Two random numbers of 32 bits are the same once in 4 billion times.
                const std::string other = shift ? "i + " + std::to_string(shift) : "i";
                INFO("point " << (is_later ? "i" : other) << " with seed S and point "
                              << (is_later ? other : "i") << " with seed S + 1, for " << seeds
                              << " random S and " << points << " points");
                INFO(EXPECTED "unrelated numbers, but with yours "
                     << same << " of " << seeds * static_cast<int>(points) << " are the same");
                INFO(
                    "Hint: if the seed is added first, S + 1 gives the points of S again, one "
                    "index farther on: the mirrored fraction of point i is i itself. Mix x by a "
                    "multiplication before you add the seed");
                REQUIRE(same < seeds * static_cast<int>(points) / 8);
            }
}

TEST_CASE("11.4 no flip of the first seven bits determines another", "[11.4][hard]") {
    constexpr int words = 32, seeds = 64 * words;
    std::vector<Prefix> prefixes;
    for (int length = 0; length < 7; ++length)
        for (std::uint32_t i = 0; i < 1u << length; ++i)
            prefixes.push_back({length == 0 ? 0 : i << (32 - length), length});
    std::vector<std::array<std::uint64_t, words>> flips(prefixes.size());
    rt::Rng random{114, 10};
    for (int i = 0; i < seeds; ++i) {
        const std::uint32_t seed = random();
        for (std::size_t k = 0; k < prefixes.size(); ++k)
            flips[k][i / 64u] |= std::uint64_t{flip(prefixes[k], seed)} << i % 64;
    }
    double largest = 0;
    for (std::size_t k = 0; k < prefixes.size(); ++k)
        for (std::size_t j = 0; j < k; ++j) {
            int different = 0;
            for (std::size_t i = 0; i < words; ++i)
                different += std::popcount(flips[k][i] ^ flips[j][i]);
            // A correlation of 0.25, which is 11 standard deviations: independent flips of 8001
            // pairs have more once in 10^25 times.
            const double correlation = 1 - 2.0 * different / seeds;
            largest = std::max(largest, std::abs(correlation));
            if (std::abs(correlation) < 0.25) continue;
            INFO(text(prefixes[k]) << " and " << text(prefixes[j]) << ", with " << seeds
                                   << " random seeds: " EXPECTED
                                      "exactly one of them to be flipped about half of the time, "
                                      "but with your code that happens "
                                   << different << " times");
            INFO(
                "Hint: one flip often determines the other. If you use the steps of the comment, "
                "do all of them: add the seed (by += and not by ^=, because a sum carries), and "
                "also multiply x by the seed's upper half, made even");
            REQUIRE(std::abs(correlation) < 0.25);
        }
    CHECK(largest < 0.25);
}

TEST_CASE("11.4 the first seven flips show all patterns equally often", "[11.4][hard]") {
    constexpr int flips = 7, patterns = 1 << flips, each = 256;
    std::array<int, patterns> counts{};
    rt::Rng random{114, 11};
    for (int i = 0; i < each * patterns; ++i) {
        const std::uint32_t seed = random();
        std::size_t pattern = 0;
        for (int length = 0; length < 3; ++length)
            for (std::uint32_t k = 0; k < 1u << length; ++k)
                pattern = pattern << 1 | flip({length == 0 ? 0 : k << (32 - length), length}, seed);
        ++counts[pattern];
    }
    const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
    const auto never = std::count(counts.begin(), counts.end(), 0);
    INFO(
        "the first bit has one flip, the second two and the third four, one for each choice of "
        "the bits before it; with "
        << each * patterns << " random seeds: " EXPECTED "each of the " << patterns
        << " patterns of these seven flips about " << each << " times, but with yours " << never
        << " never occur, and the others up to " << *most << " times");
    INFO(
        "Hint: three flips may be related although any two of them are not. Few bits of the seed "
        "reach the first bits: do all the steps of the comment, each of which uses the seed in a "
        "different way");
    // Of 128 fair counts, one is off by half once in 10^13 times.
    REQUIRE(*least > each / 2);
    REQUIRE(*most < each + each / 2);
}

TEST_CASE("11.4 each flip depends on each bit before it", "[11.4][hard]") {
    constexpr int trials = 256;
    rt::Rng random{114, 6};
    for (int bit = 0; bit < 32; ++bit) {
        int flipped = 0;
        for (int i = 0; i < trials; ++i)
            flipped += static_cast<int>(flip({random(), bit}, random()));
        // A fair coin is off by more once in 10^14 times.
        {
            INFO("bit " << bit << " of the fraction, where 0 is its first one: " EXPECTED "to be "
                        << "flipped half of the time, but your code flips it " << flipped
                        << " times of " << trials
                        << "\nHint: every bit is flipped or not, from the first to the last one");
            REQUIRE(std::abs(flipped - trials / 2) < 64);
        }
        for (int before = 0; before < bit; ++before) {
            int changed = 0;
            for (int i = 0; i < trials; ++i) {
                const std::uint32_t a = random(), b = a ^ 0x80000000u >> before, seed = random();
                changed += static_cast<int>(flip({a, bit}, seed) ^ flip({b, bit}, seed));
            }
            if (is_one_half(changed, trials)) continue;
            INFO("bit " << bit << " of two fractions that differ in bit " << before
                        << " (0 is the first one): " EXPECTED
                           "exactly one of them to be flipped about half of the time, but with "
                           "your code that happens "
                        << changed << " times of " << trials);
            INFO(
                "Hint: a flip depends on all bits before it. One multiplication by an even number "
                "is not enough to bring them all together");
            REQUIRE(is_one_half(changed, trials));
        }
    }
}

TEST_CASE("11.4 three flips do not determine a fourth", "[11.4][hard]") {
    constexpr int trials = 256;
    rt::Rng random{114, 7};
    for (int bit = 4; bit < 32; ++bit) {
        int odd = 0;
        for (int i = 0; i < trials; ++i) {
            const std::uint32_t a = random(), b = random(), c = random(), seed = random();
            odd += static_cast<int>(flip({a, bit}, seed) ^ flip({b, bit}, seed) ^
                                    flip({c, bit}, seed) ^ flip({a ^ b ^ c, bit}, seed));
        }
        INFO("bit " << bit << " (0 is the first one) of four fractions a, b, c and a ^ b ^ c: "
                    << EXPECTED
             "an odd number of them to be flipped about half of the time, but with yours that "
             "happens "
                    << odd << " times of " << trials);
        INFO(
            "Hint: a flip that is an exclusive or of bits of the fraction and of the seed is not "
            "random enough; a product carries, and mixes them");
        REQUIRE(is_one_half(odd, trials));
    }
}

TEST_CASE("11.4 each bit of the seed changes the scrambling", "[11.4][hard]") {
    rt::Rng random{114, 8};
    for (int bit = 0; bit < 32; ++bit) {
        int different = 0;
        for (int i = 0; i < 100; ++i) {
            const std::uint32_t fraction = random(), seed = random();
            different += rt::owen_scrambled(fraction, seed) !=
                         rt::owen_scrambled(fraction, seed ^ 1u << bit);
        }
        INFO("bit "
             << bit << " of the seed, where 0 is the last one: " EXPECTED "a different scrambling "
             << "with it than without it, but 100 fractions become the same with yours\nHint: the "
                "seed has 32 bits, and each seed gives a different scrambling");
        REQUIRE(different > 0);
    }
}
