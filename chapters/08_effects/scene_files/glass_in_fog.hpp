#pragma once
// Fog lies between the spheres and not within glass: if a path meets glass from within, there was
// no fog on the way. But if another sphere stands in the glass, a path within the glass may meet
// that sphere first, and would find fog on the way there. Such scenes are found here, so that they
// can be refused.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <rt/scene.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "placing.hpp"

namespace effects {

// A point in double, as in placing.
using Point = std::array<double, 3>;

inline double dot(const Point& a, const Point& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
// a + t b.
inline Point along(const Point& a, double t, const Point& b) {
    return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}

// A sphere or ellipsoid while the shutter is open.
struct Body {
    Point center;               // when it opens
    std::array<Point, 3> axes;  // images of the unit sphere's axes, as vectors from the center
    double radius;              // of a ball around it
    Point way;                  // how far it moves until the shutter closes
    bool is_ball = true;

    Body(const rt::SphereDescription& sphere, const std::vector<rt::Mat4>& maps, double shutter) {
        const placing::Ball ball = placing::ball_of(sphere.shape);
        center = {ball.x, ball.y, ball.z};
        radius = ball.radius;
        axes = {Point{radius, 0, 0}, Point{0, radius, 0}, Point{0, 0, radius}};
        is_ball = sphere.map < 0;
        if (!is_ball)
            for (int i = 0; i < 9; ++i)
                axes[static_cast<std::size_t>(i / 3)][static_cast<std::size_t>(i % 3)] =
                    static_cast<double>(maps[static_cast<std::size_t>(sphere.map)](i % 3, i / 3));
        const placing::Ball moved = placing::ball_of({sphere.velocity, 0});
        way = along({}, shutter, {moved.x, moved.y, moved.z});
    }

    // The body's farthest point in this direction, relative to its center.
    Point farthest(const Point& direction) const {
        const Point turned{dot(axes[0], direction), dot(axes[1], direction),
                           dot(axes[2], direction)};
        const double length = std::sqrt(dot(turned, turned));
        Point point{};
        for (std::size_t i = 0; i < 3; ++i) point = along(point, turned[i] / length, axes[i]);
        return point;
    }

    // A ball around all positions of the body.
    placing::Ball around() const {
        const Point middle = along(center, 0.5, way);
        return {middle[0], middle[1], middle[2], radius + std::sqrt(dot(way, way)) / 2};
    }
};

// True if two bodies share a point at the same time. Touching does not count: the bodies are
// shrunk, together by a thousandth of the smaller radius. The function looks at the set of all
// differences between their points. It walks from the difference of the centers toward the set's
// point nearest to 0, until a plane turns out to separate the set from 0.
// Source: Gilbert, "An iterative procedure for computing the minimum of a quadratic form on a
// convex set", 1966.
inline bool meet(const Body& a, const Body& b) {
    const double slack = std::min(a.radius, b.radius) / 2000;
    const double share_a = 1 - slack / a.radius, share_b = 1 - slack / b.radius;
    const Point way = along(b.way, -1, a.way);
    Point nearest = along(b.center, -1, a.center);
    const Point middle = nearest;
    for (int step = 0; step < 200; ++step) {
        if (!(dot(nearest, nearest) > slack * slack / 100)) return true;
        const Point back = along({}, -1, nearest);
        Point next = along(along(middle, share_b, b.farthest(back)), -share_a, a.farthest(nearest));
        if (dot(way, back) > 0) next = along(next, 1, way);
        if (dot(next, nearest) > 0) return false;
        const Point edge = along(next, -1, nearest);
        nearest = along(nearest, std::min(1.0, dot(edge, back) / dot(edge, edge)), edge);
    }
    return false;  // they barely meet, if at all
}

// True if `outer` is a ball, and `inner` is within that ball all the time.
inline bool encloses(const Body& outer, const Body& inner) {
    if (!outer.is_ball) return false;
    const Point way = along(inner.way, -1, outer.way);
    const Point from = along(inner.center, -1, outer.center), to = along(from, 1, way);
    const double far = std::sqrt(std::max(dot(from, from), dot(to, to)));
    return far + inner.radius <= outer.radius + inner.radius / 1000;
}

// The numbers of a glass sphere that the fog reaches, and of another sphere that stands in the
// glass or cuts into it. None if the scene has no such pair, or so many spheres that nobody would
// wait for an answer.
inline std::optional<std::pair<int, int>> filled_glass_in_fog(const rt::SceneDescription& scene) {
    if (!scene.fog || !(scene.fog->density > 0)) return {};
    const auto shutter = static_cast<double>(scene.camera.shutter);
    const Body fog{{scene.fog->region}, scene.maps, shutter};
    std::vector<Body> bodies;
    std::vector<int> glass;
    placing::Neighbors all;
    for (const rt::SphereDescription& sphere : scene.spheres) {
        const Body& body = bodies.emplace_back(sphere, scene.maps, shutter);
        const auto& material = scene.materials[static_cast<std::size_t>(sphere.material)];
        if (std::holds_alternative<rt::Dielectric>(material) && meet(body, fog))
            glass.push_back(static_cast<int>(bodies.size()) - 1);
    }
    if (glass.empty()) return {};
    for (const Body& body : bodies) all.add(body.around());
    for (const int number : glass) {
        const Body& body = bodies[static_cast<std::size_t>(number)];
        const int other = all.find_near(body.around(), [&](int i) {
            const Body& near = bodies[static_cast<std::size_t>(i)];
            return i != number && meet(body, near) && !encloses(near, body);
        });
        if (other >= 0) return std::pair{number, other};
        if (all.is_tired()) break;
    }
    return {};
}

}  // namespace effects
