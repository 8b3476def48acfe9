#include <rt/rng.hpp>
#include <rt/standard_error.hpp>

#include "checkpoint.hpp"
#include "random_inputs.hpp"
#include "single_precision.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::RunningVariance;

namespace {

constexpr Real largest = std::numeric_limits<Real>::max();
constexpr Real smallest = std::numeric_limits<Real>::min();  // of those with all digits

std::string text(const RunningVariance& known) {
    return "count " + std::to_string(known.count) + ", mean " + checkpoint::text(known.mean) +
           ", squares " + checkpoint::text(known.squares);
}

// A few roundings, each of half a unit in the last place.
constexpr double few_units = 6;

void check_error(const RunningVariance& known, const char* hint) {
    const auto count = static_cast<double>(known.count);
    const Exact expected = study::sqrt(Exact(known.squares) / Exact(count - 1) / Exact(count));
    const Real actual = rt::standard_error(known);
    const bool is_right = error_in_ulp(actual, expected) <= few_units;
    if (!is_right) {
        INFO(text(known) << ": the variance is "
                         << checkpoint::text(Exact(known.squares) / Exact(count - 1)));
        HINT(expected, actual, hint);
        REQUIRE(checkpoint::text(actual) == checkpoint::text(expected));
    }
    CHECK(is_right);
}

// erf(x / sqrt(2)) for x from 0 to 8, from its series at 0: 2 / sqrt(pi) times the sum of
// (-1)^k z^(2k + 1) / (k! (2k + 1)).
Exact exact_chance(Exact x) {
    const Exact z = x / study::sqrt(2), square = z * z;
    Exact power = z, sum = z;
    for (int k = 1; k < 150; ++k) {
        power = -power * square / Exact(k);
        sum = sum + power / Exact(2 * k + 1);
    }
    const Exact pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
    return Exact(2) / study::sqrt(pi) * sum;
}

void check_chance(Real distance, Real error, Exact expected, const char* hint) {
    const Real actual = rt::chance_within(distance, error);
    const bool is_right = error_in_ulp(actual, expected) <= few_units;
    if (!is_right) {
        if (expected.high > 0.01 && only_single_precision(actual, expected.high))
            hint = single_precision_hint;
        INFO("distance " << checkpoint::text(distance) << ", standard error "
                         << checkpoint::text(error));
        HINT(expected, actual, hint);
        REQUIRE(checkpoint::text(actual) == checkpoint::text(expected));
    }
    CHECK(is_right);
}

const char* const chance_hint =
    "the probability is erf(distance / (sqrt(2) error)): with a normal distribution, it is 0.683 "
    "within one standard error, 0.954 within two and 0.997 within three, on both sides together";

void check_count(Real variance, Real error, std::int64_t most, std::int64_t fewest,
                 std::int64_t greatest, const char* hint) {
    const std::int64_t actual = rt::samples_for(variance, error, most);
    const bool is_right = fewest <= actual && actual <= greatest;
    if (!is_right) {
        INFO("variance " << checkpoint::text(variance) << ", error " << checkpoint::text(error)
                         << ", most " << most);
        INFO(EXPECTED << fewest << (fewest < greatest ? " to " + std::to_string(greatest) : "")
                      << ", " ACTUAL << actual << ".\nHint: " << hint);
        REQUIRE(std::to_string(actual) == std::to_string(actual < fewest ? fewest : greatest));
    }
    CHECK(is_right);
}
void check_count(Real variance, Real error, std::int64_t most, std::int64_t expected,
                 const char* hint) {
    check_count(variance, error, most, expected, expected, hint);
}

// variance / error^2 up to a few roundings, as whole numbers from 1 to `most`. The exponents are
// computed apart from the rest, so nothing overflows or underflows.
void check_rounded_count(Real variance, Real error, std::int64_t most, const char* hint) {
    int of_variance = 0, of_error = 0;
    const Exact a = std::frexp(variance, &of_variance), b = std::frexp(error, &of_error);
    const double ratio = (a / (b * b)).high;
    const auto limited = [&](double factor) -> std::int64_t {
        const double needed = std::ceil(std::ldexp(ratio * factor, of_variance - 2 * of_error));
        // What rounds to `most` may or may not be limited: it is the same number up to rounding.
        if (!(needed < static_cast<double>(most))) return most;
        return std::max(static_cast<std::int64_t>(needed), std::int64_t{1});
    };
    const double off = few_units * static_cast<double>(rt::epsilon);
    check_count(variance, error, most, limited(1 - off), limited(1 + off), hint);
}

const char* const count_hint =
    "the standard error is sqrt(variance / count). Set it equal to the error, solve for the count, "
    "and round up";
const char* const overflow_hint =
    "variance / error^2 may be far larger than a std::int64_t can be, and error * error may lose "
    "its digits. Compare with `most` before you convert a Real to a std::int64_t, and divide by "
    "the error twice";

}  // namespace

TEST_CASE("11.2 the standard error is the square root of variance over count", "[11.2]") {
    const char* const hint =
        "the variance of a mean is the variance of one number divided by the count: four times as "
        "many numbers halve the error. variance() already divides by count - 1; for the mean, "
        "divide by the whole count";
    check_error({2, 5, 8}, hint);     // variance 8, error 2
    check_error({4, 10, 90}, hint);   // variance 30
    check_error({9, -3, 72}, hint);   // variance 9, error 1
    check_error({100, 0, 99}, hint);  // variance 1, error 0.1
    check_error({101, 7, 0}, hint);
    rt::Rng rng{112, 1};
    for (int i = 0; i < 500; ++i) {
        const auto count = static_cast<std::int64_t>(2 + rng() % (i < 100 ? 10 : 100'000));
        check_error({count, any_number(rng, -3, 3), any_size(rng, -6, 6)}, hint);
    }
}

TEST_CASE("11.2 fewer than two numbers have an infinite error", "[11.2]") {
    for (const RunningVariance& known :
         {RunningVariance{}, {1, 5, 0}, {1, 0, 0}, {1, -2, 3}, {0, 1, 0}}) {
        const Real actual = rt::standard_error(known);
        INFO(text(known));
        HINT(rt::infinity, actual,
             "the spread of the numbers is unknown, so the error has no bound: return infinity");
        REQUIRE(checkpoint::text(actual) == checkpoint::text(rt::infinity));
    }
}

TEST_CASE("11.2 the probability follows the normal distribution", "[11.2]") {
    check_chance(1, 1, exact_chance(1), chance_hint);
    check_chance(2, 1, exact_chance(2), chance_hint);
    check_chance(3, 1, exact_chance(3), chance_hint);
    check_chance(Real(0.5), 2, exact_chance(Exact(1) / Exact(4)), chance_hint);
    check_chance(0, 1, 0, chance_hint);
    check_chance(100, 1, 1, chance_hint);
    rt::Rng rng{112, 2};
    for (int i = 0; i < 500; ++i) {
        const Real error = any_size(rng, -4, 4);
        const Real distance = error * rng.uniform(Real(0.1), 8);
        check_chance(distance, error, exact_chance(Exact(distance) / Exact(error)), chance_hint);
    }
}

TEST_CASE("11.2 the smallest count that reaches the requested error is returned", "[11.2]") {
    const std::int64_t most = 1'000'000;
    check_count(4, 1, most, 4, count_hint);
    check_count(4, Real(0.5), most, 16, count_hint);
    check_count(1, Real(0.25), most, 16, count_hint);
    check_count(9, 2, most, 3, count_hint);  // 2.25
    check_count(1, Real(0.75), most, 2, count_hint);
    check_count(16, 8, most, 1, count_hint);
    check_count(1, 8, most, 1, "without any number there is no mean: return at least 1");
    check_count(0, 8, most, 1, "without any number there is no mean: return at least 1");
    check_count(4, Real(0.5), 10, 10, "never return more than `most`");
    check_count(4, Real(0.5), 16, 16, "never return more than `most`");
    check_count(4, Real(0.5), 15, 15, "never return more than `most`");
    check_count(4, Real(0.5), 17, 16, count_hint);
    check_count(4, Real(0.5), 1, 1, "never return more than `most`");
    rt::Rng rng{112, 3};
    for (int i = 0; i < 1000; ++i) {
        const Real error = any_size(rng, -3, 3);
        const Real wanted = any_size(rng, -1, i % 2 ? 2 : 6);
        check_rounded_count(wanted * error * error, error, i % 5 ? most : 50, count_hint);
    }
}

TEST_CASE("11.2 the error is accurate for billions of numbers", "[11.2][hard]") {
    const char* const hint =
        "the count is a std::int64_t: convert it to a Real, not to an int or a float, before you "
        "multiply";
    rt::Rng rng{112, 4};
    for (const std::int64_t count :
         {16'777'217LL, 123'456'789LL, 2'147'483'649LL, 4'294'967'297LL, 5'000'000'000'001LL})
        for (int i = 0; i < 20; ++i) check_error({count, 1, any_size(rng, -3, 3)}, hint);
    const Real most = for_this_precision(Real(30), Real(290));
    for (int i = 0; i < 200; ++i) {
        const auto size = any_size(rng, -most, most);
        check_error({static_cast<std::int64_t>(2 + rng() % 1000), 0, size},
                    "a variance of this size fits into a Real, but its square does not");
    }
}

TEST_CASE("11.2 with an error of 0 the probability is 1", "[11.2][hard]") {
    const char* const hint = "0 / 0 is NaN: with an error of 0, the probability is 1";
    for (const Real distance : {Real(0), -Real(0), smallest, Real(1), largest})
        for (const Real error : {Real(0), -Real(0)}) check_chance(distance, error, 1, hint);
    for (const Real distance : {Real(0), smallest, Real(1), largest})
        check_chance(distance, rt::infinity, 0,
                     "with an infinite error, nothing is known about the mean: the probability is "
                     "0 at any distance");
}

TEST_CASE("11.2 probabilities are accurate for small distances and errors of all sizes",
          "[11.2][hard]") {
    rt::Rng rng{112, 5};
    const Real low = for_this_precision(Real(-12), Real(-100));
    for (int i = 0; i < 300; ++i) {
        const Real error = any_size(rng, low, -low);
        const Real distance = error * any_size(rng, low, 0);
        check_chance(distance, error, exact_chance(Exact(distance) / Exact(error)),
                     "a small probability is about 0.8 distance / error; use erf, because 1 - "
                     "erfc() loses the digits");
    }
    const char* const hint =
        "the quotient of distance and error is an ordinary number: divide first, before you "
        "multiply or square anything";
    for (const Real size : {smallest, smallest * 8, largest / 4, largest / 2})
        for (const Real ratio : {Real(0.5), Real(1), Real(2)})
            if (ratio >= 1 || size > 1) check_chance(size * ratio, size, exact_chance(ratio), hint);
    check_chance(largest, largest, exact_chance(1), hint);
    const Real least = std::numeric_limits<Real>::denorm_min();
    check_chance(least, least, exact_chance(1), hint);
    check_chance(6 * least, 3 * least, exact_chance(2), hint);
    check_chance(largest, smallest, 1, hint);
    check_chance(largest, 1, 1, hint);
    check_chance(1, smallest, 1, hint);
    const Real tiny = rt::chance_within(smallest, largest);
    INFO("distance " << checkpoint::text(smallest) << ", standard error "
                     << checkpoint::text(largest));
    REQUIRE(tiny >= 0);
    REQUIRE(tiny <= smallest);
}

TEST_CASE("11.2 the count is correct even if the variance or the error is 0", "[11.2][hard]") {
    for (const std::int64_t most :
         {std::int64_t{1}, std::int64_t{1000}, std::numeric_limits<std::int64_t>::max()}) {
        const char* const none = "0 / 0 is NaN. Without variance, one number is enough";
        for (const Real error : {Real(0), smallest, Real(1), largest})
            check_count(0, error, most, 1, none);
        const char* const all =
            "the count would be infinite: return the most that is allowed, `most`";
        for (const Real variance : {smallest, Real(1), largest, rt::infinity})
            check_count(variance, 0, most, most, all);
        for (const Real error : {smallest, Real(1), largest})
            check_count(rt::infinity, error, most, most, all);
    }
}

TEST_CASE("11.2 counts of all sizes are correct", "[11.2][hard]") {
    rt::Rng rng{112, 6};
    const Real low = for_this_precision(Real(-36), Real(-300));
    const std::int64_t any = std::numeric_limits<std::int64_t>::max();
    for (int i = 0; i < 2000; ++i) {
        const Real error = any_size(rng, low, -low);
        // Half of the counts are ordinary, the others arbitrary.
        const Real half =
            std::clamp(error, std::pow(Real(10), low / 2 + 2), std::pow(Real(10), -low / 2 - 5));
        const Real variance =
            i % 2 ? any_size(rng, low, -low) : half * (half * any_size(rng, -1, 10));
        const std::int64_t most = i % 4 < 2 ? any : 1 + rng() % 1000;
        check_rounded_count(variance, i % 2 ? error : half, most, overflow_hint);
    }
    check_count(largest, 1, any, any, overflow_hint);
    // One more than the greatest count. As a Real, the greatest count is this number, too.
    check_count(std::ldexp(Real(1), 63), 1, any, any,
                "converted to a Real, `most` may become a little larger, here 2^63, so a Real "
                "equal to it need not fit into a std::int64_t: compare with >=, not with >");
    check_count(largest, smallest, 7, 7, overflow_hint);
    check_count(smallest, largest, any, 1, overflow_hint);
    check_count(smallest, 1, any, 1, overflow_hint);
    const Real bit_more =
        1 + for_this_precision(std::ldexp(Real(1), -20), std::ldexp(Real(1), -40));
    check_count(bit_more, Real(0.5), any, 5, "a count even slightly above 4 is rounded up to 5");
    for (const int whole : {2, 3, 5, 6, 7, 8, 1000})
        check_count(static_cast<Real>(whole), 1, any, whole,
                    "the root of the variance is rounded, so its square may be a little more than "
                    "the variance: divide the variance itself");
    // The square of this error has lost its digits.
    const int lossy = for_this_precision(-74, -536);
    check_rounded_count(std::ldexp(Real(1), 10 + 2 * lossy), std::ldexp(real(1.3), lossy), any,
                        overflow_hint);
    // The squares of these errors are 0 and infinite.
    const int low_power = for_this_precision(-80, -540), high_power = for_this_precision(70, 520);
    check_count(std::ldexp(Real(1), 10 + low_power), std::ldexp(Real(1), low_power), any, any,
                overflow_hint);
    check_count(std::ldexp(Real(1), 10 + high_power), std::ldexp(Real(1), high_power), any, 1,
                overflow_hint);
}
