#pragma once
#include <cstdint>
#include <rt/tile.hpp>

namespace rt {

inline Rows slice_rows(int height, int workers, int worker) {
    const auto start_of = [&](int k) {
        return static_cast<int>(static_cast<std::uint32_t>(height) * static_cast<std::uint32_t>(k) /
                                static_cast<std::uint32_t>(workers));
    };
    return {start_of(worker), start_of(worker + 1)};
}

}  // namespace rt
