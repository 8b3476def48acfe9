#include <rt/rng.hpp>
#include <rt/running_shares.hpp>

#include "checkpoint.hpp"
#include "processor_time.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Pick;

namespace {

using Numbers = std::vector<Real>;

using checkpoint::text;
std::string text(const Numbers& numbers) {
    std::string all;
    for (const Real number : numbers) all += (all.empty() ? "" : ", ") + text(number);
    return '{' + all + '}';
}

// Weights of many sizes, some of them 0, but not the one at `never_zero`.
Numbers random_weights(rt::Rng& rng, std::size_t count, std::size_t never_zero = 0) {
    Numbers weights;
    for (std::size_t i = 0; i < count; ++i)
        weights.push_back(rng() % 4 == 0 && i != never_zero ? Real(0) : any_size(rng, -2, 1));
    return weights;
}

// Shares that anyone may have made, so that pick() is tested alone.
Numbers plain_shares(const Numbers& weights) {
    double sum = 0, all = 0;
    for (const Real weight : weights) all += static_cast<double>(weight);
    Numbers shares;
    for (const Real weight : weights) {
        sum += static_cast<double>(weight);
        shares.push_back(real(sum / all));
    }
    return shares;
}

std::size_t first_above(const Numbers& shares, Real number) {
    std::size_t i = 0;
    while (i < shares.size() && !(shares[i] > number)) ++i;
    return i;
}

void check_pick(const Numbers& shares, Real number, std::size_t expected) {
    const Pick picked = rt::pick(shares, number);
    if (shares.size() <= 8) UNSCOPED_INFO("in the shares " << text(shares));
    INFO("for the number " << text(number) << ": " EXPECTED "entry " << expected << ", " ACTUAL
                           << "entry " << picked.index << "\nHint: the first share that is greater "
                           << "than the number; a share that is equal to it is not");
    REQUIRE(picked.index == expected);
}

void check_shares(const Numbers& weights, const Numbers& expected, Real allowed) {
    const Numbers shares = rt::running_shares(weights);
    if (weights.size() <= 8) UNSCOPED_INFO("of the weights " << text(weights));
    INFO("expected " << expected.size() << " shares, actual " << shares.size());
    REQUIRE(shares.size() == expected.size());
    for (std::size_t i = 0; i < shares.size(); ++i) {
        INFO("share " << i << ": ");
        HINT(expected[i], shares[i],
             "add up the weights from the first to this one, and divide by the sum of all");
        const bool is_near = std::abs(shares[i] - expected[i]) <= allowed;
        REQUIRE(is_near);
    }
}

constexpr Real step = rt::epsilon / 2;

// How many steps the shares of these weights are off, at most.
double worst_of(const Numbers& weights, const Numbers& shares) {
    Exact all, sum;
    double positive = 0, so_far = 0, worst = 0;
    for (const Real weight : weights) {
        all = all + Exact(weight);
        positive += weight > 0;
    }
    const double steps = 1 / static_cast<double>(step);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        sum = sum + Exact(weights[i]);
        so_far += weights[i] > 0;
        const Exact exact = Exact(so_far) + sum / all * (Exact(steps) - Exact(positive));
        worst = std::max(worst, std::abs((exact - Exact(shares[i]) * Exact(steps)).high));
    }
    return worst;
}

}  // namespace

TEST_CASE("14.2 the shares agree with an example on paper", "[14.2]") {
    check_shares({2, 0, 1, 5}, {real(0.25), real(0.25), real(0.375), 1}, 8 * rt::epsilon);
    check_shares({7}, {1}, 8 * rt::epsilon);
    check_shares({1, 1, 1}, {Real(1) / 3, Real(2) / 3, 1}, 8 * rt::epsilon);
}

TEST_CASE("14.2 the shares are sums of weights over the sum of all", "[14.2]") {
    rt::Rng rng{142, 1};
    for (int i = 0; i < 100; ++i) {
        const Numbers weights = random_weights(rng, 1 + rng() % 50);
        check_shares(weights, plain_shares(weights), 100 * rt::epsilon);
    }
}

TEST_CASE("14.2 a probability is a share less the one before", "[14.2]") {
    const Numbers shares{real(0.25), real(0.25), real(0.375), 1};
    const Numbers expected{real(0.25), 0, real(0.125), real(0.625)};
    for (std::size_t i = 0; i < 4; ++i) {
        INFO("entry " << i << " of the shares " << text(shares));
        HINT(expected[i], rt::probability_of(shares, i),
             "share i less share i - 1; nothing comes before entry 0, whose share is its "
             "probability");
        CHECK(rt::probability_of(shares, i) == expected[i]);
    }
    rt::Rng rng{142, 11};
    const Numbers many = plain_shares(random_weights(rng, 100));
    for (std::size_t i = 1; i < many.size(); ++i)
        REQUIRE(rt::probability_of(many, i) == many[i] - many[i - 1]);
}

TEST_CASE("14.2 a number chooses the first share that is greater", "[14.2]") {
    const Numbers shares{real(0.25), real(0.25), real(0.375), 1};
    check_pick(shares, 0, 0);
    check_pick(shares, real(0.1), 0);
    check_pick(shares, real(0.25), 2);
    check_pick(shares, real(0.3), 2);
    check_pick(shares, real(0.375), 3);
    check_pick(shares, real(0.99), 3);
    check_pick({1}, real(0.5), 0);
    rt::Rng rng{142, 2};
    for (int i = 0; i < 200; ++i) {
        const Numbers some = plain_shares(random_weights(rng, 1 + rng() % 40));
        for (int k = 0; k < 50; ++k) {
            const Real number = rng.uniform();
            check_pick(some, number, first_above(some, number));
        }
    }
}

TEST_CASE("14.2 an entry with the weight 0 is never chosen", "[14.2]") {
    const Numbers shares{0, 0, real(0.5), real(0.5), 1, 1};
    check_pick(shares, 0, 2);
    check_pick(shares, real(0.5), 4);
    rt::Rng rng{142, 3};
    const Numbers weights{0, 3, 0, 0, 1, 0}, own = rt::running_shares(weights);
    for (int i = 0; i < 1000; ++i) {
        const Pick picked = rt::pick(own, rng.uniform());
        INFO("of the weights " << text(weights) << ", entry " << picked.index << " was chosen");
        REQUIRE((picked.index == 1 || picked.index == 4));
    }
}

TEST_CASE("14.2 a pick says its probability and the rest of its number", "[14.2]") {
    const Numbers shares{real(0.25), real(0.25), real(0.375), 1};
    struct Expected {
        Real number, probability, rest;
    };
    for (const auto& [number, probability, rest] : {Expected{real(0.125), real(0.25), real(0.5)},
                                                    {real(0.25), real(0.125), 0},
                                                    {real(0.34375), real(0.125), real(0.75)},
                                                    {real(0.6875), real(0.625), real(0.5)}}) {
        const Pick picked = rt::pick(shares, number);
        INFO("for the number " << text(number) << " in the shares " << text(shares));
        {
            HINT(probability, picked.probability, "this is the probability of the chosen entry");
            CHECK(picked.probability == probability);
        }
        HINT(rest, picked.rest,
             "rest is (number - the share before) / probability: 0 at the beginning of the "
             "entry's part");
        CHECK(std::abs(picked.rest - rest) <= 4 * rt::epsilon);
    }
    rt::Rng rng{142, 12};
    const Numbers many = plain_shares(random_weights(rng, 100));
    for (int i = 0; i < 100; ++i) {
        const Pick picked = rt::pick(many, rng.uniform());
        const Real before = picked.index == 0 ? Real(0) : many[picked.index - 1];
        REQUIRE(picked.probability == many[picked.index] - before);
    }
}

TEST_CASE("14.2 entries are chosen as often as their weights say", "[14.2]") {
    // Of 10,000 right answers with a random seed, one would fail.
    rt::Rng rng{142, 4};
    Numbers weights;
    Real all = 0;
    for (int i = 0; i < 64; ++i) {
        weights.push_back(rng.uniform(1, 4));
        all += weights.back();
    }
    const Numbers shares = rt::running_shares(weights);
    constexpr int count = 100'000;
    std::vector<long> chosen(64);
    for (int i = 0; i < count; ++i) ++chosen[rt::pick(shares, rng.uniform()).index];
    std::vector<double> expected;
    for (const Real weight : weights) expected.push_back(static_cast<double>(count * weight / all));
    const double statistic = chi_square(chosen, expected);
    INFO(pictured(chosen, expected, 64));
    INFO("100,000 picks among 64 weights: entry 0 was chosen "
         << chosen[0] << " times, and " << expected[0] << " was expected; entry 63 " << chosen[63]
         << " times, and " << expected[63] << " was expected");
    INFO("chi-square is " << statistic << ", and of right answers one in 10,000 is above "
                          << chi_square_limit(63));
    CHECK(statistic < chi_square_limit(63));
}

TEST_CASE("14.2 bisection finds an entry among a million in few steps", "[14.2]") {
    const auto seconds = [](std::size_t count) {
        Numbers shares;
        for (std::size_t i = 1; i <= count; ++i)
            shares.push_back(static_cast<Real>(i) / static_cast<Real>(count));
        rt::Rng rng{142, 5};
        std::size_t sum = 0;
        const double before = processor_seconds();
        for (int i = 0; i < 4000; ++i) sum += rt::pick(shares, rng.uniform()).index;
        const double after = processor_seconds();
        CHECK(sum > 0);
        return after - before;
    };
    const double few = seconds(1000), many = seconds(1'000'000);
    INFO("4000 picks took " << few << " s among a thousand shares, and " << many
                            << " s among a million");
    INFO("Hint: do not ask one share after the other; halve the part in which the entry lies");
    CHECK(many < 100 * few + 0.001);
}

TEST_CASE("14.2 without any weight above 0 there is nothing to choose", "[14.2][hard]") {
    for (const Numbers& weights : {Numbers{}, Numbers{0}, Numbers{0, 0, 0}}) {
        const Numbers shares = rt::running_shares(weights);
        INFO("of the weights " << text(weights) << ": the shares " << text(shares));
        INFO(
            "Hint: 0 / 0 is NaN; if the sum is 0, all shares are 0, and pick finds no share that "
            "is greater than its number");
        REQUIRE(shares == Numbers(weights.size(), 0));
        for (const Real number : {Real(0), real(0.5), 1 - step})
            CHECK(rt::pick(shares, number).probability == 0);
    }
}

TEST_CASE("14.2 the last share is exactly 1", "[14.2][hard]") {
    rt::Rng rng{142, 6};
    for (int i = 0; i < 1000; ++i) {
        Numbers weights = random_weights(rng, 1 + rng() % 100);
        weights.resize(weights.size() + rng() % 3);  // zeros at the end
        const Numbers shares = rt::running_shares(weights);
        HINT(Real(1), shares.back(),
             "sums that are rounded in different ways differ: the last sum and the sum of all must "
             "be the same number");
        REQUIRE(shares.back() == 1);
        const Pick last = rt::pick(shares, 1 - step);
        REQUIRE(last.probability > 0);
        REQUIRE(weights[last.index] > 0);
    }
}

TEST_CASE("14.2 weights whose sum overflows have shares", "[14.2][hard]") {
    const Real most = std::numeric_limits<Real>::max();
    INFO("Hint: divide the weights by the largest of them before you add them up");
    check_shares({most, most, most, most}, {real(0.25), real(0.5), real(0.75), 1}, 8 * rt::epsilon);
    const Real least = std::numeric_limits<Real>::min();
    check_shares({least, 3 * least}, {real(0.25), 1}, 8 * rt::epsilon);
}

TEST_CASE("14.2 each share is 1 or a number that random.uniform may return", "[14.2][hard]") {
    rt::Rng rng{142, 7};
    for (int i = 0; i < 100; ++i) {
        const Numbers weights = random_weights(rng, 1 + rng() % 100);
        for (const Real share : rt::running_shares(weights)) {
            const Real steps = share / step;
            INFO("the share " << text(share) << " is " << text(steps) << " steps of epsilon / 2");
            INFO(
                "Hint: a share between two of the numbers that uniform() returns is a probability "
                "with which nothing is chosen: round the number of steps with std::floor");
            REQUIRE(steps == std::floor(steps));
        }
    }
}

TEST_CASE("14.2 a million weights of all sizes can all be drawn", "[14.2][hard]") {
    rt::Rng rng{142, 8};
    for (const bool one_is_large : {false, true}) {
        constexpr std::size_t count = 1'000'000;
        Numbers weights;
        for (std::size_t i = 0; i < count; ++i)
            weights.push_back(rng() % 3 == 0 ? Real(0) : any_size(rng, -3, 0));
        if (one_is_large) weights[10] = real(for_this_precision(1e12, 1e22));
        const Numbers shares = rt::running_shares(weights);
        REQUIRE(shares.size() == count);
        for (std::size_t i = 0; i < count; ++i) {
            const Real probability = rt::probability_of(shares, i);
            if ((weights[i] > 0) == (probability > 0)) continue;
            INFO("entry " << i << " of a million has the weight " << text(weights[i])
                          << " and the probability " << text(probability));
            INFO(
                "Hint: next to a large sum, a small weight is rounded away: give each weight above "
                "0 one step of epsilon / 2, and share out the other steps");
            REQUIRE((weights[i] > 0) == (probability > 0));
        }
        const double worst = worst_of(weights, shares);
        INFO("the worst of the shares is off by " << worst << " steps of epsilon / 2");
        INFO(
            "Hint: a sum of a million numbers loses digits at each step: remember what rounding "
            "took");
        CHECK(worst <= 6);
    }
}

TEST_CASE("14.2 small shares keep their size", "[14.2][hard]") {
    rt::Rng rng{142, 9};
    for (int i = 0; i < 300; ++i) {
        const Numbers weights = random_weights(rng, 8);
        const double worst = worst_of(weights, rt::running_shares(weights));
        INFO("of the weights " << text(weights) << ", the worst share is off by " << worst
                               << " steps of epsilon / 2");
        INFO("Hint: share i has m_i + s_i (N - m) steps, rounded: see the text");
        REQUIRE(worst <= 6);
    }
}

TEST_CASE("14.2 the rest is less than 1", "[14.2][hard]") {
    rt::Rng rng{142, 10};
    for (int i = 0; i < 2000; ++i) {
        const Numbers shares = plain_shares(random_weights(rng, 10));
        const Real number = std::nextafter(shares[rng() % 10], Real(0));
        if (!(number >= 0)) continue;
        const Pick picked = rt::pick(shares, number);
        INFO("for the number " << text(number) << ", just below a share");
        INFO("the rest is " << text(picked.rest) << ", which must be 0 or more and less than 1");
        REQUIRE((picked.rest >= 0 && picked.rest < 1));
    }
}
