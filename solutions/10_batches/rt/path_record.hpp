#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <rt/color.hpp>
#include <rt/rng.hpp>
#include <rt/vec3_pack.hpp>
#include <span>

namespace rt {

// Numbers of paths in a batch.
using PathList = std::span<const std::uint32_t>;

// A path on its way (given). In float it is 64 bytes, what a processor fetches from memory at once.
struct alignas(64) PathRecord {
    // What the search for the nearest sphere needs: eight numbers of one size.
    Vec3 origin, direction;   // of its ray
    Real t = infinity;        // of the nearest hit so far
    PackInteger sphere = -1;  // which sphere was hit there; -1 before any

    Color throughput{1, 1, 1};
    std::int32_t sample = 0;  // whose light it brings
    Rng random{0, 0};
};

// Up to pack_size rays of a list, side by side.
struct RayPack {
    Vec3Pack origin, direction;
    Pack t{};
    PackMask sphere{};
};

// Eight numbers each of up to pack_size records, as eight packs: the first numbers of all, the
// second ones, and so on. record(i), for i below size, is where a record begins; 64 bytes of it can
// be read. What stands in unused places does not matter.
template <class Record>
std::array<Pack, 8> load_eight(std::size_t size, const Record& record) {
    std::array<Pack, 8> packs;
    for (std::size_t first = 0; first < packs.size(); first += pack_size) {
        Pack rows[pack_size];
        for (std::size_t i = 0; i < pack_size; ++i)
            std::memcpy(
                &rows[i],
                reinterpret_cast<const char*>(record(i < size ? i : 0)) + first * sizeof(Real),
                sizeof(Pack));
        transpose(rows);
        for (std::size_t k = 0; k < pack_size && first + k < packs.size(); ++k)
            packs[first + k] = rows[k];
    }
    return packs;
}

// The inverse: writes eight numbers each to up to pack_size records.
template <class Record>
void store_eight(const std::array<Pack, 8>& packs, std::size_t size, const Record& record) {
    for (std::size_t first = 0; first < packs.size(); first += pack_size) {
        Pack rows[pack_size]{};
        for (std::size_t k = 0; k < pack_size && first + k < packs.size(); ++k)
            rows[k] = packs[first + k];
        transpose(rows);
        constexpr std::size_t length = std::min<std::size_t>(pack_size, 8) * sizeof(Real);
        for (std::size_t i = 0; i < size; ++i)
            std::memcpy(reinterpret_cast<char*>(record(i)) + first * sizeof(Real), &rows[i],
                        length);
    }
}

inline RayPack load_rays(const PathRecord* paths, PathList list) {
    const auto [ox, oy, oz, dx, dy, dz, t, sphere] =
        load_eight(list.size(), [&](std::size_t i) { return &paths[list[i]]; });
    return {{ox, oy, oz}, {dx, dy, dz}, t, std::bit_cast<PackMask>(sphere)};
}

}  // namespace rt
