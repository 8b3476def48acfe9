#pragma once
#include <algorithm>
#include <array>
#include <map>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/mesh.hpp>
#include <rt/triangle.hpp>
#include <utility>
#include <vector>

namespace rt {

// Closes the cracks that triangles without area leave (given). Some meshes have a triangle a, m, b
// whose corner m lies on the side from a to b: it joins the triangle a, b, c on one side, whose
// edge is undivided, to two triangles on the other side, whose edges end at m. No ray meets a
// triangle without area, and rounding moves m off the side as rays see it, so rays would slip
// through. The two triangles are therefore replaced by a, m, c and m, b, c.
class CrackCloser {
  public:
    // `materials` has one for each triangle, or none. The mesh may get more normals and texture
    // coordinates.
    CrackCloser(Mesh& mesh, std::vector<int>& materials) : mesh_{mesh}, materials_{materials} {
        const std::size_t count = mesh.triangles.size();
        // Rounding may leave some of them a little area, but rays meet those.
        bool any = false;
        for (std::size_t i = 0; i < count && !any; ++i) any = area_vector_of(shape(i)) == Vec3{};
        if (!any) return;
        std::vector<std::size_t> left;  // triangles without area
        for (std::size_t i = 0; i < count; ++i)
            if (has_no_area(shape(i))) left.push_back(i);
        for (const std::size_t i : left) add(i);
        // Beside them, only their neighbors count.
        std::vector<std::size_t> neighbors;
        for (std::size_t i = 0; i < count; ++i)
            if (!has_no_area(shape(i)) && touches_known_edge(i)) neighbors.push_back(i);
        for (const std::size_t i : neighbors) add(i);
        // A neighbor may have no area, either, until its own turn.
        while (std::erase_if(left, [&](std::size_t i) { return closed(i); }) > 0) continue;
    }

  private:
    // The points at both ends, in either order, whatever their numbers are.
    using Place = std::array<Real, 3>;
    using Edge = std::pair<Place, Place>;

    // True if the triangle is far longer than it is high, and no higher than rounding of its
    // corners may have made it.
    static bool has_no_area(const Triangle& t) {
        const Vec3 ab = t.b - t.a, ac = t.c - t.a;
        const Real size = std::max(max_component(ab), max_component(ac));
        const Real reach = std::max({max_component(t.a), max_component(t.b), max_component(t.c)});
        const Real height = std::min(4 * epsilon * reach, size / 1000);
        return max_component(area_vector_of(t)) <= height * size;
    }
    Triangle shape(std::size_t i) const { return {point(i, 0), point(i, 1), point(i, 2)}; }
    static Vec3 area_vector_of(const Triangle& t) { return cross(t.b - t.a, t.c - t.a); }
    Vec3 point(std::size_t triangle, std::size_t k) const {
        return mesh_.points[static_cast<std::size_t>(mesh_.triangles[triangle][k % 3].point)];
    }
    Edge edge(std::size_t triangle, std::size_t k) const {
        const auto place = [&](Vec3 p) { return Place{p.x, p.y, p.z}; };
        const Place one = place(point(triangle, k)), other = place(point(triangle, k + 1));
        return one < other ? Edge{one, other} : Edge{other, one};
    }
    void add(std::size_t triangle) {
        for (std::size_t k = 0; k < 3; ++k) at_edge_[edge(triangle, k)].push_back(triangle);
    }
    void remove(std::size_t triangle) {
        for (std::size_t k = 0; k < 3; ++k) std::erase(at_edge_[edge(triangle, k)], triangle);
    }
    bool touches_known_edge(std::size_t triangle) const {
        for (std::size_t k = 0; k < 3; ++k)
            if (at_edge_.count(edge(triangle, k))) return true;
        return false;
    }

    // Replaces this triangle and its neighbor across its longest side. False if there is no such
    // neighbor, or more than one.
    bool closed(std::size_t flat) {
        std::size_t side = 0;
        const auto length_of = [&](std::size_t k) {
            return length(point(flat, k + 1) - point(flat, k));
        };
        for (std::size_t k = 1; k < 3; ++k)
            if (length_of(k) > length_of(side)) side = k;
        const Edge longest = edge(flat, side);
        std::vector<std::size_t> across;
        for (const std::size_t i : at_edge_[longest])
            if (!has_no_area(shape(i))) across.push_back(i);
        if (across.size() != 1) return false;
        const std::size_t other = across[0];
        std::size_t k = 0;
        while (edge(other, k) != longest) ++k;
        const Corner a = mesh_.triangles[other][k], b = mesh_.triangles[other][(k + 1) % 3],
                     c = mesh_.triangles[other][(k + 2) % 3];
        const Corner m = between(a, b, mesh_.triangles[flat][(side + 2) % 3].point);
        remove(flat);
        remove(other);
        mesh_.triangles[other] = {a, m, c};
        mesh_.triangles[flat] = {m, b, c};
        if (!materials_.empty()) materials_[flat] = materials_[other];
        add(flat);
        add(other);
        return true;
    }

    // A corner on the side from a to b, with what the neighbor's corners have there.
    Corner between(const Corner& a, const Corner& b, int number) {
        const auto at = [&](int i) { return mesh_.points[static_cast<std::size_t>(i)]; };
        const Real whole = length(at(b.point) - at(a.point));
        const Real share = length(at(number) - at(a.point)) / whole;
        Corner corner{number};
        if (a.normal >= 0 && b.normal >= 0) {
            const Vec3 one = mesh_.normals[static_cast<std::size_t>(a.normal)],
                       other = mesh_.normals[static_cast<std::size_t>(b.normal)],
                       sum = (1 - share) * one + share * other;
            corner.normal = static_cast<int>(mesh_.normals.size());
            mesh_.normals.push_back(sum == Vec3{} ? one : normalize(sum));
        }
        if (a.uv >= 0 && b.uv >= 0) {
            const Vec2 one = mesh_.uvs[static_cast<std::size_t>(a.uv)],
                       other = mesh_.uvs[static_cast<std::size_t>(b.uv)];
            corner.uv = static_cast<int>(mesh_.uvs.size());
            mesh_.uvs.push_back(
                {(1 - share) * one.x + share * other.x, (1 - share) * one.y + share * other.y});
        }
        return corner;
    }
    Mesh& mesh_;
    std::vector<int>& materials_;
    std::map<Edge, std::vector<std::size_t>> at_edge_;
};

// Closes the cracks of a mesh. `materials` has one for each triangle, or none.
inline void close_cracks(Mesh& mesh, std::vector<int>& materials) {
    CrackCloser{mesh, materials};
}

}  // namespace rt
