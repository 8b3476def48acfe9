#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <rt/color.hpp>
#include <rt/hit.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/interval.hpp>
#include <rt/sphere_light.hpp>
#include <vector>

namespace rt {

// A sphere that shines both outward and inward.
struct SphereLight {
    Sphere shape;
    Color radiance;
    int material = 0;  // no other sphere has this material, so it tells which light was hit
    int number = -1;   // of the sphere, among those that stand still
};

// A sample of one of a scene's lights.
struct ChosenLight {
    LightSample sample;  // its density is that of choosing this light and this direction
    Color radiance;
    const SphereLight* light = nullptr;
};

// A scene without lights (given): the compiler removes every call to it.
struct NoLights {
    static constexpr bool empty() { return true; }
    static const SphereLight* find(const Hit&) { return nullptr; }
    static Real density(const SphereLight&, Vec3) { return 0; }
    template <class Random>
    static std::optional<ChosenLight> choose(Vec3, Random&) {
        return {};
    }
};

// The lights of a scene (given).
class SphereLights {
  public:
    SphereLights() = default;
    explicit SphereLights(std::vector<SphereLight> all) {
        for (const SphereLight& light : all) add(light);
    }

    void add(const SphereLight& light) {
        const auto material = static_cast<std::size_t>(light.material);
        if (material >= light_of_.size()) light_of_.resize(material + 1, none);
        light_of_[material] = static_cast<std::int32_t>(lights_.size());
        lights_.push_back(light);
    }

    bool empty() const { return lights_.empty(); }

    // The light that was hit; null if it was not a light.
    const SphereLight* find(const Hit& hit) const {
        const auto material = static_cast<std::size_t>(hit.material);
        if (material >= light_of_.size() || light_of_[material] == none) return nullptr;
        return &lights_[static_cast<std::size_t>(light_of_[material])];
    }

    // The probability density with which choose() takes a direction in which this light is seen.
    Real density(const SphereLight& light, Vec3 from) const {
        return light_density(light.shape, from) / static_cast<Real>(lights_.size());
    }

    // One of the lights, each equally likely, and a direction to it.
    template <class Random>
    std::optional<ChosenLight> choose(Vec3 from, Random& random) const {
        const auto count = static_cast<Real>(lights_.size());
        const auto number =
            std::min(static_cast<std::size_t>(random.uniform() * count), lights_.size() - 1);
        auto sample = sample_light(lights_[number].shape, from, random_place(random));
        if (!sample) return {};
        sample->density /= count;
        return ChosenLight{*sample, lights_[number].radiance, &lights_[number]};
    }

  private:
    static constexpr std::int32_t none = -1;
    std::vector<SphereLight> lights_;
    std::vector<std::int32_t> light_of_;  // of each material, or none
};

// True if nothing is between a ray's origin and the light along it. A world that can say whether
// anything is in the way is asked no more than that; others are asked for the nearest hit.
template <class World, class AnyRay>
bool sees_light(const World& world, const AnyRay& ray, const ChosenLight& chosen) {
    const SphereLight& light = *chosen.light;
    const Interval way{0, chosen.sample.distance};
    if constexpr (requires { world.occluded(ray, way, light.number); }) {
        // The light itself is not in its own way. So the ray ends where it meets the light by the
        // same formula as any other sphere, and not at a distance that was rounded in another way.
        const auto t = hit_sphere(light.shape, {ray.origin, ray.direction}, way);
        return t ? !world.occluded(ray, {0, *t}, light.number) : !world.occluded(ray, way, -1);
    } else {
        const auto hit = world.hit(ray, way);
        return !hit || hit->material == light.material;
    }
}

}  // namespace rt
