#pragma once
#include <map>
#include <numbers>
#include <rt/length.hpp>
#include <rt/make_mesh.hpp>
#include <utility>

namespace rt {

// A ball of radius 1 around the origin, with the normals of the true ball (given): an icosahedron,
// each of whose 20 triangles is cut into four, `times` times.
inline Mesh make_ball(int times) {
    Mesh ball;
    constexpr Real golden = std::numbers::phi_v<Real>;
    for (const Real one : {Real(-1), Real(1)})
        for (const Real longer : {-golden, golden})
            for (const Vec3 point :
                 {Vec3{0, one, longer}, Vec3{one, longer, 0}, Vec3{longer, 0, one}})
                ball.points.push_back(point);

    const auto point = [&](int i) { return ball.points[static_cast<std::size_t>(i)]; };
    const auto add = [&](auto& triangles, int a, int b, int c) {
        triangles.push_back({Corner{a, a}, Corner{b, b}, Corner{c, c}});
    };
    // Three corners whose distances are 2, those of neighbors, are a triangle.
    const auto near = [&](int i, int k) { return length(point(i) - point(k)) < Real(2.5); };
    for (int a = 0; a < 12; ++a)
        for (int b = 0; b < 12; ++b)
            for (int c = 0; c < 12; ++c)
                if (a < b && a < c && b != c && near(a, b) && near(b, c) && near(c, a) &&
                    dot(cross(point(b) - point(a), point(c) - point(a)), point(a)) > 0)
                    add(ball.triangles, a, b, c);

    for (Vec3& corner : ball.points) corner = normalize(corner);
    for (; times > 0; --times) {
        std::map<std::pair<int, int>, int> made;
        const auto middle = [&](int a, int b) {
            const auto [place, is_new] =
                made.try_emplace(std::minmax(a, b), static_cast<int>(ball.points.size()));
            if (is_new) ball.points.push_back(normalize(point(a) + point(b)));
            return place->second;
        };
        std::vector<std::array<Corner, 3>> smaller;
        for (const auto& triangle : ball.triangles) {
            const int a = triangle[0].point, b = triangle[1].point, c = triangle[2].point;
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            add(smaller, a, ab, ca);
            add(smaller, ab, b, bc);
            add(smaller, ca, bc, c);
            add(smaller, ab, bc, ca);
        }
        ball.triangles = std::move(smaller);
    }
    ball.normals = ball.points;
    return ball;
}

}  // namespace rt
