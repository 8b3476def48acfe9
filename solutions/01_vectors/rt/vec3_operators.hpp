#pragma once
#include <rt/vec3_type.hpp>

namespace rt {

// All operators work component by component.

inline Vec3 operator-(Vec3 v) {
    return {-v.x, -v.y, -v.z};
}

inline Vec3 operator+(Vec3 a, Vec3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Vec3 operator-(Vec3 a, Vec3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Vec3 operator*(Vec3 v, Real s) {
    return {v.x * s, v.y * s, v.z * s};
}

inline Vec3 operator/(Vec3 v, Real s) {
    return {v.x / s, v.y / s, v.z / s};
}

}  // namespace rt
