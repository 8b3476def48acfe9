#pragma once
// Directions spread evenly over the solid angle of a triangle, for the study.

#include <algorithm>
#include <cmath>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/portable.hpp>
#include <rt/triangle.hpp>
#include <rt/vec2.hpp>

namespace light {

// A triangle as seen from a point that is not in its plane: a triangle on the unit sphere.
// Source: Arvo, "Stratified sampling of spherical triangles", SIGGRAPH 1995.
class SphericalTriangle {
  public:
    SphericalTriangle(const rt::Triangle& triangle, rt::Vec3 from)
        : a_{rt::normalize(triangle.a - from)},
          b_{rt::normalize(triangle.b - from)},
          c_{rt::normalize(triangle.c - from)} {
        using rt::Real;
        // The angles at the corners: those between the planes of two sides.
        const rt::Vec3 ab = unit(rt::cross(a_, b_)), bc = unit(rt::cross(b_, c_)),
                       ca = unit(rt::cross(c_, a_));
        alpha_ = angle(-ca, ab);
        solid_angle_ =
            static_cast<double>(alpha_ + angle(-ab, bc) + angle(-bc, ca)) - 3.14159265358979323846;
        cos_ab_ = rt::dot(a_, b_);
    }
    double solid_angle() const { return solid_angle_; }

    // `place` is a sample point, 0 <= x, y < 1.
    rt::Vec3 direction(rt::Vec2 place) const {
        using rt::Real;
        // The point of side ac up to which the triangle has the share place.x of the solid angle.
        const Real part = place.x * static_cast<Real>(solid_angle_);
        const Real s = rt::portable::sin(part - alpha_), t = rt::portable::cos(part - alpha_);
        const Real u = t - rt::portable::cos(alpha_), v = s + rt::portable::sin(alpha_) * cos_ab_;
        const Real top = (v * t - u * s) * rt::portable::cos(alpha_) - v,
                   bottom = (v * s + u * t) * rt::portable::sin(alpha_);
        const Real q = bottom == 0 ? Real(1) : std::clamp(top / bottom, Real(-1), Real(1));
        const rt::Vec3 on_ac = q * a_ + std::sqrt(1 - q * q) * unit(c_ - rt::dot(c_, a_) * a_);
        const Real z = 1 - place.y * (1 - rt::dot(on_ac, b_));
        return z * b_ +
               std::sqrt(std::max(Real(0), 1 - z * z)) * unit(on_ac - rt::dot(on_ac, b_) * b_);
    }

  private:
    static rt::Vec3 unit(rt::Vec3 v) {
        const rt::Real size = rt::length(v);
        return size > 0 ? v / size : v;
    }
    static rt::Real angle(rt::Vec3 a, rt::Vec3 b) {
        return rt::portable::atan2(rt::length(rt::cross(a, b)), rt::dot(a, b));
    }

    rt::Vec3 a_, b_, c_;
    rt::Real alpha_ = 0, cos_ab_ = 0;
    double solid_angle_ = 0;
};

}  // namespace light
