#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <rt/pick.hpp>
#include <vector>

namespace rt {

// A sum that remembers what rounding took from it, so that a million numbers add up as exactly as a
// few. Source: Neumaier's variant of compensated summation, ZAMM 54(1), 1974.
struct CarefulSum {
    Real sum = 0, lost = 0;
    void add(Real number) {
        const Real more = sum + number;
        lost += std::max(sum, number) - more + std::min(sum, number);
        sum = more;
    }
    Real total() const { return sum + lost; }
};

// The running sums of the weights, each divided by the sum of all: the cumulative distribution.
// Weights are 0 or more, and finite. The last share is 1; if no weight is above 0, all are 0.
//
// Each share is a multiple of epsilon / 2, as random.uniform() is. So the difference of two
// neighbors is exactly the probability with which a random number falls between them. Each weight
// above 0 has at least one such step, so it can be drawn, however small it is.
inline std::vector<Real> running_shares(std::vector<Real> weights) {
    Real largest = 0;
    for (const Real weight : weights) largest = std::max(largest, weight);
    if (!(largest > 0)) return weights;
    // The weights are divided by their largest, so that their sum does not overflow.
    CarefulSum all;
    Real own_steps = 0;
    for (const Real weight : weights) {
        all.add(weight / largest);
        own_steps += weight > 0 ? Real(1) : Real(0);
    }
    constexpr Real steps = 2 / epsilon;
    CarefulSum so_far;
    Real own_so_far = 0, share = 0;
    for (Real& entry : weights) {
        so_far.add(entry / largest);
        own_so_far += entry > 0 ? Real(1) : Real(0);
        share = std::clamp(so_far.total() / all.total(), share, Real(1));
        entry = (own_so_far + std::floor(share * (steps - own_steps))) / steps;
    }
    return weights;
}

// The probability of an entry.
inline Real probability_of(const std::vector<Real>& shares, std::size_t index) {
    return shares[index] - (index == 0 ? Real(0) : shares[index - 1]);
}

// The entry that a random number chooses, 0 <= number < 1: the first whose share is greater than
// the number. `rest` says where in the entry's part the number lies, from 0 at its beginning to 1.
inline Pick pick(const std::vector<Real>& shares, Real number) {
    std::size_t low = 0, high = shares.size();
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (shares[middle] > number) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    if (low == shares.size()) return {};
    const Real probability = probability_of(shares, low);
    return {low, probability, (number - (shares[low] - probability)) / probability};
}

}  // namespace rt
