#pragma once
// What the picture shows: a ball that faces the light, and balls that a matrix turns.
//
// Every ball here is looked at from so far away that all lines of sight are parallel. Then the
// point of the ball of radius 1 that shows at (x, y) is (x, y, sqrt(1 - x^2 - y^2)), and the normal
// there is that same vector.

#include <array>
#include <rt/color.hpp>
#include <rt/dot.hpp>
#include <rt/facing.hpp>
#include <rt/inverse.hpp>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/portable.hpp>
#include <rt/transform.hpp>
#include <vector>

namespace vectors {

using namespace rt;

inline const Color background = from_hex(0x14171f), paper = from_hex(0xf4efe6);
inline const Color gold = from_hex(0xf2b84b), blue = from_hex(0x3d5a98), night = from_hex(0x1d2b4f),
                   pale_blue = from_hex(0x8aa4dc);
inline const std::array<Color, 3> axis_colors{from_hex(0xe4572e), from_hex(0x6ab04c),
                                              from_hex(0x3fa7d6)};

// A straight stick with round ends. If `from` equals `to`, it is a ball.
struct Stick {
    Vec3 from, to;
    Real radius;
    Color color;
};

// True if a stick covers a point, seen from the front, and the ball of radius 1 does not hide the
// stick there.
inline bool covers(const Stick& stick, Vec3 place) {
    const Vec3 along = stick.to - stick.from;
    const Vec3 flat{along.x, along.y, 0};
    const Vec3 start{stick.from.x, stick.from.y, 0};
    const Real squared = dot(flat, flat);
    // The nearest point of the line: the projection of (place - start) onto it.
    const Real s =
        squared > 0 ? std::clamp(dot(place - start, flat) / squared, Real(0), Real(1)) : 0;
    const Vec3 nearest = stick.from + s * along;
    if (length(place - Vec3{nearest.x, nearest.y, 0}) > stick.radius) return false;
    const bool beside_the_ball = nearest.x * nearest.x + nearest.y * nearest.y > 1;
    return beside_the_ball || (nearest.z > 0 && dot(nearest, nearest) >= 1);
}

// A flat ring around the foot of a stick that stands on the ball, drawn in the frame of that stick.
struct Washer {
    Vec3 foot;
    Basis frame;
    Color color;

    bool covers(Real x, Real y) const {
        if (frame.w.z <= 0) return false;  // on the far side of the ball
        // `d` leads from the foot to the point of the ring's plane that shows at (x, y), and `r` is
        // the length of d, computed from its coordinates along u and v.
        const Real dx = x - foot.x, dy = y - foot.y;
        const Vec3 d{dx, dy, -(dx * frame.w.x + dy * frame.w.y) / frame.w.z};
        const Real r = length({dot(d, frame.u), dot(d, frame.v), 0});
        return Real(0.04) < r && r < Real(0.07);
    }
};

// The sign of the dot product: the side of the ball that faces the light is gold, the other is
// blue, and between them lies the line where the dot product is 0. Each ring marks a multiple of
// 1/10.
inline Color dot_product_color(Vec3 n, Vec3 light) {
    const Real cosine = dot(n, light);
    const Real ring = std::abs(cosine * 10 - std::round(cosine * 10));
    const Color side = facing(n, light) > 0 ? mix(blue, gold, Real(0.35) + Real(0.65) * cosine)
                                            : mix(blue, night, -cosine);
    if (std::abs(cosine) < Real(0.012)) return paper;
    return ring < Real(0.06) ? side * Real(0.6) : side;
}

// The color, at the point whose normal is n, of a ball that has a net of latitude and longitude and
// is turned by a matrix. The color follows from the point's coordinates in the ball's own space.
inline Color turned_ball_color(Vec3 n, const Mat4& world_to_object, Vec3 light) {
    const Vec3 p = transform_point(world_to_object, n);
    const Real latitude = rt::portable::asin(std::clamp(p.y, Real(-1), Real(1))),
               longitude = rt::portable::atan2(p.x, p.z);
    const auto stripe = [](Real angle) { return static_cast<int>(std::floor(angle * 6 / pi)); };
    const bool even = ((stripe(latitude) + stripe(longitude)) & 1) == 0;
    const Color tile = even ? paper : mix(axis_colors[2], axis_colors[0], (p.y + 1) / 2);
    return tile * (Real(0.25) + Real(0.75) * std::max(Real(0), dot(n, light)));
}

// A ball with its sticks; its middle is at (x, y) = (0, 0).
struct Ball {
    std::vector<Stick> sticks;
    std::vector<Washer> washers;
    Mat4 world_to_object;
    bool is_turned;

    Color at(Real x, Real y, Vec3 light) const {
        const Vec3 place{x, y, 0};
        for (const Stick& stick : sticks)
            if (covers(stick, place)) return stick.color;
        for (const Washer& washer : washers)
            if (washer.covers(x, y)) return washer.color;
        const Real rest = 1 - dot(place, place);
        if (rest < 0) return background;
        const Vec3 n{x, y, std::sqrt(rest)};
        return is_turned ? turned_ball_color(n, world_to_object, light)
                         : dot_product_color(n, light);
    }
};

// The large ball, with little bristles. Each bristle stands along the normal at its foot, and the
// washer around its foot is drawn with the basis built on that normal.
inline Ball ball_with_bristles(Vec3 light) {
    const Vec3 sun = Real(1.42) * light;
    Ball ball{{{{}, sun, Real(0.012), gold}, {sun, sun, Real(0.07), gold}}, {}, {}, false};
    const int count = 60;
    for (int i = 0; i < count; ++i) {
        // The bristles are evenly spread: each is lower than the one before by the same step, and
        // turned further by the golden angle.
        const Real y = 1 - (2 * static_cast<Real>(i) + 1) / count;
        const Real angle = static_cast<Real>(i) * pi * (3 - std::sqrt(Real(5)));
        const Real r = std::sqrt(1 - y * y);
        const Basis basis = orthonormal_basis(
            normalize({r * rt::portable::cos(angle), y, r * rt::portable::sin(angle)}));
        const Color color = facing(basis.w, light) > 0 ? paper : pale_blue;
        ball.sticks.push_back({basis.w, Real(1.16) * basis.w, Real(0.012), color});
        ball.washers.push_back({basis.w, basis, color});
    }
    return ball;
}

// A ball with its x, y and z axes, turned by a matrix.
inline Ball turned_ball(Real angle) {
    const Mat4 turn =
        multiply(rotation_x(radians(25)), multiply(rotation_y(angle), rotation_z(angle / 2)));
    Ball ball{{}, {}, inverse(turn), true};
    const std::array<Vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (std::size_t i = 0; i < 3; ++i)
        ball.sticks.push_back(
            {{}, Real(1.5) * transform_vector(turn, axes[i]), Real(0.045), axis_colors[i]});
    return ball;
}

}  // namespace vectors
