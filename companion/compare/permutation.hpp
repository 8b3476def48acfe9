#pragma once
// An exact test of whether two sets of pictures come from one source, pixel by pixel.

#include <cstddef>
#include <vector>

namespace companion {

// The products of all pairs of pictures: sums over pixels of the distances from
// the mean of all pictures.
class Products {
  public:
    explicit Products(std::size_t pictures) : count_{pictures}, sums_(pictures * pictures) {}

    // One pixel's distances from the mean, one for each picture.
    void add(const std::vector<double>& distances);
    // Another region's products, scaled so that all regions count equally.
    void add_scaled(const Products& other);

    // The squared distance between the mean of the pictures that are `mine`
    // and the mean of the others.
    double between(const std::vector<bool>& mine) const;
    // The sum of all squared distances from the mean of all.
    double total() const;

  private:
    std::size_t count_;
    std::vector<double> sums_;
};

// The probability that right programs' pictures are at least as far apart as the first `mine` are
// from the rest: the share of all ways to deal the pictures out again for which that is true. This
// is exact whatever the noise is, because right programs' pictures can be exchanged. All ways are
// tried if there are few, otherwise 20,000.
double permutation_p(const Products& products, std::size_t mine, std::size_t all);

}  // namespace companion
