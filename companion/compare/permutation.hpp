#pragma once
// An exact test of whether two sets of pictures come from one source, pixel by pixel.

#include <cstddef>
#include <vector>

namespace companion {

// The products of all pairs of pictures: sums over pixels of how far each is from the mean of all.
class Products {
  public:
    explicit Products(std::size_t pictures) : count_{pictures}, sums_(pictures * pictures) {}

    // One pixel's distances from the mean, a picture each.
    void add(const std::vector<double>& distances);
    // Another place's products, scaled so that all places count alike.
    void add_scaled(const Products& other);

    // The squared distance between the means of the pictures that are `mine` and of the others.
    double between(const std::vector<bool>& mine) const;
    // The sum of all squared distances from the mean of all.
    double total() const;

  private:
    std::size_t count_;
    std::vector<double> sums_;
};

// How likely right programs' pictures are at least as far apart as the first `mine` are from the
// rest: the share of the ways to deal them out anew that are. Whatever the noise is, this is exact,
// for right programs' pictures can change places. All ways are tried where there are few, else
// 20,000.
double permutation_p(const Products& products, std::size_t mine, std::size_t all);

}  // namespace companion
