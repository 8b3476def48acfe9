#pragma once
// Vectors, rays and random numbers of the baseline (see classic.hpp), as introductory texts write
// them.

#include <cmath>
#include <cstdlib>

namespace study::classic {

struct Vec {
    double e[3] = {0, 0, 0};

    double x() const { return e[0]; }
    double y() const { return e[1]; }
    double z() const { return e[2]; }
    double operator[](int axis) const { return e[axis]; }

    friend Vec operator-(const Vec& a) { return {-a.e[0], -a.e[1], -a.e[2]}; }
    friend Vec operator+(const Vec& a, const Vec& b) {
        return {a.e[0] + b.e[0], a.e[1] + b.e[1], a.e[2] + b.e[2]};
    }
    friend Vec operator-(const Vec& a, const Vec& b) {
        return {a.e[0] - b.e[0], a.e[1] - b.e[1], a.e[2] - b.e[2]};
    }
    friend Vec operator*(const Vec& a, const Vec& b) {
        return {a.e[0] * b.e[0], a.e[1] * b.e[1], a.e[2] * b.e[2]};
    }
    friend Vec operator*(double s, const Vec& v) { return {s * v.e[0], s * v.e[1], s * v.e[2]}; }
    friend Vec operator/(const Vec& v, double s) { return 1 / s * v; }
};

inline double dot(const Vec& a, const Vec& b) {
    return a.e[0] * b.e[0] + a.e[1] * b.e[1] + a.e[2] * b.e[2];
}
inline Vec cross(const Vec& a, const Vec& b) {
    return {a.e[1] * b.e[2] - a.e[2] * b.e[1], a.e[2] * b.e[0] - a.e[0] * b.e[2],
            a.e[0] * b.e[1] - a.e[1] * b.e[0]};
}
inline Vec unit(const Vec& v) {
    return v / std::sqrt(dot(v, v));
}

struct Ray {
    Vec origin, direction;

    Vec at(double t) const { return origin + t * direction; }
};

// The C library's generator, one for the whole program.
inline double random_double() {
    return std::rand() / (RAND_MAX + 1.0);
}
inline double random_double(double low, double high) {
    return low + (high - low) * random_double();
}

// A random direction: draws points in a cube until one lies in the sphere inside it.
inline Vec random_unit() {
    for (;;) {
        const double x = random_double(-1, 1), y = random_double(-1, 1), z = random_double(-1, 1);
        const Vec v{x, y, z};
        const double squared = dot(v, v);
        if (1e-160 < squared && squared <= 1) return v / std::sqrt(squared);
    }
}

}  // namespace study::classic
