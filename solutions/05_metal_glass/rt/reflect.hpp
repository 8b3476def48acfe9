#pragma once
#include <rt/dot.hpp>

namespace rt {

// The direction in which a mirror with this normal sends light that arrives along `incoming`: the
// part along the normal is reversed, and the rest stays. The length does not change. The normal
// must have length 1; either of the mirror's two normals will do. Source: the law of reflection.
inline Vec3 reflect(Vec3 incoming, Vec3 normal) {
    return incoming - 2 * dot(incoming, normal) * normal;
}

}  // namespace rt
