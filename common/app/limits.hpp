#pragma once
#include <cstdint>

namespace app {

// The most pixels that a picture may have, whether the command line or a file asks for them. Their
// colors take 1.5 GiB in double.
constexpr std::int64_t most_pixels = std::int64_t{1} << 26;

}  // namespace app
