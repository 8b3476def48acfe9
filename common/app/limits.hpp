#pragma once
#include <cstdint>

namespace app {

// What a picture may have at most, whether the command line or a file asks for it. Its colors take
// 1.5 GiB in double.
constexpr std::int64_t most_pixels = std::int64_t{1} << 26;

}  // namespace app
