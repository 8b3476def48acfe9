#pragma once

namespace rt {

// A vector whose components have another type than Real: packs, for example, or numbers with twice
// the precision of double. It computes what the Vec3 of chapter 01 does, in the same order.
template <class Number>
struct Vec3Of {
    Number x{}, y{}, z{};

    friend Vec3Of operator-(const Vec3Of& v) { return {-v.x, -v.y, -v.z}; }
    friend Vec3Of operator+(const Vec3Of& a, const Vec3Of& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend Vec3Of operator-(const Vec3Of& a, const Vec3Of& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend Vec3Of operator*(const Number& s, const Vec3Of& v) {
        return {v.x * s, v.y * s, v.z * s};
    }
    friend Vec3Of operator/(const Vec3Of& v, const Number& s) {
        return {v.x / s, v.y / s, v.z / s};
    }
    friend Number dot(const Vec3Of& a, const Vec3Of& b) {
        return a.x * b.x + a.y * b.y + a.z * b.z;
    }
    friend Vec3Of cross(const Vec3Of& a, const Vec3Of& b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
};

}  // namespace rt
