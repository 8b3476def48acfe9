#include <rt/choose_lamp.hpp>
#include <rt/lamp_tree.hpp>
#include <rt/rng.hpp>
#include <rt/way_weight.hpp>

#include "checkpoint.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Box;
using rt::LampTree;
using rt::Pick;
using rt::Vec3;
using rt::Way;
using rt::Ways;

namespace {

constexpr Ways all_ways[]{Ways::samples, Ways::bounces, Ways::balance, Ways::power};
constexpr Way both[]{Way::sample, Way::bounce};

const char* name(Ways ways) {
    switch (ways) {
        case Ways::samples:
            return "Ways::samples";
        case Ways::bounces:
            return "Ways::bounces";
        case Ways::balance:
            return "Ways::balance";
        default:
            return "Ways::power";
    }
}
const char* name(Way way) {
    return way == Way::sample ? "Way::sample" : "Way::bounce";
}

void check_weight(Ways ways, Way way, Real density, Real other, double expected, double allowed,
                  const char* hint) {
    const Real weight = rt::way_weight(ways, way, density, other);
    INFO("way_weight(" << name(ways) << ", " << name(way) << ", " << text(density) << ", "
                       << text(other) << ")");
    HINT(real(expected), weight, hint);
    const bool is_near = std::abs(static_cast<double>(weight) - expected) <= allowed;
    REQUIRE(is_near);
}

constexpr double few_epsilon = 8 * static_cast<double>(rt::epsilon);

// The integral of x^3 from 0 to 1 by two ways: numbers spread evenly, with the density 1, and
// square roots of such numbers, with the density 2 x. `skips` is where the second way chooses
// nothing.
Mean integral(Ways ways, rt::Rng& rng, int count) {
    Mean mean;
    for (int i = 0; i < count; ++i) {
        const auto value = [&](Way way, Real x) {
            const Real even = 1, rising = 2 * x;
            const Real density = way == Way::sample ? even : rising,
                       other = way == Way::sample ? rising : even;
            return x * x * x / density * rt::way_weight(ways, way, density, other);
        };
        const Real a = 1 - rng.uniform(), b = std::sqrt(1 - rng.uniform());
        mean.add(static_cast<double>(value(Way::sample, a) + value(Way::bounce, b)));
    }
    return mean;
}

constexpr Real step = rt::epsilon / 2;

// Lamps of known boxes and powers, and their tree.
struct Town {
    std::vector<Box> boxes;
    std::vector<Real> powers;
    LampTree tree;

    Town(std::vector<Box> around, std::vector<Real> sent)
        : boxes{std::move(around)},
          powers{std::move(sent)},
          tree{rt::make_lamp_tree(boxes, powers)} {}
    std::size_t size() const { return powers.size(); }
};

Town points(const std::vector<Vec3>& places, const std::vector<Real>& powers) {
    std::vector<Box> boxes;
    for (const Vec3 place : places) boxes.push_back({place, place});
    return {boxes, powers};
}

// Lamps in a box that reaches from -size to size, of which some are dark, but not the first.
Town random_town(rt::Rng& rng, std::size_t count, Real size = 1) {
    std::vector<Box> boxes;
    std::vector<Real> powers;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 middle = size * Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
        const Vec3 half = size * real(0.1) * Vec3{rng.uniform(), rng.uniform(), rng.uniform()};
        boxes.push_back({middle - half, middle + half});
        powers.push_back(i > 0 && rng() % 5 == 0 ? Real(0) : any_size(rng, -1, 1));
    }
    return {boxes, powers};
}

// Points among the lamps and away from them.
Vec3 any_point(rt::Rng& rng, Real size = 1) {
    return any_size(rng, -2, 1) * size * any_direction(rng);
}

// For each lamp, the steps of epsilon / 2 that it gets by the formula. None of them is rounded.
void expect_below(const LampTree& tree, std::size_t index, Vec3 from, double steps,
                  std::vector<double>& expected) {
    const auto& node = tree.nodes[index];
    if (node.is_leaf()) {
        expected[static_cast<std::size_t>(tree.order[static_cast<std::size_t>(node.begin)])] =
            steps;
        return;
    }
    const std::size_t right_index = static_cast<std::size_t>(node.right);
    const auto &left = tree.nodes[index + 1], &right = tree.nodes[right_index];
    const auto squared = [](Vec3 v) {
        const double x = static_cast<double>(v.x), y = static_cast<double>(v.y),
                     z = static_cast<double>(v.z);
        return x * x + y * y + z * z;
    };
    const auto importance = [&](const rt::LampNode& child) {
        const double least = squared(node.box.high - node.box.low) / 64;
        return static_cast<double>(child.power) /
               std::max(least, squared(child.box.center() - from));
    };
    const double of_left = importance(left), of_right = importance(right);
    const double own = left.lamps(), others = right.lamps();
    const double to_left = own + of_left / (of_left + of_right) * (steps - own - others);
    expect_below(tree, index + 1, from, to_left, expected);
    expect_below(tree, right_index, from, steps - to_left, expected);
}

void check_choices(const Town& town, Vec3 from) {
    std::vector<double> expected(town.size());
    expect_below(town.tree, 0, from, 1 / static_cast<double>(step), expected);
    for (std::size_t lamp = 0; lamp < town.size(); ++lamp) {
        const Real probability = rt::lamp_probability(town.tree, from, lamp);
        INFO("lamp " << lamp << " of " << town.size() << ", from the point " << text(from));
        HINT(real(expected[lamp] * static_cast<double>(step)), probability,
             "at each node, each child gets a share in proportion to its power / distance^2; the "
             "distance to the center of its box is at least an eighth of the node's diagonal");
        const bool is_near =
            std::abs(static_cast<double>(probability / step) - expected[lamp]) <= 10;
        REQUIRE(is_near);
    }
}

// Two lamps, of which the first has the power 1 and is at the origin.
void check_two(Real second_at, Real second_power, Vec3 from, Real expected, const char* hint) {
    const Town town = points({{0, 0, 0}, {second_at, 0, 0}}, {1, second_power});
    INFO("a lamp of power 1 at (0, 0, 0) and one of power "
         << text(second_power) << " at (" << text(second_at) << ", 0, 0), seen from " << text(from)
         << ": the probability of the first");
    const Real probability = rt::lamp_probability(town.tree, from, 0);
    HINT(expected, probability, hint);
    const bool is_near = std::abs(probability - expected) <= 8 * rt::epsilon;
    CHECK(is_near);
}

}  // namespace

TEST_CASE("14.5 the weights agree with an example on paper", "[14.5]") {
    check_weight(Ways::balance, Way::sample, 3, 1, 0.75, few_epsilon, "p / (p + q) = 3 / 4");
    check_weight(Ways::balance, Way::bounce, 1, 3, 0.25, few_epsilon, "p / (p + q) = 1 / 4");
    check_weight(Ways::power, Way::sample, 3, 1, 0.9, few_epsilon, "p^2 / (p^2 + q^2) = 9 / 10");
    check_weight(Ways::power, Way::bounce, 1, 3, 0.1, few_epsilon, "p^2 / (p^2 + q^2) = 1 / 10");
}

TEST_CASE("14.5 each heuristic follows its formula", "[14.5]") {
    rt::Rng rng{145, 1};
    for (int i = 0; i < 1000; ++i) {
        const Real p = any_size(rng, -3, 3), q = any_size(rng, -3, 3);
        const double a = static_cast<double>(p), b = static_cast<double>(q);
        for (const Way way : both) {
            check_weight(Ways::balance, way, p, q, a / (a + b), few_epsilon,
                         "the balance heuristic is density / (density + other)");
            check_weight(Ways::power, way, p, q, a * a / (a * a + b * b), few_epsilon,
                         "the power heuristic has squares: density^2 / (density^2 + other^2)");
        }
    }
}

TEST_CASE("14.5 one way alone counts in full and the other not at all", "[14.5]") {
    rt::Rng rng{145, 2};
    for (int i = 0; i < 100; ++i) {
        const Real p = any_size(rng, -3, 3), q = any_size(rng, -3, 3);
        const char* const hint =
            "Ways::samples counts only what Way::sample has found, Ways::bounces only what "
            "Way::bounce has found, whatever the densities are";
        check_weight(Ways::samples, Way::sample, p, q, 1, 0, hint);
        check_weight(Ways::samples, Way::bounce, p, q, 0, 0, hint);
        check_weight(Ways::bounces, Way::sample, p, q, 0, 0, hint);
        check_weight(Ways::bounces, Way::bounce, p, q, 1, 0, hint);
    }
}

TEST_CASE("14.5 what the other way never finds counts in full", "[14.5]") {
    rt::Rng rng{145, 3};
    for (const Ways ways : all_ways)
        for (const Way way : both)
            for (int i = 0; i < 20; ++i)
                check_weight(ways, way, any_size(rng, -3, 3), 0, 1, 0,
                             "if the density of the other way is 0, only this way can find the "
                             "light, and nothing else would make up for it");
}

TEST_CASE("14.5 the weights of both ways add up to 1", "[14.5]") {
    rt::Rng rng{145, 4};
    for (const Ways ways : all_ways)
        for (int i = 0; i < 500; ++i) {
            const Real p = any_size(rng, -3, 3), q = any_size(rng, -3, 3);
            const Real sum =
                rt::way_weight(ways, Way::sample, p, q) + rt::way_weight(ways, Way::bounce, q, p);
            INFO(name(ways) << " for the densities " << text(p) << " of samples and " << text(q)
                            << " of bounces");
            HINT(Real(1), sum,
                 "the weights of both ways must add up to 1, or light counts too much or too "
                 "little; what is `density` for one way is `other` for the other");
            const bool is_near = std::abs(sum - 1) <= 4 * rt::epsilon;
            REQUIRE(is_near);
        }
}

TEST_CASE("14.5 all ways have the same mean", "[14.5]") {
    // Of 4,000 right answers with other seeds, one would fail in one of the four.
    rt::Rng rng{145, 5};
    for (const Ways ways : all_ways) {
        const Mean mean = integral(ways, rng, 20'000);
        INFO("the integral of x^3 from 0 to 1 by two ways, with " << name(ways));
        HINT(real(0.25), real(mean.mean()),
             "each sample is divided by the density of its own way and multiplied by its weight; "
             "where the weights add up to 1, the mean is right");
        CHECK(std::abs(mean.mean() - 0.25) < 4 * mean.standard_error());
    }
}

TEST_CASE("14.5 a lamp is chosen with the probability that both functions say", "[14.5]") {
    rt::Rng rng{145, 7};
    for (int i = 0; i < 200; ++i) {
        const Town town = random_town(rng, 1 + rng() % 60);
        const Vec3 from = any_point(rng);
        for (int k = 0; k < 20; ++k) {
            const Pick picked = rt::choose_lamp(town.tree, from, rng.uniform());
            REQUIRE(picked.index < town.size());
            const Real probability = rt::lamp_probability(town.tree, from, picked.index);
            INFO("lamp " << picked.index << " of " << town.size()
                         << ": what choose_lamp says, and lamp_probability of the same lamp");
            HINT(picked.probability, probability,
                 "the light is divided by the one, and the weight of a bounce has the other: they "
                 "must be the same");
            const bool is_near =
                std::abs(picked.probability - probability) <= 8 * rt::epsilon * probability;
            REQUIRE(is_near);
        }
    }
}

TEST_CASE("14.5 the probabilities of all lamps add up to 1", "[14.5]") {
    rt::Rng rng{145, 8};
    for (int i = 0; i < 200; ++i) {
        const Town town = random_town(rng, 1 + rng() % 60);
        const Vec3 from = any_point(rng);
        Real sum = 0;
        for (std::size_t lamp = 0; lamp < town.size(); ++lamp) {
            const Real probability = rt::lamp_probability(town.tree, from, lamp);
            INFO("lamp " << lamp << " has the probability " << text(probability));
            REQUIRE(probability >= 0);
            sum += probability;
        }
        INFO(town.size() << " lamps, from the point " << text(from));
        HINT(Real(1), sum, "one of the lamps is always chosen, so their probabilities add up to 1");
        const bool is_near = std::abs(sum - 1) <= 100 * rt::epsilon;
        REQUIRE(is_near);
    }
}

TEST_CASE("14.5 each lamp is chosen as often as its probability says", "[14.5]") {
    // Of 3,000 right answers with other seeds, one would fail.
    rt::Rng rng{145, 9};
    for (const std::size_t count : {std::size_t{2}, std::size_t{40}, std::size_t{300}}) {
        const Town town = random_town(rng, count);
        const Vec3 from = real(0.5) * any_direction(rng);
        std::vector<long> chosen(count);
        constexpr int draws = 100'000;
        for (int i = 0; i < draws; ++i)
            ++chosen[rt::choose_lamp(town.tree, from, rng.uniform()).index];
        Cells cells;
        for (std::size_t lamp = 0; lamp < count; ++lamp) {
            const auto probability =
                static_cast<double>(rt::lamp_probability(town.tree, from, lamp));
            if (probability == 0) {
                INFO("lamp " << lamp << " has the probability 0, but is chosen");
                REQUIRE(chosen[lamp] == 0);
                continue;
            }
            cells.add(chosen[lamp], probability * draws);
        }
        if (cells.wanted[0] == 0) {
            REQUIRE(cells.seen[0] == 0);
            cells.wanted.erase(cells.wanted.begin());
            cells.seen.erase(cells.seen.begin());
        }
        const double statistic = chi_square(cells.seen, cells.wanted),
                     limit = chi_square_limit(static_cast<int>(cells.seen.size()));
        INFO("100,000 choices among " << count << " lamps: chi-square is " << statistic
                                      << ", and of right answers, one in 10,000 is above "
                                      << limit);
        CHECK(statistic < limit);
    }
}

TEST_CASE("14.5 a dark lamp is never chosen", "[14.5]") {
    const Town town = points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {0, 2, 0, 1});
    rt::Rng rng{145, 10};
    for (const Vec3 from : {Vec3{0, 0, 0}, {2, 0, 0}, {1, 5, 0}}) {
        for (const std::size_t dark : {std::size_t{0}, std::size_t{2}})
            CHECK(rt::lamp_probability(town.tree, from, dark) == 0);
        for (int i = 0; i < 300; ++i) {
            const Real number = i == 0 ? Real(0) : i == 1 ? 1 - step : rng.uniform();
            const std::size_t lamp = rt::choose_lamp(town.tree, from, number).index;
            INFO("for the number " << text(number) << ", lamp " << lamp
                                   << " is chosen, but only lamps 1 and 3 shine");
            REQUIRE((lamp == 1 || lamp == 3));
        }
    }
}

TEST_CASE("14.5 the rest of a choice says where its number lies", "[14.5]") {
    rt::Rng rng{145, 11};
    const Town town = random_town(rng, 5);
    for (int i = 0; i < 300; ++i) {
        const Vec3 from = any_point(rng);
        const Real number = rng.uniform(), more = number + (1 - number) * real(0.1);
        const Pick first = rt::choose_lamp(town.tree, from, number),
                   second = rt::choose_lamp(town.tree, from, more);
        INFO("for the numbers " << text(number) << " and " << text(more));
        INFO("Hint: the rest is (number - where the lamp's part begins) / probability");
        REQUIRE((first.rest >= 0 && first.rest <= 1));
        if (first.index != second.index) continue;
        const Real moved = (second.rest - first.rest) * first.probability;
        HINT(more - number, moved, "this is how far the rest has moved, times the probability");
        const bool is_near = std::abs(moved - (more - number)) <= 20 * rt::epsilon;
        REQUIRE(is_near);
    }
}

TEST_CASE("14.5 lamps that are chosen one by one bring all light on average", "[14.5]") {
    // Of 5,000 right answers with other seeds, one would fail.
    rt::Rng rng{145, 12};
    for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{50}}) {
        const Town town = random_town(rng, count);
        const Vec3 from{real(0.3), 2, real(-0.4)};
        const auto light = [&](std::size_t lamp) {
            const Vec3 apart = town.boxes[lamp].center() - from;
            return static_cast<double>(town.powers[lamp] / rt::dot(apart, apart));
        };
        double all = 0;
        for (std::size_t lamp = 0; lamp < count; ++lamp) all += light(lamp);
        Mean mean;
        for (int i = 0; i < 20'000; ++i) {
            const Pick picked = rt::choose_lamp(town.tree, from, rng.uniform());
            mean.add(light(picked.index) / static_cast<double>(picked.probability));
        }
        INFO("the light of " << count << " lamps");
        HINT(real(all), real(mean.mean()),
             "each choice is divided by its probability, so the mean is that of a list");
        CHECK(std::abs(mean.mean() - all) <
              4 * mean.standard_error() + all * 100 * static_cast<double>(rt::epsilon));
    }
}

TEST_CASE("14.5 an infinite density leaves nothing to the other way", "[14.5][hard]") {
    for (const Ways ways : {Ways::balance, Ways::power}) {
        const char* const hint =
            "infinity / infinity is NaN: divide numerator and denominator by the density first, "
            "which "
            "leaves 1 / (1 + other / density)";
        check_weight(ways, Way::bounce, rt::infinity, 2, 1, 0, hint);
        check_weight(ways, Way::sample, 2, rt::infinity, 0, 0, hint);
    }
    check_weight(Ways::samples, Way::bounce, rt::infinity, 2, 0, 0, "samples alone count");
}

TEST_CASE("14.5 densities of any size have weights", "[14.5][hard]") {
    const Real largest = std::numeric_limits<Real>::max(), least = std::numeric_limits<Real>::min();
    const char* const hint =
        "the square, or the sum, of these densities is no number: divide numerator and denominator "
        "by the density first, which leaves 1 / (1 + (other / density)^2)";
    for (const Real size : {largest, largest / 3, least, 3 * least}) {
        check_weight(Ways::balance, Way::sample, size, size, 0.5, few_epsilon, hint);
        check_weight(Ways::power, Way::sample, size, size, 0.5, few_epsilon, hint);
        check_weight(Ways::power, Way::bounce, size / 2, size, 0.2, few_epsilon, hint);
    }
    check_weight(Ways::power, Way::sample, largest, least, 1, 0, hint);
    check_weight(Ways::power, Way::sample, least, largest, 0, 0, hint);
}

TEST_CASE("14.5 the weights of both ways add up to 1 for densities of all sizes", "[14.5][hard]") {
    rt::Rng rng{145, 6};
    const Real power = for_this_precision(37, 300);
    for (const Ways ways : all_ways)
        for (int i = 0; i < 500; ++i) {
            const Real p = any_size(rng, -power, power), q = any_size(rng, -power, power);
            const Real sum =
                rt::way_weight(ways, Way::sample, p, q) + rt::way_weight(ways, Way::bounce, q, p);
            INFO(name(ways) << " for the densities " << text(p) << " of samples and " << text(q)
                            << " of bounces");
            HINT(Real(1), sum, "the weights of both ways must add up to 1 within epsilon");
            const bool is_near = std::abs(sum - 1) <= rt::epsilon;
            REQUIRE(is_near);
        }
}

TEST_CASE("14.5 two lamps share the choices by power and distance", "[14.5][hard]") {
    const char* const hint = "the importance of a child is power / distance^2";
    check_two(4, 1, {1, 0, 0}, real(0.9), hint);   // 1 / 1 and 1 / 9
    check_two(4, 3, {1, 0, 0}, real(0.75), hint);  // 1 / 1 and 3 / 9
    check_two(4, 1, {2, 7, 0}, real(0.5), hint);
    check_two(4, 1, {100, 0, 0}, real(9216.0 / 19216), "far away, distances hardly count");
}

TEST_CASE("14.5 no distance is less than an eighth of the diagonal", "[14.5][hard]") {
    const char* const hint =
        "a lamp may be near and hidden: with a distance of at least an eighth of the node's "
        "diagonal, the other lamps stay likely enough";
    check_two(8, 1, {0, 0, 0}, Real(64) / 65, hint);
    check_two(8, 1, {real(0.5), 0, 0}, real(56.25 / 57.25), hint);
    check_two(8, 1, {8, 0, 0}, Real(1) / 65, hint);
}

TEST_CASE("14.5 power and distance decide at each node", "[14.5][hard]") {
    rt::Rng rng{145, 13};
    for (const Real size : {Real(1), real(1e-9), real(1e9)})
        for (int i = 0; i < 200; ++i) {
            const Town town = random_town(rng, 1 + rng() % 100, size);
            check_choices(town, any_point(rng, size));
            const Box& box = town.boxes[rng() % town.size()];
            check_choices(town, box.center());
            check_choices(town, box.low);
        }
}

TEST_CASE("14.5 each part of the numbers belongs to one lamp", "[14.5][hard]") {
    rt::Rng rng{145, 14};
    for (int i = 0; i < 200; ++i) {
        const Town town = random_town(rng, 1 + rng() % 100);
        const Vec3 from = any_point(rng);
        Real so_far = 0;
        for (const int lamp : town.tree.order) {
            const auto expected = static_cast<std::size_t>(lamp);
            const Real probability = rt::lamp_probability(town.tree, from, expected);
            const Real steps = probability / step;
            INFO("lamp " << lamp << " has " << text(steps) << " steps of epsilon / 2");
            INFO(
                "Hint: random numbers are multiples of epsilon / 2: round where a part ends with "
                "std::floor");
            REQUIRE((steps >= 1 && steps == std::floor(steps)));
            for (const Real number : {so_far, so_far + probability - step}) {
                const Pick picked = rt::choose_lamp(town.tree, from, number);
                INFO("the number " << text(number) << " chooses lamp " << picked.index);
                INFO("Hint: parts stand in the tree's order, and each has its low end");
                REQUIRE(picked.index == expected);
                REQUIRE(picked.probability == probability);
                const Real rest = (number - so_far) / probability;
                HINT(rest, picked.rest, "the rest is from 0 to less than 1");
                REQUIRE(picked.rest == rest);
            }
            so_far += probability;
        }
        HINT(Real(1), so_far, "nothing is lost: the last part ends at 1 exactly");
        REQUIRE(so_far == 1);
    }
}

TEST_CASE("14.5 a lamp with hardly any power can be chosen", "[14.5][hard]") {
    rt::Rng rng{145, 15};
    for (const Real weak : {std::numeric_limits<Real>::min(), real(1e-9)}) {
        Town town = random_town(rng, 1000);
        for (std::size_t lamp = 0; lamp < town.size(); ++lamp)
            if (lamp != 500 && town.powers[lamp] > 0) town.powers[lamp] = weak;
        town.powers[500] = 1;
        town.tree = rt::make_lamp_tree(town.boxes, town.powers);
        check_choices(town, any_point(rng));
        const Vec3 from = any_point(rng);
        for (std::size_t lamp = 0; lamp < town.size(); ++lamp) {
            INFO("lamp " << lamp << " of 1000 has the power " << text(town.powers[lamp]));
            INFO("Hint: each lamp below a node has a step of epsilon / 2 of its own");
            REQUIRE((town.powers[lamp] > 0) == (rt::lamp_probability(town.tree, from, lamp) > 0));
        }
    }
}

TEST_CASE("14.5 lamps at the same point share the choices by power", "[14.5][hard]") {
    const Vec3 place{1, 2, 3};
    const Town town = points({place, place, place}, {1, 2, 5});
    for (const Vec3 from : {place, Vec3{}}) {
        const Real expected[]{real(0.125), real(0.25), real(0.625)};
        for (std::size_t lamp = 0; lamp < 3; ++lamp) {
            const Real probability = rt::lamp_probability(town.tree, from, lamp);
            INFO("lamp " << lamp << " of powers 1, 2 and 5, all at " << text(place)
                         << ", seen from " << text(from));
            HINT(expected[lamp], probability,
                 "0 / 0 is NaN: where both distances are the same, the powers decide alone");
            const bool is_near = std::abs(probability - expected[lamp]) <= 10 * step;
            CHECK(is_near);
        }
    }
}

TEST_CASE("14.5 without a lamp that shines there is nothing to choose", "[14.5][hard]") {
    const Town none{{}, {}}, dark = points({{1, 0, 0}, {2, 0, 0}}, {0, 0});
    CHECK(rt::choose_lamp(none.tree, {}, real(0.5)).probability == 0);
    CHECK(rt::choose_lamp(dark.tree, {}, real(0.5)).probability == 0);
    CHECK(rt::lamp_probability(dark.tree, {}, 1) == 0);
}
