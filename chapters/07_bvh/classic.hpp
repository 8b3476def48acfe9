#pragma once
// The baseline of the study: a ray tracer as introductions write it. Everything that can be hit is
// an object of its own on the heap behind a shared pointer, and is asked through a virtual
// function; the tree is made of the same objects, split at the middle of the longest axis of the
// boxes, and visited left before right. Numbers are double, whatever Real is.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace classic {

struct Vec {
    double x = 0, y = 0, z = 0;
    friend Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vec operator*(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    friend Vec operator*(double s, Vec v) { return {s * v.x, s * v.y, s * v.z}; }
    double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};
inline double dot(Vec a, Vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec unit(Vec v) {
    return 1 / std::sqrt(dot(v, v)) * v;
}

struct Ray {
    Vec origin, direction;
};

inline double random_double() {
    thread_local std::mt19937 generator{1};
    thread_local std::uniform_real_distribution<double> distribution{0, 1};
    return distribution(generator);
}

inline Vec random_unit() {
    for (;;) {
        const Vec v{2 * random_double() - 1, 2 * random_double() - 1, 2 * random_double() - 1};
        const double squared = dot(v, v);
        if (1e-160 < squared && squared <= 1) return 1 / std::sqrt(squared) * v;
    }
}

class Material;
struct HitRecord {
    Vec point, normal;
    std::shared_ptr<Material> material;
    double t = 0;
    bool front = true;
};

class Material {
  public:
    virtual ~Material() = default;
    virtual bool scatter(const Ray& in, const HitRecord& hit, Vec& attenuation, Ray& out) const = 0;
};

class Matte : public Material {
  public:
    explicit Matte(Vec albedo) : albedo_{albedo} {}
    bool scatter(const Ray&, const HitRecord& hit, Vec& attenuation, Ray& out) const override {
        Vec direction = hit.normal + random_unit();
        if (dot(direction, direction) < 1e-16) direction = hit.normal;
        out = {hit.point, direction};
        attenuation = albedo_;
        return true;
    }

  private:
    Vec albedo_;
};

struct Bounds {
    Vec low, high;
    bool hit(const Ray& ray, double min, double max) const {
        for (int axis = 0; axis < 3; ++axis) {
            const double inverse = 1 / ray.direction[axis];
            double enters = (low[axis] - ray.origin[axis]) * inverse;
            double leaves = (high[axis] - ray.origin[axis]) * inverse;
            if (enters > leaves) std::swap(enters, leaves);
            if (enters > min) min = enters;
            if (leaves < max) max = leaves;
            if (max <= min) return false;
        }
        return true;
    }
};

class Hittable {
  public:
    virtual ~Hittable() = default;
    virtual bool hit(const Ray& ray, double min, double max, HitRecord& record) const = 0;
    virtual Bounds bounds() const = 0;
};

class Ball : public Hittable {
  public:
    Ball(Vec center, double radius, std::shared_ptr<Material> material)
        : center_{center}, radius_{radius}, material_{std::move(material)} {}

    bool hit(const Ray& ray, double min, double max, HitRecord& record) const override {
        const Vec to_center = center_ - ray.origin;
        const double a = dot(ray.direction, ray.direction), h = dot(ray.direction, to_center);
        const double c = dot(to_center, to_center) - radius_ * radius_;
        const double discriminant = h * h - a * c;
        if (discriminant < 0) return false;
        const double root = std::sqrt(discriminant);
        double t = (h - root) / a;
        if (t <= min || max <= t) {
            t = (h + root) / a;
            if (t <= min || max <= t) return false;
        }
        record.t = t;
        record.point = ray.origin + t * ray.direction;
        const Vec outward = 1 / radius_ * (record.point - center_);
        record.front = dot(ray.direction, outward) < 0;
        record.normal = record.front ? outward : -1 * outward;
        record.material = material_;
        return true;
    }
    Bounds bounds() const override {
        const Vec r{radius_, radius_, radius_};
        return {center_ - r, center_ + r};
    }

  private:
    Vec center_;
    double radius_;
    std::shared_ptr<Material> material_;
};

class Node : public Hittable {
  public:
    using Objects = std::vector<std::shared_ptr<Hittable>>;

    Node(Objects& objects, std::size_t first, std::size_t last) {
        bounds_ = objects[first]->bounds();
        for (std::size_t i = first; i < last; ++i) {
            const Bounds b = objects[i]->bounds();
            bounds_.low = {std::min(bounds_.low.x, b.low.x), std::min(bounds_.low.y, b.low.y),
                           std::min(bounds_.low.z, b.low.z)};
            bounds_.high = {std::max(bounds_.high.x, b.high.x), std::max(bounds_.high.y, b.high.y),
                            std::max(bounds_.high.z, b.high.z)};
        }
        const Vec size = bounds_.high - bounds_.low;
        const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const std::size_t count = last - first;
        if (count == 1) {
            left_ = right_ = objects[first];
        } else if (count == 2) {
            left_ = objects[first];
            right_ = objects[first + 1];
        } else {
            const auto at = [&](std::size_t i) {
                return objects.begin() + static_cast<std::ptrdiff_t>(i);
            };
            std::sort(at(first), at(last), [axis](const auto& a, const auto& b) {
                return a->bounds().low[axis] < b->bounds().low[axis];
            });
            const std::size_t middle = first + count / 2;
            left_ = std::make_shared<Node>(objects, first, middle);
            right_ = std::make_shared<Node>(objects, middle, last);
        }
    }
    bool hit(const Ray& ray, double min, double max, HitRecord& record) const override {
        if (!bounds_.hit(ray, min, max)) return false;
        const bool left = left_->hit(ray, min, max, record);
        const bool right = right_->hit(ray, min, left ? record.t : max, record);
        return left || right;
    }
    Bounds bounds() const override { return bounds_; }

  private:
    std::shared_ptr<Hittable> left_, right_;
    Bounds bounds_;
};

inline Vec sky(Vec direction) {
    const double a = (unit(direction).y + 1) / 2;
    return (1 - a) * Vec{1, 1, 1} + a * Vec{0.5, 0.7, 1};
}

inline Vec ray_color(const Ray& ray, int depth, const Hittable& world) {
    if (depth <= 0) return {};
    HitRecord hit;
    if (!world.hit(ray, 0.001, std::numeric_limits<double>::infinity(), hit))
        return sky(ray.direction);
    Ray out;
    Vec attenuation;
    if (!hit.material->scatter(ray, hit, attenuation, out)) return {};
    return attenuation * ray_color(out, depth - 1, world);
}

}  // namespace classic
