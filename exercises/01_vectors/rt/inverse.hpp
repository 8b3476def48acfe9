#pragma once
#include <cmath>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/mat4.hpp>
#include <rt/todo.hpp>
#include <rt/transform.hpp>
#include <stdexcept>

namespace rt {

// Exercise 01.7.

// The map that undoes m.
// Star: throws std::domain_error if m flattens space (is singular), if m is so nearly singular that
// rounding decides the result, or if a number in m is not finite. A number of the inverse that is
// too large for Real becomes infinite. Each number of the linear part is within 4 + 6 k units in
// the last place, where k measures how much the determinant cancels. Expand the determinant along a
// row or a column, and divide the sum of its terms' absolute values by the determinant's absolute
// value: k is the largest such quotient, and 1 where nothing cancels. All rows share one k, because
// one determinant divides them all. You may assume that each number of a column is 0, or less than
// 10^140 times (float: 10^15 times) smaller than the column's largest.
inline Mat4 inverse(const Mat4& m) {
    return rt::todo("01.7", m);
}

// A point of the world in the object's own coordinates, given the map that places the object in the
// world.
// Star: throws std::domain_error if that map is singular. If a number in its inverse is infinite,
// the coordinate that is computed from this number is infinite or NaN.
inline Vec3 to_object(const Mat4& object_to_world, Vec3 world_point) {
    return rt::todo("01.7", object_to_world, world_point);
}

// The way back: a point of the object in the world's coordinates.
inline Vec3 to_world(const Mat4& object_to_world, Vec3 object_point) {
    return rt::todo("01.7", object_to_world, object_point);
}

}  // namespace rt
