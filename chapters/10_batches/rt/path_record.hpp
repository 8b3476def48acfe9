#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <rt/color.hpp>
#include <rt/path_list.hpp>
#include <rt/vec3_pack.hpp>

namespace rt {

// A path that is being followed (given). In float, a record has 64 bytes, as many as most
// processors fetch from memory at once.
struct alignas(64) PathRecord {
    // What the search for the nearest sphere needs: eight numbers of the same size.
    Vec3 origin, direction;   // of its ray
    Real t = infinity;        // of the nearest hit so far
    PackInteger sphere = -1;  // the number of the sphere that was hit; -1 before any hit

    Color throughput{1, 1, 1};
    std::int32_t sample = 0;  // the index of the path's sample, for its light and random numbers
};

// The rays of a pack of paths, side by side.
struct RayPack {
    Vec3Pack origin, direction;
    Pack t{};
    PackMask sphere{};
};

// A pack of paths: the first pack_size paths of a list. If the list has fewer paths, its first path
// also fills the other lanes, so that no lane needs a test.
struct PathPack {
    std::array<std::uint32_t, pack_size> path;
    std::size_t size;  // the number of lanes in use
    PackBits active;   // a bit for each lane in use

    explicit PathPack(PathList list)
        : size{std::min(pack_size, list.size())}, active{first_bits(size)} {
        for (std::size_t i = 0; i < pack_size; ++i) path[i] = i < size ? list.data()[i] : list[0];
    }
    std::uint32_t operator[](std::size_t i) const { return path[i]; }
};

inline RayPack load_rays(const PathRecord* paths, const PathPack& pack) {
    const auto [ox, oy, oz, dx, dy, dz, t, sphere] =
        load_eight([&](std::size_t i) { return &paths[pack[i]]; });
    return {{ox, oy, oz}, {dx, dy, dz}, t, std::bit_cast<PackMask>(sphere)};
}

}  // namespace rt
