#include <algorithm>
#include <companion/compare/permutation.hpp>
#include <rt/real.hpp>
#include <rt/rng.hpp>

namespace companion {

void Products::add(const std::vector<double>& distances) {
    for (std::size_t i = 0; i < count_; ++i)
        for (std::size_t j = 0; j <= i; ++j) sums_[i * count_ + j] += distances[i] * distances[j];
}

void Products::add_scaled(const Products& other) {
    const double total = other.total();
    if (!(total > 0)) return;
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += other.sums_[i] / total;
}

double Products::total() const {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum += sums_[i * count_ + i];
    return sum;
}

double Products::between(const std::vector<bool>& mine) const {
    const auto of_mine = static_cast<double>(std::count(mine.begin(), mine.end(), true));
    const double rest = static_cast<double>(count_) - of_mine;
    const auto weight = [&](std::size_t i) { return mine[i] ? 1 / of_mine : -1 / rest; };
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        sum += weight(i) * weight(i) * sums_[i * count_ + i];
        for (std::size_t j = 0; j < i; ++j)
            sum += 2 * weight(i) * weight(j) * sums_[i * count_ + j];
    }
    return sum;
}

double permutation_p(const Products& products, std::size_t mine, std::size_t all) {
    std::vector<bool> dealt(all);
    std::fill(dealt.begin(), dealt.begin() + static_cast<long>(mine), true);
    // Distances that differ only by rounding errors count as equal.
    const double observed = products.between(dealt) * (1 - 4096 * double{rt::epsilon});
    if (!(observed > 0)) return 1;
    long tried = 0, as_far = 0;
    const auto look = [&] {
        ++tried;
        as_far += products.between(dealt) >= observed;
    };
    if (all <= 16) {
        do look();
        while (std::prev_permutation(dealt.begin(), dealt.end()));
    } else {
        rt::Rng random{1, 1};
        look();
        for (int i = 1; i < 20'000; ++i) {
            std::shuffle(dealt.begin(), dealt.end(), random);
            look();
        }
    }
    return static_cast<double>(as_far) / static_cast<double>(tried);
}

}  // namespace companion
