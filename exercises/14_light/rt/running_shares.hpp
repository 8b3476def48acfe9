#pragma once
#include <cstddef>
#include <rt/pick.hpp>
#include <rt/todo.hpp>
#include <vector>

namespace rt {

// Exercise 14.2. The running sums of the weights, each divided by the sum of all: share i is (the
// sum of the weights 0 to i) / (the sum of all), so the last share is 1. Weights are 0 or more.
// Star: if no weight is above 0, all shares are 0. The last share is exactly 1, even if the sum of
// the weights overflows. Each share is a whole number of steps of epsilon / 2, as random.uniform()
// is: m_i + s_i (N - m) of them, at most 6 off, with the exact share s_i and N = 2 / epsilon steps
// in 1. m_i counts the weights above 0 up to this one, and m all of them, up to a million. So each
// of them has a probability above 0, and each weight 0 the probability 0.
inline std::vector<Real> running_shares(std::vector<Real> weights) {
    return rt::todo("14.2", weights);
}

// The probability of the entry at this index: its share less the one before, or less 0.
inline Real probability_of(const std::vector<Real>& shares, std::size_t index) {
    return rt::todo("14.2", shares, index);
}

// The entry that a random number chooses, 0 <= number < 1: the first whose share is greater than
// the number. Bisection finds it among a million in 20 steps. `rest` says where in the entry's part
// of [0, 1) the number lies, from 0 at the beginning of that part to 1 at its end.
// Star: if there are no shares, or all are 0, the probability is 0.
inline Pick pick(const std::vector<Real>& shares, Real number) {
    return rt::todo("14.2", shares, number);
}

}  // namespace rt
