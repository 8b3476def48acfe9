#pragma once
#include <rt/path_record.hpp>
#include <rt/sphere.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 10.3. Tests a sphere, which has this number in the scene, against all rays of a pack. If
// a ray meets it at a t in [0, rays.t], both ends included, rays.t becomes the smallest such t, and
// rays.sphere becomes the number. Nothing else in the rays changes. Returns a mask: -1 for the rays
// that take this hit, and 0 for the others. This is hit_sphere of 03.2 for all rays at once, with
// the same operations in the same order, so that each t has the same bits, even the sign of a zero.
// Star: of equally near spheres, the sphere with the highest number counts. So if rays.t is the
// same t and rays.sphere is a higher number, the ray keeps both. (If it is the same number, the hit
// counts.) The function also does the work of roots_from_discriminant (03.1), whose q may be 0. A
// ray whose direction has length 0 or contains NaN meets nothing.
inline PackMask hit_pack(const Sphere& sphere, PackInteger number, RayPack& rays) {
    return rt::todo("10.3", sphere, number, rays);
}

}  // namespace rt
