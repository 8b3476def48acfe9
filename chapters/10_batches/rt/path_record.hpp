#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <rt/color.hpp>
#include <rt/path_list.hpp>
#include <rt/rng.hpp>
#include <rt/vec3_pack.hpp>

namespace rt {

// A path on its way (given). In float it has 64 bytes, as many as a processor fetches from
// memory at once.
struct alignas(64) PathRecord {
    // For the search for the nearest sphere: eight numbers of one size.
    Vec3 origin, direction;   // of its ray
    Real t = infinity;        // of the nearest hit so far
    PackInteger sphere = -1;  // which sphere was hit there; -1 before any hit

    Color throughput{1, 1, 1};
    std::int32_t sample = 0;  // the sample whose light it brings
    Rng random{0, 0};
};

// Up to pack_size rays of a list, side by side.
struct RayPack {
    Vec3Pack origin, direction;
    Pack t{};
    PackMask sphere{};
};

inline RayPack load_rays(const PathRecord* paths, PathList list) {
    const auto [ox, oy, oz, dx, dy, dz, t, sphere] =
        load_eight(list.size(), [&](std::size_t i) { return &paths[list[i]]; });
    return {{ox, oy, oz}, {dx, dy, dz}, t, std::bit_cast<PackMask>(sphere)};
}

}  // namespace rt
