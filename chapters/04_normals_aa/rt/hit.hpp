#pragma once
#include <rt/vec3.hpp>

namespace rt {

// Where a ray met a surface, and all that a material needs to know about that point.
struct Hit {
    Real t = 0;  // the point is the ray's origin + t * direction
    Vec3 point;
    Vec3 normal;           // length 1, outward, whichever side was hit
    bool front = true;     // the ray came from outside
    Real point_error = 0;  // the point lies off the surface by at most this, along the normal
    int material = 0;      // an index into the scene's materials
    int light = -1;        // chapter 08: which of the scene's lights was hit; below 0: none
    int shape = -1;        // which shape of its list or tree was hit; the list or tree sets it
};

// The normal on the side that the ray came from.
inline Vec3 facing_normal(const Hit& hit) {
    return hit.front ? hit.normal : -hit.normal;
}

}  // namespace rt
