#include <cmath>
#include <companion/compare/student_t.hpp>
#include <limits>

namespace companion {
namespace {

// The continued fraction of I_x(a, b), which converges fast for x < (a + 1) / (a + b + 2);
// evaluated from the front by Lentz's method.
double beta_fraction(double a, double b, double x) {
    constexpr double tiny = std::numeric_limits<double>::min();
    const auto away_from_zero = [](double value) { return std::abs(value) < tiny ? tiny : value; };
    double c = 1, d = 1 / away_from_zero(1 - (a + b) * x / (a + 1)), value = d;
    const auto take = [&](double term) {
        d = 1 / away_from_zero(1 + term * d);
        c = away_from_zero(1 + term / c);
        value *= c * d;
        return std::abs(c * d - 1);
    };
    for (int m = 1; m < 10'000; ++m) {
        take(m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)));
        if (take(-(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1))) <
            4 * std::numeric_limits<double>::epsilon())
            break;
    }
    return value;
}

}  // namespace

double incomplete_beta(double a, double b, double x) {
    if (x <= 0) return 0;
    if (x >= 1) return 1;
    // By symmetry, on the side where the fraction converges.
    if (x > (a + 1) / (a + b + 2)) return 1 - incomplete_beta(b, a, 1 - x);
    const double log_front =
        std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x);
    return std::exp(log_front) * beta_fraction(a, b, x) / a;
}

double two_sided_p(double t, double degrees) {
    if (std::isinf(t)) return 0;
    const double square = t * t;
    // Near the middle of the distribution, x is close to 1, and only 1 - x is known exactly.
    if (square < degrees) return 1 - incomplete_beta(0.5, degrees / 2, square / (degrees + square));
    return incomplete_beta(degrees / 2, 0.5, degrees / (degrees + square));
}

Sample describe(const std::vector<double>& values) {
    Sample sample{0, 0, static_cast<int>(values.size())};
    for (const double value : values) sample.mean += value / sample.count;
    for (const double value : values)
        sample.variance += (value - sample.mean) * (value - sample.mean) / (sample.count - 1);
    return sample;
}

double welch_p(const Sample& a, const Sample& b, double rounding) {
    const double difference = a.mean - b.mean;
    const double from_a = a.variance / a.count, from_b = b.variance / b.count;
    const double squared_error = from_a + from_b + rounding;
    if (squared_error == 0) return difference == 0 ? 1 : 0;
    const double weights = from_a * from_a / (a.count - 1) + from_b * from_b / (b.count - 1);
    const double degrees =
        weights > 0 ? (from_a + from_b) * (from_a + from_b) / weights : a.count + b.count - 2;
    return two_sided_p(difference / std::sqrt(squared_error), degrees);
}

}  // namespace companion
