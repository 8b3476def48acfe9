#pragma once
// An exact test, pixel by pixel, of whether two sets of pictures come from the same source.

#include <cstddef>
#include <vector>

namespace companion {

// For each pair of pictures, the sum over all pixels of the product of their distances from the
// mean of all pictures.
class Products {
  public:
    explicit Products(std::size_t pictures) : count_{pictures}, sums_(pictures * pictures) {}

    // Adds one pixel: its distance from the mean in each picture.
    void add(const std::vector<double>& distances);
    // Adds another region's products, scaled so that all regions count equally.
    void add_scaled(const Products& other);

    // The squared distance between the mean of the pictures for which `mine` is true and the mean
    // of the others.
    double between(const std::vector<bool>& mine) const;
    // The sum of all pictures' squared distances from the mean.
    double total() const;

  private:
    std::size_t count_;
    std::vector<double> sums_;
};

// The probability that, if both programs are right, their pictures are at least as far apart as the
// first `mine` pictures are from the rest: the fraction of all ways to divide the pictures into two
// such sets for which that is true. This is exact for any noise, because the pictures of two right
// programs can be exchanged. If there are many ways, 20,000 random ones are tried instead of all.
double permutation_p(const Products& products, std::size_t mine, std::size_t all);

}  // namespace companion
