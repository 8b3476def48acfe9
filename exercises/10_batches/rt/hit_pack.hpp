#pragma once
#include <rt/path_record.hpp>
#include <rt/sphere.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 10.3. Tries a sphere, with this number in the scene, on all rays of a pack: where a ray
// meets it at a t in [0, rays.t], both ends included, rays.t becomes that t and rays.sphere the
// number. Of two such t the smaller one counts. Of equally near spheres the one with the highest
// number: a ray whose rays.t is the same t, and whose rays.sphere is a higher number, keeps both.
// (With the same number it counts as met.) Returns the mask of the rays where that happened, -1,
// and 0 for the others; nothing else of the rays changes. It is hit_sphere of 03.2, for all rays at
// once: the same operations in the same order, so that each t has the same bits.
// roots_from_discriminant of 03.1 is a part of it: its q may be 0. A ray with a direction of length
// 0, or whose direction is not made of numbers, meets nothing.
inline PackMask hit_pack(const Sphere& sphere, PackInteger number, RayPack& rays) {
    return rt::todo("10.3", sphere, number, rays);
}

}  // namespace rt
