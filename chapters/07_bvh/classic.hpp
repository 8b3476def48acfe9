#pragma once
// The baseline of the study: a ray tracer as introductions write it, in our words. Everything that
// can be hit is an object of its own on the heap behind a shared pointer, and is asked through a
// virtual function; so are materials. The tree is made of the same objects. Numbers are double,
// whatever Real is; chance is std::rand. It is compiled with the same flags as all else.

#include "classic_tree.hpp"

namespace classic {

inline Vec ray_color(const Ray& ray, int depth, const Hittable& world) {
    if (depth <= 0) return {};
    HitRecord hit;
    if (world.hit(ray, {0.001, std::numeric_limits<double>::infinity()}, hit)) {
        Ray out;
        Vec attenuation;
        if (!hit.material->scatter(ray, hit, attenuation, out)) return {};
        return attenuation * ray_color(out, depth - 1, world);
    }
    const double a = (unit(ray.direction).y() + 1) / 2;
    return (1 - a) * Vec{1, 1, 1} + a * Vec{0.5, 0.7, 1};
}

// Its rays go through the pixels of a window in the world; their directions keep their lengths.
class Camera {
  public:
    Camera(int width, int height, double vertical_fov, const Vec& from, const Vec& at,
           const Vec& up)
        : from_{from} {
        const Vec back = from - at, w = unit(back), u = unit(cross(up, w)), v = cross(w, u);
        const double distance = std::sqrt(dot(back, back));
        const double window = 2 * std::tan(vertical_fov / 2) * distance;
        across_ = window / height * u;
        down_ = -(window / height) * v;
        first_ = from - back - width / 2.0 * across_ - height / 2.0 * down_;
    }
    Ray ray(int column, int row) const {
        const double x = column + random_double(), y = row + random_double();
        const Vec through = first_ + x * across_ + y * down_;
        return {from_, through - from_};
    }

  private:
    Vec from_, first_, across_, down_;
};

}  // namespace classic
