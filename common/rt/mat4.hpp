#pragma once
#include <array>
#include <ostream>
#include <rt/portable.hpp>
#include <rt/vec3_type.hpp>

namespace rt {

// An affine map of space as a matrix of 4 rows and 4 columns that multiplies column vectors from
// the left. The first three columns hold the linear part, and the last one the translation. The
// last row is 0 0 0 1.
struct Mat4 {
    std::array<std::array<Real, 4>, 4> rows{
        {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

    constexpr Real& operator()(int row, int column) { return rows[index(row)][index(column)]; }
    constexpr Real operator()(int row, int column) const { return rows[index(row)][index(column)]; }

    friend constexpr bool operator==(const Mat4&, const Mat4&) = default;

    friend std::ostream& operator<<(std::ostream& out, const Mat4& m) {
        for (const auto& row : m.rows)
            out << row[0] << ' ' << row[1] << ' ' << row[2] << ' ' << row[3] << '\n';
        return out;
    }

  private:
    static constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }
};

// The map whose linear part has these columns: it takes the x, y and z axes to these vectors, and
// the point (0, 0, 0) to `origin`.
constexpr Mat4 from_columns(Vec3 x, Vec3 y, Vec3 z, Vec3 origin = {}) {
    return {{{{x.x, y.x, z.x, origin.x},
              {x.y, y.y, z.y, origin.y},
              {x.z, y.z, z.z, origin.z},
              {0, 0, 0, 1}}}};
}

constexpr Mat4 translation(Vec3 t) {
    return from_columns({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, t);
}

constexpr Mat4 scaling(Vec3 s) {
    return from_columns({s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z});
}

// Rotations by an angle in radians, counterclockwise as seen from the tip of the axis.
inline Mat4 rotation_x(Real angle) {
    const Real c = portable::cos(angle), s = portable::sin(angle);
    return from_columns({1, 0, 0}, {0, c, s}, {0, -s, c});
}
inline Mat4 rotation_y(Real angle) {
    const Real c = portable::cos(angle), s = portable::sin(angle);
    return from_columns({c, 0, -s}, {0, 1, 0}, {s, 0, c});
}
inline Mat4 rotation_z(Real angle) {
    const Real c = portable::cos(angle), s = portable::sin(angle);
    return from_columns({c, s, 0}, {-s, c, 0}, {0, 0, 1});
}

}  // namespace rt
