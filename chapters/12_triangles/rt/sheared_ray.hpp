#pragma once
#include <cmath>
#include <rt/box.hpp>
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
        z = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        x = (z + 1) % 3;
        y = (z + 2) % 3;
        shear_x = along(d, x) / along(d, z);
        shear_y = along(d, y) / along(d, z);
        per_length = 1 / along(d, z);
    }

    Vec3 seen(Vec3 point) const {
        const Vec3 from_origin = point - origin;
        const Real ahead = along(from_origin, z);
        return {along(from_origin, x) - shear_x * ahead, along(from_origin, y) - shear_y * ahead,
                per_length * ahead};
    }
};

}  // namespace rt
