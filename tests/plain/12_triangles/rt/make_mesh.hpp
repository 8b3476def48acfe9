#pragma once
#include <rt/cross.hpp>
#include <rt/length.hpp>
#include <rt/mesh.hpp>
#include <rt/polygons.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace rt {

inline Mesh make_mesh(const Polygons& from) {
    Mesh mesh{from.points, from.normals, from.uvs, {}};
    for (Vec3& normal : mesh.normals) normal = normalize(normal);
    const auto exists = [](int number, std::size_t count) {
        return number >= 0 && number < static_cast<int>(count);
    };
    int number = 0;
    for (const std::vector<Corner>& corners : from.polygons) {
        ++number;
        bool right = corners.size() >= 3;
        for (const Corner& corner : corners)
            right = right && exists(corner.point, from.points.size()) &&
                    (corner.normal == -1 || exists(corner.normal, from.normals.size())) &&
                    (corner.uv == -1 || exists(corner.uv, from.uvs.size()));
        if (!right) throw std::invalid_argument("polygon " + std::to_string(number) + " is wrong");
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
            mesh.triangles.push_back({corners[0], corners[i], corners[i + 1]});
    }
    return mesh;
}

inline void add_normals(Mesh& mesh) {
    std::vector<Vec3> sums(mesh.points.size());
    const auto at = [](const Corner& corner) { return static_cast<std::size_t>(corner.point); };
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 from = mesh.points[at(a)];
        const Vec3 normal = cross(mesh.points[at(b)] - from, mesh.points[at(c)] - from);
        sums[at(a)] += normal;
        sums[at(b)] += normal;
        sums[at(c)] += normal;
    }
    const int first = static_cast<int>(mesh.normals.size());
    for (const Vec3& sum : sums)
        mesh.normals.push_back(sum == Vec3{} ? Vec3{0, 1, 0} : normalize(sum));
    for (auto& triangle : mesh.triangles)
        for (Corner& corner : triangle)
            if (corner.normal < 0) corner.normal = first + corner.point;
}

}  // namespace rt
