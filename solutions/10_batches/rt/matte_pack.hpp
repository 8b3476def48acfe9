#pragma once
#include <rt/arrival.hpp>
#include <rt/sine_cosine.hpp>

namespace rt {

// cosine_direction of 04.3 for a pack: for each normal, of length 1, a direction with the
// probability density cos / pi around the normal. `place` has sample points of the unit square.
// Each result has the same bits as for a single normal.
inline Vec3Pack cosine_direction(Vec3Pack normal, PlacePack place, PackBits active) {
    const Pack radius = sqrt(place.x), height = sqrt(1 - place.x);
    const auto [sine, cosine] = sine_cosine_of_turn(place.y);
    // The basis of 01.8 around the normal, which is its w.
    const Vec3Pack w = normal;
    const Pack sign = copysign(pack_of(1), w.z);
    const Pack a = -1 / (sign + w.z);
    const Pack b = w.x * w.y * a;
    const Vec3Pack u{1 + sign * w.x * w.x * a, sign * b, -sign * w.x};
    const Vec3Pack v{b, sign + w.y * w.y * a, -w.y};
    return normalize(to_world(u, v, w, {radius * cosine, radius * sine, height}), active);
}

}  // namespace rt
