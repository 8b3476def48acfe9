#pragma once
// A view of space for a figure: where its points are in the drawing, seen by a camera of the course
// from far away, so that near things are hardly larger than distant ones.

#include <rt/dot.hpp>
#include <rt/look_at.hpp>
#include <vector>

#include "live.hpp"

namespace live {

class Space {
  public:
    // The camera looks at `middle`, which is at `at` in the drawing, from `turn` degrees to the
    // right of +z and `up` degrees above. A unit at `middle` is `scale` pixels long.
    Space(Point at, rt::Vec3 middle, double turn, double up, double scale)
        : at_{at}, scale_{scale} {
        const double t = rt::radians(turn), u = rt::radians(up);
        const rt::Vec3 back{std::sin(t) * std::cos(u), std::sin(u), std::cos(t) * std::cos(u)};
        eye_ = middle + distance * back;
        basis_ = rt::look_at(eye_, middle, {0, 1, 0});
    }

    // Where a point is in the drawing: the ray from it to the eye goes through there.
    Point to_page(rt::Vec3 p) const {
        const rt::Vec3 d = p - eye_;
        const double nearness = distance / -rt::dot(d, basis_.w);
        return {at_.x + scale_ * nearness * rt::dot(d, basis_.u),
                at_.y - scale_ * nearness * rt::dot(d, basis_.v)};
    }
    // How far in front of the middle, toward the viewer.
    double toward(rt::Vec3 p) const { return distance + rt::dot(p - eye_, basis_.w); }
    rt::Vec3 back() const { return basis_.w; }

    std::vector<Point> corners(std::initializer_list<rt::Vec3> points) const {
        std::vector<Point> places;
        for (const rt::Vec3 p : points) places.push_back(to_page(p));
        return places;
    }

  private:
    static constexpr double distance = 14;

    Point at_;
    double scale_;
    rt::Vec3 eye_;
    rt::Basis basis_;
};

}  // namespace live
