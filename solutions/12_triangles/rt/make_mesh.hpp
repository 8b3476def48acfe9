#pragma once
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/mesh.hpp>
#include <rt/polygons.hpp>
#include <rt/portable.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace rt {

// The index of a corner from which a fan cuts the polygon so that all triangles face the same way
// as the polygon and have an area; 0 if there is no such corner.
inline std::size_t fan_start(const std::vector<Vec3>& corners) {
    const std::size_t count = corners.size();
    // Twice the area of triangle i, as a vector along its normal, in the fan from the corner with
    // index `start`.
    const auto area = [&](std::size_t start, std::size_t i) {
        const Vec3 at = corners[start];
        return cross(corners[(start + i) % count] - at, corners[(start + i + 1) % count] - at);
    };
    Vec3 whole;  // the sum of these vectors, the same for all fans
    for (std::size_t i = 1; i + 1 < count; ++i) whole += area(0, i);
    for (std::size_t start = 0; start < count; ++start) {
        bool all_face = true;
        for (std::size_t i = 1; i + 1 < count; ++i)
            all_face = all_face && dot(area(start, i), whole) > 0;
        if (all_face) return start;
    }
    return 0;
}

// Throws std::invalid_argument unless `number` is an index into a list of `count` entries.
inline void expect_number(int number, std::size_t count, const std::string& name) {
    if (number < 0 || static_cast<std::size_t>(number) >= count)
        throw std::invalid_argument(name + " of a corner does not exist; there are " +
                                    std::to_string(count));
}

// The polygons, cut into triangles. All normals are scaled to length 1; a corner whose normal has
// length 0 is left without a normal. Throws std::invalid_argument if a polygon has fewer than three
// corners, or if an index has no entry in its list. The message names the polygon, counted from 1.
inline Mesh make_mesh(const Polygons& from) {
    Mesh mesh{from.points, from.normals, from.uvs, {}};
    for (Vec3& normal : mesh.normals)
        if (normal != Vec3{}) normal = normalize(normal);
    int number = 0;
    for (std::vector<Corner> corners : from.polygons) {
        const std::string polygon = "polygon " + std::to_string(++number);
        const std::size_t count = corners.size();
        if (count < 3) throw std::invalid_argument(polygon + " has fewer than three corners");
        std::vector<Vec3> points;
        for (Corner& corner : corners) {
            expect_number(corner.point, from.points.size(), polygon + ": the point");
            points.push_back(from.points[static_cast<std::size_t>(corner.point)]);
            if (corner.uv != -1)
                expect_number(corner.uv, from.uvs.size(), polygon + ": the texture coordinate");
            if (corner.normal == -1) continue;
            expect_number(corner.normal, from.normals.size(), polygon + ": the normal");
            if (from.normals[static_cast<std::size_t>(corner.normal)] == Vec3{}) corner.normal = -1;
        }
        const std::size_t start = fan_start(points);
        for (std::size_t k = start + 1; k + 1 < start + count; ++k)
            mesh.triangles.push_back(
                {corners[start], corners[k % count], corners[(k + 1) % count]});
    }
    return mesh;
}

// Gives each corner without a normal the normal of its point: the mean of the normals of the
// triangles around the point, each weighted by its triangle's angle at the point, so that it does
// not matter how a flat side was cut. If the sum is zero, the corner stays without a normal.
// Source: Thürmer and Wüthrich, "Computing vertex normals from polygonal facets", Journal of
// Graphics Tools 3(1), 1998.
inline void add_normals(Mesh& mesh) {
    std::vector<Vec3> sums(mesh.points.size());
    for (const auto& triangle : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto point = [&](std::size_t i) {
                return mesh.points[static_cast<std::size_t>(triangle[i % 3].point)];
            };
            const Vec3 one = point(k + 1) - point(k), other = point(k + 2) - point(k);
            const Vec3 normal = cross(one, other);
            if (normal == Vec3{}) continue;
            const Real angle = portable::atan2(length(normal), dot(one, other));
            sums[static_cast<std::size_t>(triangle[k].point)] += angle * normalize(normal);
        }
    const int first = static_cast<int>(mesh.normals.size());
    for (Vec3& sum : sums) mesh.normals.push_back(sum == Vec3{} ? sum : normalize(sum));
    for (auto& triangle : mesh.triangles)
        for (Corner& corner : triangle)
            if (corner.normal < 0 && sums[static_cast<std::size_t>(corner.point)] != Vec3{})
                corner.normal = first + corner.point;
}

}  // namespace rt
