#pragma once
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <rt/rng.hpp>
#include <string_view>

namespace rt {

// A hash of the bytes (given): the same for equal bytes and the same start, and different
// otherwise, except for about one pair in 2^64.
inline std::uint64_t hash_of(std::string_view bytes, std::uint64_t start = 0) {
    std::uint64_t hash = mix_bits(start ^ bytes.size());
    for (std::size_t at = 0; at < bytes.size(); at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, &bytes[at], std::min<std::size_t>(8, bytes.size() - at));
        hash = mix_bits(hash ^ word);
    }
    return hash;
}

}  // namespace rt
