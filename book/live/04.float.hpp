#pragma once
// What chapter 04 computes in float, for a build in double.

namespace live {

// A ray that leaves a sphere from a point that was computed on it.
struct Departure {
    double height = 0;  // of the point above the surface, as it is: below 0 inside
    double error = 0;   // the bound of that height
    double start = 0;   // the height at which the next ray starts
    // The ray meets nothing, if it goes outward, or the other side of the sphere.
    bool is_right = false;
};

// The sphere's center is `far` away from (0, 0, 0). The point is `place` away from the one that is
// the nearest to the eye, and the ray leaves it at `angle` to the normal; both in radians. The ray
// starts at the point itself (way 0), twice the plain error bound away from it (1), or where
// leave_surface says (2).
Departure depart_in_float(double radius, double far, double place, double angle, int way);

}  // namespace live
