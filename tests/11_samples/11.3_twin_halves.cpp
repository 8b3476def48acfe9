#include <rt/rng.hpp>
#include <rt/standard_error.hpp>
#include <rt/twin_halves.hpp>
#include <vector>

#include "checkpoint.hpp"
#include "random_inputs.hpp"
#include "single_precision.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::CountLimits, rt::Halves;

namespace {

constexpr Real largest = std::numeric_limits<Real>::max();
constexpr Real smallest = std::numeric_limits<Real>::min();  // of those with all digits
constexpr int most_of_all = std::numeric_limits<int>::max();

// How many samples a place is worth: from fewest to greatest. They differ only
// where rounding decides.
struct Expected {
    int fewest, greatest;
};

// share * spread * mean_spread / error^2, rounded up and within the limits, up to a few roundings.
// The exponents are computed apart from the rest, so nothing overflows or underflows.
Expected exact_worth(Real spread, Real mean_spread, Real error, CountLimits limits, double share) {
    int of_spread = 0, of_mean = 0, of_error = 0;
    const Exact a = std::frexp(spread, &of_spread), b = std::frexp(mean_spread, &of_mean),
                c = std::frexp(error, &of_error);
    const double ratio = (Exact(share) * a * b / (c * c)).high;
    const auto limited = [&](double factor) {
        const double wanted =
            std::ceil(std::ldexp(ratio * factor, of_spread + of_mean - 2 * of_error));
        return static_cast<int>(std::clamp<double>(wanted, limits.least, limits.most));
    };
    const double off = 8 * static_cast<double>(rt::epsilon);
    return {limited(1 - off), limited(1 + off)};
}

// The one of the two that an answer misses.
int missed(int actual, Expected expected) {
    return actual < expected.fewest ? expected.fewest : expected.greatest;
}
bool is_right(int actual, Expected expected) {
    return expected.fewest <= actual && actual <= expected.greatest;
}

const char* const worth_hint =
    "take samples in proportion to the spread, which is the standard deviation and not the "
    "variance: with n = "
    "spread * mean_spread / error^2 samples, the variance spread^2 / n of a part of the picture is "
    "spread / mean_spread times error^2, whose mean over all parts is error^2. Round up";
const char* const limits_hint = "return at least limits.least and at most limits.most";
const char* const overflow_hint =
    "error * error overflows or underflows here, or the result does not fit into an int. Divide "
    "each spread by the error, and compare with the limits before you convert a Real to an int";
void check_worth(Real spread, Real mean_spread, Real error, CountLimits limits, Expected expected,
                 const char* hint) {
    const int actual = rt::worth_of(spread, mean_spread, error, limits);
    const bool right = is_right(actual, expected);
    if (!right) {
        const bool at_limit = actual <= limits.least || actual >= limits.most;
        INFO("spread " << text(spread) << ", mean spread " << text(mean_spread) << ", error "
                       << text(error) << ", from " << limits.least << " to " << limits.most
                       << " samples");
        INFO(EXPECTED << missed(actual, expected) << ", " ACTUAL << actual
                      << ".\nHint: " << (hint == worth_hint && at_limit ? limits_hint : hint));
        REQUIRE(std::to_string(actual) == std::to_string(missed(actual, expected)));
    }
    CHECK(right);
}

std::string both_counts(Halves<int> counts) {
    return std::to_string(counts.first) + " in the first half and " +
           std::to_string(counts.second) + " in the second";
}

const char* const crossed_hint =
    "the second half's samples decide how many the first half takes, and vice versa: take both the "
    "spread and the mean spread from the other half";
const char* const each_hint =
    "the mean of two independent halves has half their variance: each half may have sqrt(2) times "
    "the requested error, so it takes half as many samples as it would alone";

void check_counts(Halves<Real> spread, Halves<Real> mean_spread, Real error, CountLimits limits,
                  const char* hint) {
    const Halves<int> actual = rt::crossed_counts(spread, mean_spread, error, limits);
    struct Pair {
        Expected first, second;
        bool is(Halves<int> counts) const {
            return is_right(counts.first, first) && is_right(counts.second, second);
        }
    };
    // With half the work for each half, 0.5, or all of it.
    const auto crossed = [&](double share) {
        return Pair{exact_worth(spread.second, mean_spread.second, error, limits, share),
                    exact_worth(spread.first, mean_spread.first, error, limits, share)};
    };
    const Pair expected = crossed(0.5);
    const bool right = expected.is(actual);
    if (!right) {
        const auto nearest = [](int count, Expected wanted) {
            return is_right(count, wanted) ? count : missed(count, wanted);
        };
        const Halves<int> wanted{nearest(actual.first, expected.first),
                                 nearest(actual.second, expected.second)};
        const bool single = only_single_precision(actual.first, wanted.first) ||
                            only_single_precision(actual.second, wanted.second);
        const char* const fitting = hint == overflow_hint && single ? single_precision_hint
                                    : Pair{expected.second, expected.first}.is(actual)
                                        ? crossed_hint
                                    : crossed(1).is(actual) || crossed(0.25).is(actual) ? each_hint
                                                                                        : hint;
        INFO("spread " << text(spread.first) << " in the first half and " << text(spread.second)
                       << " in the second, mean spread " << text(mean_spread.first) << " and "
                       << text(mean_spread.second) << ", error " << text(error) << ", from "
                       << limits.least << " to " << limits.most << " samples");
        INFO(EXPECTED << both_counts(wanted) << ", " ACTUAL << both_counts(actual)
                      << ".\nHint: " << fitting);
        REQUIRE(both_counts(actual) == both_counts(wanted));
    }
    CHECK(right);
}

// A place where one sample in sixteen is bright, 16, and the others are 0. The mean is 1.
Real rare_light(rt::Rng& rng) {
    return rng() % 16 == 0 ? Real(16) : Real(0);
}

// The mean over a picture of 64 such places, drawn in two halves: after the pilot, crossed_counts
// says how many samples each half takes of a place in all.
double mean_of_picture(rt::Rng& rng, int pilot) {
    constexpr std::size_t places = 64;
    constexpr int most = 1000;  // however much a wrong answer asks for
    std::vector<Halves<rt::RunningVariance>> seen(places);
    Halves<Real> mean_spread;
    const auto spread = [](const rt::RunningVariance& half) { return std::sqrt(variance(half)); };
    for (auto& [first, second] : seen) {
        for (int i = 0; i < pilot; ++i) {
            rt::add(first, rare_light(rng));
            rt::add(second, rare_light(rng));
        }
        mean_spread.first += spread(first) / Real(places);
        mean_spread.second += spread(second) / Real(places);
    }
    double sum = 0;
    for (auto& [first, second] : seen) {
        const Halves<int> counts = rt::crossed_counts({spread(first), spread(second)}, mean_spread,
                                                      Real(0.5), {pilot, most});
        while (first.count < std::min(counts.first, most)) rt::add(first, rare_light(rng));
        while (second.count < std::min(counts.second, most)) rt::add(second, rare_light(rng));
        sum += static_cast<double>(rt::twin_mean({first.mean, second.mean}));
    }
    return sum / static_cast<double>(places);
}

}  // namespace

TEST_CASE("11.3 a part of the picture gets samples in proportion to its spread", "[11.3]") {
    const CountLimits any{1, 1'000'000};
    const auto check = [&](Real spread, Real mean_spread, Real error, int expected) {
        check_worth(spread, mean_spread, error, any, {expected, expected}, worth_hint);
    };
    check(2, 2, 1, 4);
    check(2, 3, 1, 6);
    check(6, 3, 1, 18);
    check(6, 1, 1, 6);
    check(1, 6, 1, 6);
    check(3, 5, 2, 4);  // 3.75
    check(2, 3, Real(0.5), 24);
    check(2, 3, Real(0.25), 96);
    check(1, 1, 2, 1);
    check(0, 3, 1, 1);
    rt::Rng rng{113, 1};
    for (int i = 0; i < 1000; ++i) {
        const Real error = any_size(rng, -3, 3), spread = error * any_size(rng, 0, 2),
                   mean_spread = error * any_size(rng, 0, i % 2 ? 1 : 3);
        check_worth(spread, mean_spread, error, any,
                    exact_worth(spread, mean_spread, error, any, 1), worth_hint);
    }
}

TEST_CASE("11.3 no part gets fewer or more samples than the limits allow", "[11.3]") {
    const auto check = [](Real spread, Real mean_spread, CountLimits limits, int expected) {
        check_worth(spread, mean_spread, 1, limits, {expected, expected}, limits_hint);
    };
    check(2, 3, {8, 64}, 8);
    check(0, 3, {8, 64}, 8);
    check(4, 4, {8, 64}, 16);
    check(40, 4, {8, 64}, 64);
    check(2, 4, {8, 64}, 8);
    check(16, 4, {8, 64}, 64);
    check(9, 1, {8, 64}, 9);
    check(63, 1, {8, 64}, 63);
    check(1, 1, {5, 5}, 5);
    check(9, 1, {5, 5}, 5);
    check(1000, 1000, {1, 1}, 1);
    rt::Rng rng{113, 2};
    for (int i = 0; i < 500; ++i) {
        const int least = static_cast<int>(1 + rng() % 100);
        const CountLimits limits{least, least + static_cast<int>(rng() % 1000)};
        const Real spread = any_size(rng, -1, 3), mean_spread = any_size(rng, -1, 2);
        check_worth(spread, mean_spread, 1, limits, exact_worth(spread, mean_spread, 1, limits, 1),
                    limits_hint);
    }
}

TEST_CASE("11.3 each half decides how many samples the other half takes", "[11.3]") {
    const CountLimits any{1, 1'000'000};
    check_counts({3, 0}, {5, 5}, 1, any, crossed_hint);  // 7.5 for the second half
    check_counts({0, 3}, {5, 5}, 1, any, crossed_hint);
    check_counts({3, 9}, {5, 5}, 1, any, crossed_hint);
    check_counts({3, 3}, {5, 11}, 1, any, crossed_hint);
    check_counts({3, 3}, {11, 5}, 1, any, crossed_hint);
    check_counts({0, 300}, {50, 50}, 1, {4, 64}, crossed_hint);
    rt::Rng rng{113, 3};
    for (int i = 0; i < 500; ++i) {
        const Real error = any_size(rng, -3, 3);
        const Halves<Real> spread{error * any_size(rng, 0, 2), error * any_size(rng, 0, 2)},
            mean_spread{error * any_size(rng, 0, 2), error * any_size(rng, 0, 2)};
        const int least = static_cast<int>(1 + rng() % 20);
        check_counts(spread, mean_spread, error, i % 2 ? any : CountLimits{least, 10 * least},
                     crossed_hint);
    }
}

TEST_CASE("11.3 both halves together reach the requested error", "[11.3]") {
    const CountLimits any{1, 1'000'000'000};
    check_counts({3, 3}, {5, 5}, 1, any, each_hint);
    check_counts({3, 3}, {5, 5}, Real(0.125), any, each_hint);
    // Places of many spreads, which both halves know: the error of their means is then known, too.
    rt::Rng rng{113, 4};
    for (int i = 0; i < 20; ++i) {
        const int places = 200;
        std::vector<Real> spreads(places);
        Real mean_spread = 0;
        for (Real& spread : spreads) {
            spread = any_size(rng, -1, 1);
            mean_spread += spread / Real(places);
        }
        const Real error = any_size(rng, Real(-3.5), -3);
        double square_error = 0;
        for (const Real spread : spreads) {
            const auto [first, second] =
                rt::crossed_counts({spread, spread}, {mean_spread, mean_spread}, error, any);
            const double variance = static_cast<double>(spread) * static_cast<double>(spread);
            square_error += variance * (1.0 / first + 1.0 / second) / 4 / places;
        }
        const double actual = std::sqrt(square_error) / static_cast<double>(error);
        // Each count is rounded up from 10,000 or more.
        INFO(places << " parts with spreads of 0.1 to 10: with your counts the error of the whole "
                       "picture is "
                    << actual << " times the requested error.\nHint: " << each_hint);
        REQUIRE(actual > 0.9999);
        REQUIRE(actual < 1.0001);
    }
}

TEST_CASE("11.3 rare light is correct on average", "[11.3]") {
    // Right code fails with two seeds in a million: three times 5 standard errors. Halves that
    // decide for themselves are off by 80 or more.
    for (const int pilot : {2, 3, 4}) {
        rt::Rng rng{113, 10 + static_cast<std::uint64_t>(pilot)};
        Mean mean;
        for (int picture = 0; picture < 150; ++picture) mean.add(mean_of_picture(rng, pilot));
        INFO(
            "one sample in sixteen is 16, and the others are 0: the mean of 150 pictures "
            "of 64 parts must be 1, give or take "
            << mean.standard_error() << ". With a pilot of " << pilot
            << " samples in each half it is " << mean.mean());
        INFO(
            "Hint: a half must not stop because its own samples have been dark so far: it would "
            "never see the light. If its samples decide about the other half instead, both stay "
            "unbiased");
        REQUIRE(std::abs(mean.mean() - 1) <= 5 * mean.standard_error());
    }
}

TEST_CASE("11.3 the mean of both halves and its error are correct", "[11.3]") {
    const auto check_mean = [](Halves<Real> mean, Real expected) {
        const Real actual = rt::twin_mean(mean);
        const Real size = std::max(std::abs(mean.first), std::abs(mean.second));
        if (std::abs(actual - expected) <= rt::epsilon * size) return;
        INFO("the halves' means are " << text(mean.first) << " and " << text(mean.second));
        HINT(expected, actual, "both halves have the same weight");
        REQUIRE(text(actual) == text(expected));
    };
    const auto check_error = [](Halves<Real> mean, Real expected) {
        const Real actual = rt::twin_square_error(mean);
        if (std::abs(actual - expected) <= 4 * rt::epsilon * expected) return;
        INFO("the halves' means are " << text(mean.first) << " and " << text(mean.second));
        HINT(expected, actual,
             "the halves err independently, so on average their mean is off by as much as half "
             "their difference. The result is the square of that");
        REQUIRE(text(actual) == text(expected));
    };
    check_mean({2, 6}, 4);
    check_mean({6, 2}, 4);
    check_mean({-3, 1}, -1);
    check_mean({5, 5}, 5);
    check_mean({0, 7}, Real(3.5));
    check_error({2, 6}, 4);
    check_error({6, 2}, 4);
    check_error({-3, 1}, 4);
    check_error({5, 5}, 0);
    check_error({0, 1}, Real(0.25));
    rt::Rng rng{113, 5};
    for (int i = 0; i < 500; ++i) {
        const Real a = any_number(rng, -3, 3), b = any_number(rng, -3, 3);
        check_mean({a, b}, (a + b) / 2);
        const Real whole = static_cast<Real>(rng() % 1000), off = static_cast<Real>(rng() % 1000);
        check_error({whole, whole + 2 * off}, off * off);
        check_error({whole + 2 * off, whole}, off * off);
    }
    // Halves that are off by 3 and by 1, upward or downward: the estimate is right on average.
    Real square_error = 0, estimate = 0;
    for (const Real first : {Real(7), Real(13)})
        for (const Real second : {Real(9), Real(11)}) {
            const Real off = rt::twin_mean({first, second}) - 10;
            square_error += off * off / 4;
            estimate += rt::twin_square_error({first, second}) / 4;
        }
    INFO("two halves are off by 3 and by 1, each upward as often as downward");
    HINT(square_error, estimate, "the result is the square of half the difference");
    REQUIRE(text(estimate) == text(square_error));
}

TEST_CASE("11.3 unknown spreads get the most samples and spreads of 0 the fewest", "[11.3][hard]") {
    const char* const hint =
        "an unknown spread is infinite, and such a part gets the most samples. A spread of 0 gets "
        "the fewest, even if the mean spread is infinite";
    for (const CountLimits limits : {CountLimits{2, 50}, {1, most_of_all}, {7, 7}}) {
        const Expected least{limits.least, limits.least}, most{limits.most, limits.most};
        for (const Real error : {smallest, Real(0.01), Real(1), largest / 4}) {
            for (const Real mean_spread : {smallest, Real(1), largest, rt::infinity}) {
                check_worth(rt::infinity, mean_spread, error, limits, most, hint);
                check_worth(0, mean_spread, error, limits, least, hint);
            }
            check_worth(0, 0, error, limits, least, hint);
            check_worth(rt::infinity, 0, error, limits, most, hint);
            for (const Real spread : {smallest, Real(1), largest})
                check_worth(spread, rt::infinity, error, limits, most, hint);
        }
    }
    const auto check = [](Halves<Real> spread, Halves<Real> mean_spread, Halves<int> expected) {
        const Halves<int> actual = rt::crossed_counts(spread, mean_spread, 1, {2, 50});
        INFO("spread " << spread.first << " in the first half and " << spread.second
                       << " in the second, mean spread " << mean_spread.first << " and "
                       << mean_spread.second << ", error 1, from 2 to 50 samples");
        INFO(EXPECTED << both_counts(expected) << ", " ACTUAL << both_counts(actual)
                      << ".\nHint: each half decides for the other, whatever its spread is");
        REQUIRE(both_counts(actual) == both_counts(expected));
    };
    const Real unknown = rt::infinity;
    check({unknown, 3}, {unknown, 5}, {8, 50});
    check({3, unknown}, {5, unknown}, {50, 8});
    check({0, 3}, {unknown, 5}, {8, 2});
    check({3, 0}, {5, unknown}, {2, 8});
    check({0, 0}, {0, 0}, {2, 2});
    check({unknown, unknown}, {unknown, unknown}, {50, 50});
}

TEST_CASE("11.3 sample counts are correct for errors and spreads of all sizes", "[11.3][hard]") {
    rt::Rng rng{113, 6};
    const Real size = for_this_precision(Real(34), Real(290));
    const CountLimits any{1, most_of_all};
    for (int i = 0; i < 2000; ++i) {
        const Real error = any_size(rng, -size, size - 6);
        const Real spread = error * any_size(rng, 0, 4), mean_spread = error * any_size(rng, 0, 5);
        check_worth(spread, mean_spread, error, any,
                    exact_worth(spread, mean_spread, error, any, 1), overflow_hint);
        check_counts({spread, mean_spread}, {mean_spread, spread}, error, any, overflow_hint);
    }
    // A place with much less spread than others.
    for (int i = 0; i < 1000; ++i) {
        const Real error = any_size(rng, -size / 4, size / 4);
        const Real low = any_size(rng, -size / 4, 0);
        const Real spread = error * low, mean_spread = error / low * any_size(rng, -1, 8);
        check_worth(spread, mean_spread, error, any,
                    exact_worth(spread, mean_spread, error, any, 1), overflow_hint);
    }
    const Real bit_more =
        1 + for_this_precision(std::ldexp(Real(1), -20), std::ldexp(Real(1), -40));
    check_worth(4, bit_more, 1, any, {5, 5}, "a count even slightly above 4 is rounded up to 5");
    // Finite, but more than an int or even 64 bits can hold.
    for (const Real large : {Real(1e5), Real(1e10), Real(1e15)}) {
        check_worth(large, large, 1, any, {most_of_all, most_of_all}, overflow_hint);
        check_worth(large, large, 1, {3, 9}, {9, 9}, overflow_hint);
        check_counts({large, large}, {large, large}, 1, any, overflow_hint);
    }
    check_worth(largest, largest, largest / 16, any, {256, 256}, overflow_hint);
    check_worth(largest, largest, smallest, any, {most_of_all, most_of_all}, overflow_hint);
    check_worth(largest, 1, smallest, any, {most_of_all, most_of_all}, overflow_hint);
    check_worth(smallest, smallest, largest, any, {1, 1}, overflow_hint);
    check_worth(smallest, smallest, largest, {3, 9}, {3, 3}, overflow_hint);
}

TEST_CASE("11.3 mean and error are accurate for means of all sizes", "[11.3][hard]") {
    const auto check = [](const char* what, Halves<Real> mean, Real actual, Real expected,
                          const char* hint) {
        const bool is_right = std::abs(actual - expected) <= 4 * rt::epsilon * std::abs(expected);
        if (!is_right) {
            INFO(what << " of halves with the means " << text(mean.first) << " and "
                      << text(mean.second));
            HINT(expected, actual, hint);
            REQUIRE(text(actual) == text(expected));
        }
        CHECK(is_right);
    };
    const auto check_mean = [&](Halves<Real> mean, Real expected) {
        check("the mean", mean, rt::twin_mean(mean), expected,
              "the sum of two large numbers may not fit into a Real, although their mean does: "
              "halve each number before you add them");
    };
    check_mean({largest, largest}, largest);
    check_mean({-largest, -largest}, -largest);
    check_mean({largest, largest / 2}, largest / 4 * 3);
    check_mean({largest, -largest}, 0);
    const auto check_error = [&](Halves<Real> mean, Real expected, const char* hint) {
        check("the square error", mean, rt::twin_square_error(mean), expected, hint);
    };
    const Real far = for_this_precision(Real(1 << 23), std::ldexp(Real(1), 52));
    for (const Real sign : {Real(1), Real(-1)}) {
        const char* const hint =
            "subtract first, then square: the squares of two large, almost equal numbers cancel";
        check_error({sign * far, sign * far + 2}, 1, hint);
        check_error({sign * far + 1, sign * far}, Real(0.25), hint);
        check_error({sign * far, sign * far}, 0, hint);
    }
    const Real tiny = std::ldexp(Real(1), for_this_precision(-40, -400));
    check_error({tiny, 3 * tiny}, tiny * tiny, "a small difference counts, too");
    // 2^64 or 2^512: the square of this does not fit, that of half of it does.
    const Real edge = std::ldexp(Real(1), for_this_precision(64, 512));
    check_error({edge, 0}, edge / 2 * (edge / 2), "halve the difference before you square it");
    check_error({-edge / 2, edge / 2}, edge / 2 * (edge / 2),
                "halve the difference before you square it");
}
