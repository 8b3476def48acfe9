#pragma once
#pragma GCC system_header  // #include_next is no part of the standard
#define surface_hit surface_hit_unfollowed
#include_next <rt/surface_hit.hpp>
#undef surface_hit
#include <rt/trail.hpp>

namespace rt {
namespace follow {

// The sphere of the last hit, and where it was.
struct LastHit {
    Sphere sphere;
    Vec3 point;
};
inline thread_local LastHit last_hit;

}  // namespace follow

inline Hit surface_hit(const Sphere& sphere, const Ray& ray, Real t) {
    const Hit hit = surface_hit_unfollowed(sphere, ray, t);
    follow::last_hit = {sphere, hit.point};
    return hit;
}

}  // namespace rt
