#pragma once
#include <array>
#include <cmath>
#include <rt/ray.hpp>

namespace rt {

// A ray as the z-axis (given). Space is moved so that the ray starts at (0, 0, 0), and then sheared
// so that the ray runs along z. In the new coordinates, x and y tell how far a point lies to the
// side of the ray, and z is the t at which the ray passes it. All triangles that share a corner
// compute the same coordinates for it, to the last bit.
// Source: Woop, Benthin and Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013.
struct ShearedRay {
    Vec3 origin;
    int x, y, z;  // the axes of space, reordered so that the direction is longest along z
    Real shear_x, shear_y, per_length;

    explicit ShearedRay(const Ray& ray) : origin{ray.origin} {
        const Vec3 d = ray.direction, size = abs(d);
        // The longest axis is different from ray to ray, so the processor would often guess a
        // branch wrong: all choices here are made by counting, and by places in a list.
        const bool is_x = (size.x >= size.y) & (size.x >= size.z);
        z = !is_x * (1 + !(size.y >= size.z));
        constexpr std::array<int, 5> axis{0, 1, 2, 0, 1};
        x = axis[static_cast<std::size_t>(z + 1)];
        y = axis[static_cast<std::size_t>(z + 2)];
        shear_x = component(d, x) / component(d, z);
        shear_y = component(d, y) / component(d, z);
        per_length = 1 / component(d, z);
    }

    Vec3 seen(Vec3 point) const {
        const Vec3 from_origin = point - origin;
        const Real ahead = component(from_origin, z);
        return {component(from_origin, x) - shear_x * ahead,
                component(from_origin, y) - shear_y * ahead, per_length * ahead};
    }

  private:
    static Real component(const Vec3& v, int axis) {
        return std::array<Real, 3>{v.x, v.y, v.z}[static_cast<std::size_t>(axis)];
    }
};

}  // namespace rt
