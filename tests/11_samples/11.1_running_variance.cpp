#include <rt/rng.hpp>
#include <rt/running_variance.hpp>
#include <vector>

#include "checkpoint.hpp"
#include "random_inputs.hpp"
#include "single_precision.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::RunningVariance;

namespace {

using Numbers = std::vector<Real>;

// Up to eight of the numbers.
std::string text(const Numbers& numbers) {
    std::string all;
    for (std::size_t i = 0; i < numbers.size() && i < 8; ++i)
        all += (i > 0 ? ", " : "") + checkpoint::text(numbers[i]);
    return '{' + all + (numbers.size() > 8 ? ", ... }" : "}");
}
std::string text(const RunningVariance& known) {
    return "count " + std::to_string(known.count) + ", mean " + checkpoint::text(known.mean) +
           ", squares " + checkpoint::text(known.squares);
}

RunningVariance known_of(const Numbers& numbers) {
    RunningVariance known;
    for (const Real number : numbers) rt::add(known, number);
    return known;
}

struct Exactly {
    Exact mean, squares;
};
Exactly exactly(const Numbers& numbers) {
    const auto count = static_cast<double>(numbers.size());
    Exactly all;
    for (const Real number : numbers) all.mean = all.mean + Exact(number);
    all.mean = all.mean / Exact(count);
    for (const Real number : numbers) {
        const Exact distance = Exact(number) - all.mean;
        all.squares = all.squares + distance * distance;
    }
    return all;
}

const char* const plain_hint =
    "squares grows by a product: the number's distance from the old mean times its distance from "
    "the new mean";
const char* const cancels_hint =
    "if the numbers are far larger than the distances between them, the sum of their squares and "
    "the square of their sum are almost equal, and their difference has no digits left. Subtract "
    "the mean first, then multiply";
const char* const divisor_hint =
    "the variance is squares / (count - 1). The numbers lie nearer to their own mean than to the "
    "true mean, and "
    "dividing by one less makes up for that";

// Compares what is known of the numbers with their exact mean and squares. Every step may round the
// mean once or twice, which moves a mean by half a unit of the largest number and hardly shows in
// the distances. Four right ways were tried on 20,000 lists of 2 to 5000 numbers: the root mean
// square of the distances was off by 1.4 sqrt(n) units at most. Here 6 are allowed.
void check_known(const RunningVariance& known, const Numbers& numbers, const char* hint) {
    const auto count = static_cast<double>(numbers.size());
    const auto [mean, squares] = exactly(numbers);
    double largest = 0;
    for (const Real number : numbers)
        largest = std::max(largest, static_cast<double>(std::abs(number)));
    const double unit = static_cast<double>(rt::epsilon) / 2 * largest;
    INFO(numbers.size() << " numbers " << text(numbers));
    {
        INFO("Hint: the count starts at 0, and every number adds 1");
        REQUIRE(known.count == static_cast<std::int64_t>(numbers.size()));
    }
    if (!(std::abs((mean - Exact(known.mean)).high) <= (count + 4) * unit)) {
        const char* words =
            "a new number moves the mean by its distance from the mean, divided by the count that "
            "includes the new number";
        if (only_single_precision(known.mean, mean.high)) words = single_precision_hint;
        INFO(EXPECTED "the mean " << checkpoint::text(mean) << ", " ACTUAL
                                  << checkpoint::text(known.mean) << ".\nHint: " << words);
        REQUIRE("mean " + checkpoint::text(known.mean) == "mean " + checkpoint::text(mean));
    }
    const auto deviation = [&](double sum) { return std::sqrt(sum / count); };
    const double actual = deviation(static_cast<double>(known.squares));
    if (!(std::abs(actual - deviation(squares.high)) <= 6 * std::sqrt(count) * unit)) {
        if (hint == plain_hint && only_single_precision(known.squares, squares.high))
            hint = single_precision_hint;
        INFO(EXPECTED "the member squares " << checkpoint::text(squares) << ", " ACTUAL
                                            << checkpoint::text(known.squares)
                                            << ".\nHint: " << hint);
        REQUIRE("squares " + checkpoint::text(known.squares) ==
                "squares " + checkpoint::text(squares));
    }
}

void check_variance(const RunningVariance& known, Exact expected, const char* hint) {
    const Real actual = rt::variance(known);
    const bool is_right = error_in_ulp(actual, expected) <= 2;
    if (!is_right) {
        if (hint == divisor_hint && only_single_precision(actual, expected.high))
            hint = single_precision_hint;
        INFO(text(known));
        HINT(expected, actual, hint);
        REQUIRE(checkpoint::text(actual) == checkpoint::text(expected));
    }
    CHECK(is_right);
}

// Numbers of several kinds: spread evenly, only 0 and 1, mostly small and sometimes bright.
Numbers some_numbers(rt::Rng& rng, std::size_t size, Real scale) {
    const unsigned kind = rng() % 4;
    Numbers numbers(size);
    for (Real& number : numbers) {
        const Real x = rng.uniform();
        number = scale * (kind == 0   ? x
                          : kind == 1 ? 2 * x - 1
                          : kind == 2 ? Real(x < Real(0.2))
                                      : std::pow(Real(10), 4 * x - 2));
    }
    return numbers;
}

}  // namespace

TEST_CASE("11.1 count and mean and squares are correct for a few numbers", "[11.1]") {
    // 4, 7, 13, 16: means 4, 5.5, 8, 10, and squares 0, 4.5, 42, 90.
    const std::vector<Numbers> lists{{4, 7, 13, 16},
                                     {3, 5},
                                     {-3, 5},
                                     {5, -3},
                                     {-1, -4, -10},
                                     {0, 0, 6},
                                     {2, 2, 2, 2},
                                     {-7},
                                     {0},
                                     {1, 0, 1},
                                     {8, 0, 0, 0},
                                     {0, 0, 0, 8},
                                     {-2, 0, 2},
                                     {Real(0.5), Real(0.25)}};
    for (const Numbers& list : lists) {
        Numbers so_far;
        RunningVariance known;
        for (const Real number : list) {
            so_far.push_back(number);
            rt::add(known, number);
            check_known(known, so_far, plain_hint);
        }
    }
}

TEST_CASE("11.1 one more number updates count and mean and squares", "[11.1]") {
    struct Case {
        RunningVariance before;
        Real number;
        RunningVariance after;
    };
    for (const auto& [before, number, after] :
         {Case{{4, 10, 20}, 15, {5, 11, 40}}, Case{{1, 3, 0}, 7, {2, 5, 8}},
          Case{{3, -6, 12}, 2, {4, -4, 60}}, Case{{9, 2, 7}, 2, {10, 2, 7}},
          Case{{99, 50, 0}, -50, {100, 49, 9900}}, Case{{0, 0, 0}, -5, {1, -5, 0}}}) {
        RunningVariance known = before;
        rt::add(known, number);
        INFO(text(before) << ", then the number " << number << ": " EXPECTED << text(after)
                          << ", " ACTUAL << text(known) << ".\nHint: " << plain_hint);
        const auto is_near = [](Real a, Real b) {
            return std::abs(a - b) <= 8 * rt::epsilon * std::abs(b);
        };
        const bool is_right = known.count == after.count && is_near(known.mean, after.mean) &&
                              is_near(known.squares, after.squares);
        if (!is_right) REQUIRE(text(known) == text(after));
        CHECK(is_right);
    }
}

TEST_CASE("11.1 the variance divides by one less than the count", "[11.1]") {
    check_variance({2, 5, 8}, 8, divisor_hint);
    check_variance({4, 10, 90}, 30, divisor_hint);
    check_variance({3, -6, 12}, 6, divisor_hint);
    check_variance({101, 1, 25}, Exact(25) / Exact(100), divisor_hint);
    check_variance({17, 1, 0}, 0, divisor_hint);
    rt::Rng rng{111, 1};
    for (int i = 0; i < 500; ++i) {
        const auto count = static_cast<std::int64_t>(2 + rng() % 5000);
        const RunningVariance known{count, any_number(rng, -3, 3), any_size(rng, -6, 6)};
        check_variance(known, Exact(known.squares) / Exact(count - 1), divisor_hint);
    }
}

TEST_CASE("11.1 the variance of two throws of a die is right on average", "[11.1]") {
    // All throws of two and of three dice: each is as likely as any other.
    for (const int dice : {2, 3}) {
        const int throws = dice == 2 ? 36 : 216;
        Exact sum;
        for (int i = 0; i < throws; ++i) {
            RunningVariance known;
            for (int k = 0, rest = i; k < dice; ++k, rest /= 6)
                rt::add(known, static_cast<Real>(1 + rest % 6));
            sum = sum + Exact(rt::variance(known));
        }
        const Exact expected = Exact(35) / Exact(12), mean = sum / Exact(throws);
        const bool is_right =
            std::abs((mean - expected).high) <= 32 * static_cast<double>(rt::epsilon);
        INFO("the mean of the variances of all " << throws << " throws of " << dice << " dice");
        HINT(expected, mean,
             "the variance of one die is 35 / 12, and the estimates must have that mean. "
             "squares / count is too small by the factor (count - 1) / count");
        if (!is_right) REQUIRE(checkpoint::text(mean) == checkpoint::text(expected));
        CHECK(is_right);
    }
}

TEST_CASE("11.1 the variance of fewer than two numbers is infinite", "[11.1]") {
    const auto check = [](const RunningVariance& known) {
        const Real actual = rt::variance(known);
        INFO(text(known));
        HINT(rt::infinity, actual,
             "fewer than two numbers do not tell how far numbers scatter. 0 would claim that all "
             "numbers are alike, and 0 / 0 is NaN");
        REQUIRE(checkpoint::text(actual) == checkpoint::text(rt::infinity));
    };
    check({});
    check({1, 5, 0});
    check(known_of({0}));
    check(known_of({Real(-2.5)}));
    check({1, 0, 3});
}

TEST_CASE("11.1 mean and variance are correct for many kinds of numbers", "[11.1]") {
    rt::Rng rng{111, 2};
    for (int i = 0; i < 300; ++i) {
        const std::size_t size = i < 100 ? 1 + rng() % 9 : 1 + rng() % 1000;
        const Real scale = any_number(rng, -2, 2);
        const Numbers numbers = some_numbers(rng, size, scale);
        const RunningVariance known = known_of(numbers);
        check_known(known, numbers, plain_hint);
        if (size > 1)
            check_variance(known, Exact(known.squares) / Exact(static_cast<double>(size - 1)),
                           divisor_hint);
    }
}

TEST_CASE("11.1 several running variances do not affect each other", "[11.1]") {
    rt::Rng rng{111, 3};
    std::vector<Numbers> numbers(20);
    std::vector<RunningVariance> known(20);
    for (int i = 0; i < 2000; ++i) {
        const std::size_t place = rng() % 20;
        numbers[place].push_back(any_number(rng, -1, 1));
        rt::add(known[place], numbers[place].back());
        if (i % 3 == 0) rt::variance(known[rng() % 20]);
    }
    for (std::size_t i = 0; i < 20; ++i)
        check_known(known[i], numbers[i], "keep everything in `known`: use no static variable");
}

TEST_CASE("11.1 mean and squares are accurate for numbers far from zero", "[11.1][hard]") {
    rt::Rng rng{111, 4};
    const Real most = for_this_precision(Real(3), Real(9));
    for (int i = 0; i < 200; ++i) {
        const Real far = any_number(rng, most - 1, most);
        const std::size_t size = 2 + rng() % 200;
        Numbers numbers = some_numbers(rng, size, 1);
        for (Real& number : numbers) number += far;
        check_known(known_of(numbers), numbers, cancels_hint);
    }
    const Real far = std::pow(Real(10), most);
    const Numbers numbers{far + 4, far + 7, far + 13, far + 16};
    check_known(known_of(numbers), numbers, cancels_hint);
    check_known(known_of({-far, -far - 2}), {-far, -far - 2}, cancels_hint);
}

TEST_CASE("11.1 squares is 0 for equal numbers up to rounding", "[11.1][hard]") {
    rt::Rng rng{111, 5};
    for (int i = 0; i < 200; ++i) {
        const std::size_t size = 2 + rng() % 200;
        const Numbers numbers(size, any_number(rng, -8, 8));
        check_known(known_of(numbers), numbers, cancels_hint);
    }
}

TEST_CASE("11.1 the variance is accurate for a million numbers", "[11.1][hard]") {
    // 1000 + 1, 1000 - 1 and so on: each is 1 off the mean, but for the last of an odd count.
    RunningVariance known;
    for (int count = 1; count <= 1'000'000; ++count) {
        rt::add(known, count % 2 ? Real(1001) : Real(999));
        if (count % 100'000 > 0) continue;
        const Real expected = static_cast<Real>(count) / static_cast<Real>(count - 1);
        const Real actual = rt::variance(known);
        INFO(count << " numbers, alternately 1001 and 999");
        HINT(expected, actual, plain_hint);
        const bool is_right =
            std::abs(actual / expected - 1) <= static_cast<Real>(count) * rt::epsilon;
        REQUIRE(is_right);
    }
}

TEST_CASE("11.1 the variance is accurate for numbers of all sizes", "[11.1][hard]") {
    rt::Rng rng{111, 6};
    const Real most = for_this_precision(Real(16), Real(150));
    for (int i = 0; i < 300; ++i) {
        const std::size_t size = 2 + rng() % 50;
        const Real scale = any_number(rng, -most, most);
        const Numbers numbers = some_numbers(rng, size, scale);
        check_known(known_of(numbers), numbers,
                    "the squares of these numbers fit into a Real, their fourth powers do not. "
                    "Nothing here is too small to count");
    }
    for (int i = 0; i < 100; ++i) {
        const RunningVariance known{3, 0, any_size(rng, -2 * most, 2 * most)};
        check_variance(known, Exact(known.squares) / Exact(2), divisor_hint);
    }
    // One number that is far brighter than all others, at the start and at the end.
    Numbers numbers(60, 1);
    numbers.front() = 1000;
    check_known(known_of(numbers), numbers, plain_hint);
    std::swap(numbers.front(), numbers.back());
    check_known(known_of(numbers), numbers, plain_hint);
}

TEST_CASE("11.1 the count may exceed the largest int", "[11.1][hard]") {
    const char* const hint =
        "the count is a std::int64_t: convert it to a Real, not to an int or a float";
    for (const std::int64_t count :
         {16'777'217LL, 123'456'789LL, 3'000'000'001LL, 5'000'000'000'001LL}) {
        const auto all = static_cast<double>(count);
        check_variance({count, 1, 1000}, Exact(1000) / Exact(all - 1), hint);
        RunningVariance known{count - 1, 0, 0};
        const Real number = std::ldexp(Real(3), 20);
        rt::add(known, number);
        INFO(text(RunningVariance{count - 1, 0, 0}) << ", then the number " << number);
        {
            INFO("Hint: " << hint);
            REQUIRE(known.count == count);
        }
        const Exact mean = Exact(number) / Exact(all);
        if (error_in_ulp(known.mean, mean) > 4) {
            HINT(mean, known.mean, hint);
            REQUIRE(checkpoint::text(known.mean) == checkpoint::text(mean));
        }
        const Exact squares = Exact(number) * Exact(number) * Exact(all - 1) / Exact(all);
        if (error_in_ulp(known.squares, squares) > 8) {
            HINT(squares, known.squares, hint);
            REQUIRE(checkpoint::text(known.squares) == checkpoint::text(squares));
        }
    }
}
