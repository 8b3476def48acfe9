#pragma once
#include <rt/basis.hpp>
#include <rt/length.hpp>
#include <rt/load_eight.hpp>
#include <rt/vec3.hpp>
#include <rt/vec3_of.hpp>

namespace rt {

// A pack of vectors (given), and the functions of chapters 01 and 05 for such packs. They do the
// same operations in the same order, so that each lane gets the same bits as a single vector.
using Vec3Pack = Vec3Of<Pack>;

inline Vec3Pack pack_of(Vec3 v) {
    return {pack_of(v.x), pack_of(v.y), pack_of(v.z)};
}
inline Vec3 get(const Vec3Pack& v, std::size_t i) {
    return {v.x[i], v.y[i], v.z[i]};
}
inline void set(Vec3Pack& v, std::size_t i, Vec3 to) {
    v.x[i] = to.x;
    v.y[i] = to.y;
    v.z[i] = to.z;
}

inline Vec3Pack abs(Vec3Pack v) {
    return {abs(v.x), abs(v.y), abs(v.z)};
}
inline Pack max_component(Vec3Pack v) {
    return max(max(abs(v.x), abs(v.y)), abs(v.z));
}
inline PackMask is_zero(Vec3Pack v) {
    return (v.x == 0) & (v.y == 0) & (v.z == 0);
}
inline Vec3Pack pick(PackMask mask, Vec3Pack a, Vec3Pack b) {
    return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}
inline Vec3Pack to_world(Vec3Pack u, Vec3Pack v, Vec3Pack w, Vec3Pack local) {
    return local.x * u + local.y * v + local.z * w;
}

// normalize() for the lanes whose bits are set in `active`; the results in the other lanes do not
// matter. In the rare lanes where squares overflow or lose digits, the function for a single vector
// is called.
inline Vec3Pack normalize(Vec3Pack v, PackBits active) {
    constexpr Real least = std::numeric_limits<Real>::min() / epsilon,
                   most = std::numeric_limits<Real>::max();
    const Pack squared = dot(v, v);
    const PackBits safe = bits_of((squared >= least) & (squared <= most));
    Vec3Pack result = v / sqrt(squared);
    for_each_bit(active & ~safe, [&](std::size_t i) { set(result, i, normalize(get(v, i))); });
    return result;
}

inline Vec3Pack reflect(Vec3Pack incoming, Vec3Pack normal) {
    return incoming - 2 * dot(incoming, normal) * normal;
}

inline Vec3Pack above_horizon(Vec3Pack v, Vec3Pack normal, PackBits active) {
    const PackMask zero = is_zero(v);
    const Pack height = dot(v, normal);
    const Pack least = rounding_bound(16) * (abs(v.x) + abs(v.y) + abs(v.z));
    const Vec3Pack lifted = v + (max(abs(height), least) - height) * normal;
    return pick(zero, normal, normalize(lifted, active & ~bits_of(zero)));
}

}  // namespace rt
