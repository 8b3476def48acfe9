#pragma once
// Everything that a ray of the baseline (see classic.hpp) can hit: objects with a virtual function,
// held by shared pointers.

#include <algorithm>
#include <memory>
#include <vector>

#include <study/classic_materials.hpp>

namespace study::classic {

struct Range {
    double min = 0, max = 0;

    bool surrounds(double x) const { return min < x && x < max; }
    double size() const { return max - min; }
};

struct Bounds {
    Range x, y, z;

    const Range& along(int axis) const { return axis == 1 ? y : axis == 2 ? z : x; }

    bool hit(const Ray& ray, Range within) const {
        for (int axis = 0; axis < 3; ++axis) {
            const Range& slab = along(axis);
            const double inverse = 1 / ray.direction[axis];
            const double first = (slab.min - ray.origin[axis]) * inverse;
            const double second = (slab.max - ray.origin[axis]) * inverse;
            within.min = std::max(within.min, std::min(first, second));
            within.max = std::min(within.max, std::max(first, second));
            if (within.max <= within.min) return false;
        }
        return true;
    }
    int longest_axis() const {
        if (x.size() > y.size()) return x.size() > z.size() ? 0 : 2;
        return y.size() > z.size() ? 1 : 2;
    }
};

inline Range join(const Range& a, const Range& b) {
    return {std::min(a.min, b.min), std::max(a.max, b.max)};
}
inline Bounds join(const Bounds& a, const Bounds& b) {
    return {join(a.x, b.x), join(a.y, b.y), join(a.z, b.z)};
}

class Hittable {
  public:
    virtual ~Hittable() = default;
    virtual bool hit(const Ray& ray, Range within, HitRecord& record) const = 0;
    virtual Bounds bounds() const = 0;
};

class Ball : public Hittable {
  public:
    Ball(const Vec& center, double radius, std::shared_ptr<Material> material)
        : center_{center}, radius_{radius}, material_{std::move(material)} {}

    bool hit(const Ray& ray, Range within, HitRecord& record) const override {
        const Vec to_center = center_ - ray.origin;
        const double a = dot(ray.direction, ray.direction), h = dot(ray.direction, to_center);
        const double c = dot(to_center, to_center) - radius_ * radius_;
        const double discriminant = h * h - a * c;
        if (discriminant < 0) return false;
        const double root = std::sqrt(discriminant);
        double t = (h - root) / a;
        if (!within.surrounds(t)) {
            t = (h + root) / a;
            if (!within.surrounds(t)) return false;
        }
        record.t = t;
        record.point = ray.at(t);
        const Vec outward = (record.point - center_) / radius_;
        record.front = dot(ray.direction, outward) < 0;
        record.normal = record.front ? outward : -outward;
        record.material = material_;
        return true;
    }
    Bounds bounds() const override {
        const auto range = [&](int k) { return Range{center_[k] - radius_, center_[k] + radius_}; };
        return {range(0), range(1), range(2)};
    }

  private:
    Vec center_;
    double radius_;
    std::shared_ptr<Material> material_;
};

}  // namespace study::classic
