#pragma once
// The materials of the baseline (see classic.hpp): objects on the heap with a virtual function.

#include <algorithm>
#include <memory>

#include <study/classic_numbers.hpp>

namespace study::classic {

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
    // Whether light goes on, and if so, along which ray and with what attenuation.
    virtual bool scatter(const Ray& in, const HitRecord& hit, Vec& attenuation, Ray& out) const = 0;
};

inline Vec reflect(const Vec& v, const Vec& normal) {
    return v - 2 * dot(v, normal) * normal;
}

class Matte : public Material {
  public:
    explicit Matte(const Vec& albedo) : albedo_{albedo} {}
    bool scatter(const Ray&, const HitRecord& hit, Vec& attenuation, Ray& out) const override {
        Vec direction = hit.normal + random_unit();
        if (std::abs(direction[0]) < 1e-8 && std::abs(direction[1]) < 1e-8 &&
            std::abs(direction[2]) < 1e-8)
            direction = hit.normal;
        out = {hit.point, direction};
        attenuation = albedo_;
        return true;
    }

  private:
    Vec albedo_;
};

class Metal : public Material {
  public:
    Metal(const Vec& albedo, double fuzz) : albedo_{albedo}, fuzz_{fuzz} {}
    bool scatter(const Ray& in, const HitRecord& hit, Vec& attenuation, Ray& out) const override {
        const Vec mirrored = reflect(in.direction, hit.normal);
        out = {hit.point, unit(mirrored) + fuzz_ * random_unit()};
        attenuation = albedo_;
        return dot(out.direction, hit.normal) > 0;
    }

  private:
    Vec albedo_;
    double fuzz_;
};

class Glass : public Material {
  public:
    explicit Glass(double index) : index_{index} {}
    bool scatter(const Ray& in, const HitRecord& hit, Vec& attenuation, Ray& out) const override {
        attenuation = {1, 1, 1};
        const double eta = hit.front ? 1 / index_ : index_;
        const Vec incoming = unit(in.direction);
        const double cosine = std::fmin(dot(-incoming, hit.normal), 1.0);
        const double sine = std::sqrt(1 - cosine * cosine);
        const bool reflected = eta * sine > 1 || schlick(cosine, eta) > random_double();
        out = {hit.point, reflected ? reflect(incoming, hit.normal)
                                    : refract(incoming, hit.normal, cosine, eta)};
        return true;
    }

  private:
    static Vec refract(const Vec& v, const Vec& normal, double cosine, double eta) {
        const Vec across = eta * (v + cosine * normal);
        return across - std::sqrt(std::fabs(1 - dot(across, across))) * normal;
    }
    static double schlick(double cosine, double eta) {
        const double root = (1 - eta) / (1 + eta), head_on = root * root;
        return head_on + (1 - head_on) * std::pow(1 - cosine, 5);
    }

    double index_;
};

}  // namespace study::classic
