#pragma once
// What chapter 03 computes in float, for a build in double.

namespace live {

// How often a line meets a sphere, 0 or 2 times, and at which t.
struct Meetings {
    int count = 0;
    double low = 0, high = 0;
};

// The line through (x, y, 0) along (dx, dy, 0), and the sphere of radius 1 around (0, 0, 0).
Meetings meetings_in_float(double x, double y, double dx, double dy);

// The same by the textbook formula: (-b -+ sqrt(b^2 - a c)) / a.
Meetings textbook_meetings_in_float(double x, double y, double dx, double dy);

}  // namespace live
