#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <rt/hit.hpp>
#include <rt/lights.hpp>
#include <rt/running_shares.hpp>
#include <rt/triangle_light.hpp>
#include <rt/triangle_number.hpp>
#include <utility>
#include <variant>
#include <vector>

namespace rt {

// A triangle that shines (given), on both sides, and the number of its triangle in the scene.
struct LampTriangle {
    Triangle shape;
    Color radiance;
    int number = 0;
};

// How much light a lamp sends out in all (given), the mean of red, green and blue: pi times its
// surface times its radiance.
inline Real lamp_power(Real surface, Color radiance) {
    return surface * (radiance.r + radiance.g + radiance.b) * (pi / 3);
}
inline Real power_of(const Light& sphere) {
    const Real radius = std::get<Sphere>(sphere.shape).radius;
    return lamp_power(4 * pi * radius * radius, sphere.radiance);
}
inline Real power_of(const LampTriangle& triangle) {
    const auto& [a, b, c] = triangle.shape;
    return lamp_power(length(cross(b - a, c - a)), triangle.radiance);  // twice the area: two sides
}

// The powers of these spheres and triangles (given), in this order.
inline std::vector<Real> powers_of(const std::vector<Light>& spheres,
                                   const std::vector<LampTriangle>& triangles) {
    std::vector<Real> powers;
    for (const Light& sphere : spheres) powers.push_back(power_of(sphere));
    for (const LampTriangle& triangle : triangles) powers.push_back(power_of(triangle));
    return powers;
}

// Chooses among lamps by their power alone (given), wherever the light is wanted.
class ByPower {
  public:
    ByPower() = default;
    ByPower(const std::vector<Light>& spheres, const std::vector<LampTriangle>& triangles)
        : shares_{running_shares(powers_of(spheres, triangles))} {}

    Pick choose(Vec3 /*from*/, Real number) const { return pick(shares_, number); }
    Real probability(Vec3 /*from*/, std::size_t lamp) const {
        return probability_of(shares_, lamp);
    }

  private:
    std::vector<Real> shares_;
};

// The lamps of a scene that has meshes that shine (given): spheres and triangles. It has the
// functions of SceneLights, but the Chooser says how often a lamp is chosen.
template <class Chooser>
class LampsBy {
  public:
    LampsBy() = default;
    // The spheres come in the order of their numbers, from 0 on, and so do the triangles.
    LampsBy(std::vector<Light> spheres, const std::vector<LampTriangle>& triangles)
        : chooser_{spheres, triangles}, lights_{std::move(spheres)}, spheres_{lights_.size()} {
        for (const LampTriangle& triangle : triangles) {
            numbers_.push_back(triangle.number);
            // A triangle is found by its number alone, so its Light needs no shape.
            lights_.push_back({Sphere{}, triangle.radiance, kept_as_light(triangle.number)});
            triangles_.push_back(triangle.shape);
        }
    }

    bool empty() const { return lights_.empty(); }

    // The light that was hit; null if something else was hit.
    const Light* find(const Hit& hit) const {
        if (!is_triangle(hit))
            return hit.light < 0 ? nullptr : &lights_[static_cast<std::size_t>(hit.light)];
        const auto found = std::lower_bound(numbers_.begin(), numbers_.end(), triangle_number(hit));
        if (found == numbers_.end() || *found != triangle_number(hit)) return nullptr;
        return &lights_[spheres_ + static_cast<std::size_t>(found - numbers_.begin())];
    }

    // The probability density with which choose() takes the direction to this point of a light.
    Real density(const Light& light, Vec3 from, Vec3 point) const {
        const auto lamp = static_cast<std::size_t>(&light - lights_.data());
        const Real of_direction = lamp < spheres_
                                      ? light_density(std::get<Sphere>(light.shape), from)
                                      : light_density(triangles_[lamp - spheres_], from, point);
        return chooser_.probability(from, lamp) * of_direction;
    }

    // One of the lights, and a direction to it.
    template <class Random>
    std::optional<ChosenLight> choose(Vec3 from, Random& random) const {
        const Pick picked = chooser_.choose(from, random.uniform());
        const Vec2 place = random_place(random);
        if (!(picked.probability > 0)) return {};
        const Light& light = lights_[picked.index];
        std::optional<LightSample> sample =
            picked.index < spheres_
                ? sample_light(std::get<Sphere>(light.shape), from, place)
                : sample_light(triangles_[picked.index - spheres_], from, place);
        if (!sample) return {};
        sample->density *= picked.probability;
        return ChosenLight{*sample, light.radiance, &light};
    }

  private:
    Chooser chooser_;
    std::vector<Light> lights_;  // the spheres, then the triangles
    std::size_t spheres_ = 0;
    std::vector<Triangle> triangles_;
    std::vector<int> numbers_;  // of these triangles, among those of the scene
};

// The more light a lamp sends out, the more often it is chosen (given).
using MeshLights = LampsBy<ByPower>;

}  // namespace rt
