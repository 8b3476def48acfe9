// Polygons that no fan can cut.

#include <rt/cut_ears.hpp>
#include <rt/make_mesh.hpp>

#include "../shapes.hpp"

using rt::Real;
using rt::Vec3;

namespace {

// A surface of one polygon with these corners.
rt::Polygons polygon_of(const std::vector<Vec3>& corners) {
    rt::Polygons from{corners, {}, {}, {{}}, {17}};
    for (std::size_t i = 0; i < corners.size(); ++i)
        from.polygons[0].push_back({static_cast<int>(i), -1, static_cast<int>(i)});
    from.uvs.resize(corners.size());
    return from;
}

std::vector<Vec3> flat(const std::vector<rt::Vec2>& corners) {
    std::vector<Vec3> points;
    for (const rt::Vec2& corner : corners) points.push_back({corner.x, corner.y, 0});
    return points;
}

// The polygon's mesh, after checks: no triangle faces the other way, each lies within the polygon,
// and together they have this area.
rt::Mesh check_cut(const std::vector<Vec3>& corners, Vec3 normal, double area) {
    rt::Polygons from = polygon_of(corners);
    rt::cut_ears(from);
    CHECK(from.lines == std::vector<int>(from.polygons.size(), 17));
    const rt::Mesh mesh = rt::make_mesh(from);
    double sum = 0;
    for (const auto& triangle : mesh.triangles) {
        const auto at = [&](std::size_t k) {
            CHECK(triangle[k].uv == triangle[k].point);
            return mesh.points[static_cast<std::size_t>(triangle[k].point)];
        };
        const auto own = static_cast<double>(dot(cross(at(1) - at(0), at(2) - at(0)), normal)) / 2;
        CHECK(own >= -1e-6 * area);  // three corners in one line
        sum += own;
    }
    INFO("area " << sum << ", expected " << area);
    CHECK(std::abs(sum - area) <= 1e-5 * area);
    return mesh;
}

const std::vector<rt::Vec2> letter_h{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 0}, {3, 0},
                                     {3, 3}, {2, 3}, {2, 2}, {1, 2}, {1, 3}, {0, 3}};

}  // namespace

TEST_CASE("letters are cut by their ears") {
    const Vec3 up{0, 0, 1};
    CHECK(check_cut(flat(letter_h), up, 7).triangles.size() == 10);
    check_cut(flat({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}), up, 7);  // U
    check_cut(flat({{1, 0}, {2, 0}, {2, 2}, {3, 2}, {3, 3}, {0, 3}, {0, 2}, {1, 2}}), up, 5);  // T
    // A ring: the way in and the way out run along a slit.
    check_cut(
        flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}), up,
        12);
    // Corners in one line, and twice at the same place.
    check_cut(flat({{0, 0},
                    {0.5, 0},
                    {1, 0},
                    {1, 1},
                    {2, 1},
                    {2, 1},
                    {2, 0},
                    {3, 0},
                    {3, 3},
                    {2, 3},
                    {2, 2},
                    {1.5, 2},
                    {1, 2},
                    {1, 3},
                    {0, 3},
                    {0, 2}}),
              up, 7);
    // A spiral.
    check_cut(flat({{0, 0},
                    {5, 0},
                    {5, 5},
                    {1, 5},
                    {1, 2},
                    {3, 2},
                    {3, 3},
                    {2, 3},
                    {2, 4},
                    {4, 4},
                    {4, 1},
                    {0, 1}}),
              up, 5 + 4 + 3 + 2 + 1);
}

TEST_CASE("a letter may face any way, and be far away, small, and slightly bent") {
    const Vec3 along_x = normalize(Vec3{1, 2, -2}), up = normalize(Vec3{2, 1, 2});
    const Vec3 normal = cross(along_x, up);
    for (const Real size : {Real(1), Real(1e-9), Real(1e6)}) {
        std::vector<Vec3> corners, back;
        for (const rt::Vec2& p : letter_h)
            corners.push_back(size * (p.x * along_x + p.y * up + Real(0.01) * p.x * p.y * normal));
        const double square = static_cast<double>(size) * static_cast<double>(size);
        check_cut(corners, normal, 7 * square);
        back.assign(corners.rbegin(), corners.rend());
        check_cut(back, -normal, 7 * square);
    }
}

TEST_CASE("polygons that a fan can cut stay as they are") {
    for (const auto& corners :
         {flat({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}), flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}}),
          flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}}), flat({{0, 0}, {1, 0}, {1, 1}})}) {
        rt::Polygons from = polygon_of(corners);
        const auto before = from.polygons;
        rt::cut_ears(from);
        CHECK(from.polygons == before);
    }
}

TEST_CASE("a polygon whose sides cross is refused with its line") {
    for (const auto& corners :
         {flat({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), flat({{0, 0}, {3, 3}, {3, 0}, {0, 2}})}) {
        rt::Polygons from = polygon_of(corners);
        CHECK_THROWS_WITH(rt::cut_ears(from),
                          "line 17 has a polygon whose sides cross: no triangles cover it");
    }
}
