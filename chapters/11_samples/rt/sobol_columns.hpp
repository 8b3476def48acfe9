#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <rt/sobol.hpp>

namespace rt {

// Sobol's sequence in eight dimensions: the two coordinates of 11.4, and six more (given). As in
// 11.4, each bit of the index stands for a column, and a coordinate is the exclusive or of the
// columns whose bits are 1. Each coordinate has columns of its own: the first few are chosen, and a
// primitive polynomial modulo 2 determines the rest. If the range of a coordinate is divided into
// 2^m equal parts, each part contains exactly one of the points k 2^m ... (k + 1) 2^m - 1. Boxes in
// several coordinates are filled nearly as evenly.
inline constexpr std::uint32_t sobol_dimensions = 8;

using SobolColumns = std::array<std::uint32_t, 32>;

// The columns of coordinates 2 to 7. Source of degrees, coefficients and first columns: Joe and
// Kuo, "Constructing Sobol sequences with better two-dimensional projections", SIAM Journal on
// Scientific Computing 30, 2008.
inline constexpr auto sobol_columns = [] {
    struct Polynomial {
        std::size_t degree;
        std::uint32_t inner;  // the coefficients between the first and the last one
        std::array<std::uint32_t, 5>
            first;  // the first columns, as odd numbers: column k has k + 1 bits
    };
    constexpr std::array<Polynomial, sobol_dimensions - 2> polynomials{{{2, 1, {1, 3}},
                                                                        {3, 1, {1, 3, 1}},
                                                                        {3, 2, {1, 1, 1}},
                                                                        {4, 1, {1, 1, 3, 3}},
                                                                        {4, 4, {1, 3, 5, 13}},
                                                                        {5, 2, {1, 1, 5, 5, 17}}}};
    std::array<SobolColumns, polynomials.size()> all{};
    for (std::size_t d = 0; d < all.size(); ++d) {
        const auto& [degree, inner, first] = polynomials[d];
        SobolColumns& column = all[d];
        for (std::size_t k = 0; k < degree; ++k) column[k] = first[k] << (31 - k);
        for (std::size_t k = degree; k < column.size(); ++k) {
            column[k] = column[k - degree] ^ column[k - degree] >> degree;
            for (std::size_t j = 1; j < degree; ++j)
                if (inner >> (degree - 1 - j) & 1) column[k] ^= column[k - j];
        }
    }
    return all;
}();

// Coordinate `dimension` of point `index`, as a fraction of 32 bits; dimension is 2 to 7.
inline std::uint32_t sobol_coordinate(std::uint32_t dimension, std::uint32_t index) {
    const SobolColumns& columns = sobol_columns[dimension - 2];
    std::uint32_t sum = 0;
    for (; index != 0; index &= index - 1)
        sum ^= columns[static_cast<std::size_t>(std::countr_zero(index))];
    return sum;
}

// All coordinates of a point.
using SobolCoordinates = std::array<std::uint32_t, sobol_dimensions>;

// The points, computed from a table. The point of an index is the exclusive or of the points of the
// index's four bytes, so it is enough to store a point for each value of each byte.
class SobolTable {
  public:
    static const SobolTable& get() {
        static const SobolTable table;
        return table;
    }

    SobolCoordinates operator[](std::uint32_t index) const {
        SobolCoordinates point = bytes_[0][index & 255];
        for (std::size_t byte = 1; (index >>= 8) != 0; ++byte)
            for (std::size_t k = 0; k < sobol_dimensions; ++k)
                point[k] ^= bytes_[byte][index & 255][k];
        return point;
    }

  private:
    SobolTable() {
        for (std::uint32_t byte = 0; byte < bytes_.size(); ++byte)
            for (std::uint32_t i = 0; i < bytes_[byte].size(); ++i) {
                const std::uint32_t index = i << 8 * byte;
                const FixedPoint2 first = sobol_point(index);
                SobolCoordinates& point = bytes_[byte][i] = {first.x, first.y};
                for (std::uint32_t k = 2; k < sobol_dimensions; ++k)
                    point[k] = sobol_coordinate(k, index);
            }
    }

    std::array<std::array<SobolCoordinates, 256>, 4> bytes_;
};

}  // namespace rt
