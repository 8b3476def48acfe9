#pragma once
#include <rt/image.hpp>
#include <vector>

namespace rt {

// A pixel of a picture of the sky (given).
struct SkyPixel {
    int column = 0, row = 0;

    friend constexpr bool operator==(const SkyPixel&, const SkyPixel&) = default;
};

// A picture of the sky, and the shares by which its pixels are drawn (given). The picture must
// outlive the table.
struct SkyTable {
    const Image* picture = nullptr;
    std::vector<Real> rows;                  // the shares of the rows, as from running_shares
    std::vector<std::vector<Real>> columns;  // for each row, the shares of its pixels
};

}  // namespace rt
