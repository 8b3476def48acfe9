#pragma once
#include <cstddef>
#include <rt/pick.hpp>
#include <vector>

namespace rt {

// The plain answer: sums that are rounded as they come.
inline std::vector<Real> running_shares(std::vector<Real> weights) {
    Real all = 0;
    for (const Real weight : weights) all += weight;
    std::vector<Real> shares;
    Real sum = 0;
    for (const Real weight : weights) {
        sum += weight;
        shares.push_back(sum / all);
    }
    return shares;
}

inline Real probability_of(const std::vector<Real>& shares, std::size_t index) {
    if (index == 0) return shares[0];
    return shares[index] - shares[index - 1];
}

inline Pick pick(const std::vector<Real>& shares, Real number) {
    std::size_t low = 0, high = shares.size() - 1;
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (shares[middle] > number)
            high = middle;
        else
            low = middle + 1;
    }
    const Real probability = probability_of(shares, low);
    return {low, probability, (number - (shares[low] - probability)) / probability};
}

}  // namespace rt
