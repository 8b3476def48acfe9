#pragma once
// Student's t distribution, and Welch's test for the means of two samples.

#include <vector>

namespace companion {

// The regularized incomplete beta function I_x(a, b) for a, b > 0 and x in [0, 1]. Accurate to
// about 12 digits, even where it is as small as 1e-300.
double incomplete_beta(double a, double b, double x);

// The probability that a value of Student's t distribution with `degrees` degrees of freedom,
// greater than 0, is farther from 0 than t is, on either side.
double two_sided_p(double t, double degrees);

// What a sample tells about the mean of its distribution.
struct Sample {
    double mean = 0;
    double variance = 0;  // of the values; unbiased
    int count = 0;
};

Sample describe(const std::vector<double>& values);

// The p-value for two samples of normally distributed values: the probability that their means are
// at least as far apart as these, if the true means are equal, whatever the variances. Both samples
// need at least two values. If neither sample varies, the result is 1 for equal means and 0 for
// different ones. `rounding` is the variance of a mean that rounding alone causes; it counts even
// if the values do not seem to vary. Source: Welch, "The generalization of 'Student's' problem",
// Biometrika 34, 1947; degrees of freedom by Satterthwaite, Biometrics Bulletin 2, 1946.
double welch_p(const Sample& a, const Sample& b, double rounding = 0);

}  // namespace companion
