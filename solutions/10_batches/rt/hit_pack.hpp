#pragma once
#include <rt/path_record.hpp>
#include <rt/sphere.hpp>

namespace rt {

// Tests a sphere, which has this number in the scene, against all rays of a pack. If a ray meets it
// at a t in [0, rays.t], rays.t becomes the smallest such t, and rays.sphere becomes the number. Of
// equally near spheres, the sphere with the highest number counts. This is hit_sphere of 03.2 for
// many rays, with the same operations in the same order, so that each t has the same bits. Returns
// the mask of the rays that take this hit.
inline PackMask hit_pack(const Sphere& sphere, PackInteger number, RayPack& rays) {
    const Vec3Pack d = rays.direction, f = rays.origin - pack_of(sphere.center);
    const Pack a = dot(d, d);
    const Real r_squared = sphere.radius * sphere.radius;
    const Vec3Pack moment{f.y * d.z - f.z * d.y, f.z * d.x - f.x * d.z, f.x * d.y - f.y * d.x};
    const Pack quarter = a * r_squared - dot(moment, moment);
    const Pack b = 2 * dot(f, d), c = dot(f, f) - r_squared;
    // A ray that starts outside and runs away from the center has the sphere behind it.
    const PackMask meets = (a > 0) & (quarter >= 0) & ~((b > 0) & (c > 0));
    if (bits_of(meets) == 0) return meets;  // usually no ray comes near

    const Pack q = -(b + copysign(sqrt(4 * quarter), b)) / 2;
    const PackMask at_origin = q == 0;  // both solutions are 0
    const Pack one = at_origin ? Pack{} : c / q, other = at_origin ? Pack{} : q / a;
    const Pack low = one < other ? one : other, high = one < other ? other : one;
    const PackMask low_counts = (low >= 0) & (low <= rays.t);
    const PackMask high_counts = (high >= 0) & (high <= rays.t);
    const Pack t = low_counts ? low : high;
    const PackMask loses_tie = (t == rays.t) & (rays.sphere > number);
    const PackMask hit = meets & (low_counts | high_counts) & ~loses_tie;
    rays.t = hit ? t : rays.t;
    rays.sphere = hit ? PackMask{} + number : rays.sphere;
    return hit;
}

}  // namespace rt
