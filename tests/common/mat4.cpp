#include <rt/mat4.hpp>
#include <rt/vec3.hpp>

#include "checkpoint.hpp"

using checkpoint::Real;
using rt::Mat4;
using rt::Vec3;

namespace {

Vec3 column(const Mat4& m, int i) {
    return {m(0, i), m(1, i), m(2, i)};
}

bool has_affine_last_row(const Mat4& m) {
    return m(3, 0) == 0 && m(3, 1) == 0 && m(3, 2) == 0 && m(3, 3) == 1;
}

}  // namespace

TEST_CASE("a matrix is the identity unless told otherwise", "[mat4]") {
    for (int row = 0; row < 4; ++row)
        for (int i = 0; i < 4; ++i) CHECK(Mat4{}(row, i) == (row == i ? 1 : 0));
}

TEST_CASE("a matrix is indexed by row, then column", "[mat4]") {
    Mat4 m;
    m(1, 3) = 7;
    CHECK(m.rows[1][3] == 7);
    CHECK_FALSE(m == Mat4{});
}

TEST_CASE("from_columns says where the axes and the origin go", "[mat4]") {
    const Mat4 m = rt::from_columns({1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12});
    CHECK(column(m, 0) == Vec3{1, 2, 3});
    CHECK(column(m, 1) == Vec3{4, 5, 6});
    CHECK(column(m, 2) == Vec3{7, 8, 9});
    CHECK(column(m, 3) == Vec3{10, 11, 12});
    CHECK(has_affine_last_row(m));
    CHECK(column(rt::from_columns({1, 2, 3}, {4, 5, 6}, {7, 8, 9}), 3) == Vec3{});
}

TEST_CASE("translation moves the origin, scaling stretches the axes", "[mat4]") {
    const Mat4 t = rt::translation({1, 2, 3}), s = rt::scaling({2, 3, 4});
    CHECK(column(t, 3) == Vec3{1, 2, 3});
    CHECK(column(t, 0) == Vec3{1, 0, 0});
    CHECK(column(s, 0) == Vec3{2, 0, 0});
    CHECK(column(s, 1) == Vec3{0, 3, 0});
    CHECK(column(s, 2) == Vec3{0, 0, 4});
    CHECK(column(s, 3) == Vec3{});
    CHECK(has_affine_last_row(t));
    CHECK(has_affine_last_row(s));
}

TEST_CASE("rotations turn counterclockwise as seen from the tip of the axis", "[mat4]") {
    // By a quarter turn each axis goes to the next one: x to y to z to x. The cosine of the rounded
    // angle is not 0, but as small as the rounding.
    const auto goes_to = [](Vec3 computed, Vec3 expected) {
        const Vec3 d = computed - expected;
        return rt::max_component(d) <= rt::epsilon / 2;
    };
    const Real quarter = rt::pi / 2;
    CHECK(goes_to(column(rt::rotation_x(quarter), 1), {0, 0, 1}));
    CHECK(goes_to(column(rt::rotation_x(quarter), 2), {0, -1, 0}));
    CHECK(goes_to(column(rt::rotation_y(quarter), 2), {1, 0, 0}));
    CHECK(goes_to(column(rt::rotation_y(quarter), 0), {0, 0, -1}));
    CHECK(goes_to(column(rt::rotation_z(quarter), 0), {0, 1, 0}));
    CHECK(goes_to(column(rt::rotation_z(quarter), 1), {-1, 0, 0}));
    CHECK(column(rt::rotation_x(quarter), 0) == Vec3{1, 0, 0});
    CHECK(column(rt::rotation_y(quarter), 1) == Vec3{0, 1, 0});
    CHECK(column(rt::rotation_z(quarter), 2) == Vec3{0, 0, 1});
    for (const Mat4& m : {rt::rotation_x(1), rt::rotation_y(1), rt::rotation_z(1)}) {
        CHECK(has_affine_last_row(m));
        CHECK(column(m, 3) == Vec3{});
    }
}
