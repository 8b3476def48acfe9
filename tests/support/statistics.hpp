#pragma once
// Statistical tests of sampled code. Seeds are fixed, so a test that passes once passes always; the
// limits say how rarely correct code would fail with a seed that nobody has tried.

#include <cmath>
#include <rt/rng.hpp>
#include <rt/vec3.hpp>
#include <vector>

#include "pictured.hpp"

namespace checkpoint {

// The chi-square statistic of correct code stays below this in all but one of 10000 runs.
// Source of the approximation: Wilson and Hilferty, PNAS 17, 1931; within 0.1 % for 50 degrees of
// freedom or more.
inline double chi_square_limit(int degrees_of_freedom) {
    const double k = degrees_of_freedom, one_in_10000 = 3.719;
    return k * std::pow(1 - 2 / (9 * k) + one_in_10000 * std::sqrt(2 / (9 * k)), 3);
}

// The sum of (observed - expected)^2 / expected.
inline double chi_square(const std::vector<long>& observed, const std::vector<double>& expected) {
    double sum = 0;
    for (std::size_t i = 0; i < observed.size(); ++i) {
        const double difference = static_cast<double>(observed[i]) - expected[i];
        sum += difference * difference / expected[i];
    }
    return sum;
}

// Counts for chi_square, and what is expected of them. The first entry is for all cells together of
// which fewer than 10 are expected.
struct Cells {
    std::vector<long> seen{0};
    std::vector<double> wanted{0};

    void add(long count, double expected) {
        if (expected < 10) {
            seen[0] += count;
            wanted[0] += expected;
        } else {
            seen.push_back(count);
            wanted.push_back(expected);
        }
    }
};

// Mean and standard error of numbers that come one by one.
class Mean {
  public:
    void add(double x) {
        ++count_;
        const double before = x - mean_;
        mean_ += before / static_cast<double>(count_);
        squares_ += before * (x - mean_);
    }
    double mean() const { return mean_; }
    double variance() const { return squares_ / static_cast<double>(count_ - 1); }
    double standard_error() const { return std::sqrt(variance() / static_cast<double>(count_)); }

  private:
    long count_ = 0;
    double mean_ = 0, squares_ = 0;
};

// A random direction, by a method that no exercise asks for: a random point in the ball,
// scaled to length 1.
inline rt::Vec3 any_direction(rt::Rng& rng) {
    using rt::Real;
    for (;;) {
        const Real x = rng.uniform(-1, 1), y = rng.uniform(-1, 1), z = rng.uniform(-1, 1);
        const Real squared = x * x + y * y + z * z;
        if (Real(0.01) < squared && squared < 1) return rt::Vec3{x, y, z} / std::sqrt(squared);
    }
}

// 10 to a random power.
inline rt::Real any_size(rt::Rng& rng, rt::Real lowest_power, rt::Real highest_power) {
    return std::pow(rt::Real(10), rng.uniform(lowest_power, highest_power));
}

}  // namespace checkpoint
