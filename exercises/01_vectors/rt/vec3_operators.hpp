#pragma once
#include <rt/todo.hpp>
#include <rt/vec3_type.hpp>

namespace rt {

// Exercise 01.1. All operators work component by component. The remaining operators, such as s * v
// and +=, are given in <rt/vec3.hpp> and call the ones below.
// Star: each component is rounded once, and this holds for numbers of any size.

// The vector of the same length in the opposite direction (given, as an example).
inline Vec3 operator-(Vec3 v) {
    return {-v.x, -v.y, -v.z};
}

// The vector that leads first along a, then along b.
inline Vec3 operator+(Vec3 a, Vec3 b) {
    return rt::todo("01.1", a, b);
}

// The vector that leads from b to a.
inline Vec3 operator-(Vec3 a, Vec3 b) {
    return rt::todo("01.1", a, b);
}

// s times v: |s| times as long, and in the opposite direction if s is negative.
inline Vec3 operator*(Vec3 v, Real s) {
    return rt::todo("01.1", v, s);
}

// v divided by s.
// Star: each component by a division of its own.
inline Vec3 operator/(Vec3 v, Real s) {
    return rt::todo("01.1", v, s);
}

}  // namespace rt
