#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <rt/color.hpp>
#include <rt/hit.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/interval.hpp>
#include <rt/ray.hpp>
#include <rt/sphere_light.hpp>
#include <rt/world.hpp>
#include <utility>
#include <variant>
#include <vector>

namespace rt {

// The shapes that lights may have. A chapter that adds a shape also adds three functions for it:
// hit_light, light_density and sample_light. (For spheres, 08.3 has the last two.)
using LightShape = std::variant<Sphere>;

// Where a ray meets a light.
inline std::optional<Real> hit_light(const Sphere& shape, const Ray& ray, Interval within) {
    return hit_sphere(shape, ray, within);
}

// A light of a scene: a shape that shines both outward and inward.
struct Light {
    LightShape shape;
    Color radiance;
    int number = 0;    // among the scene's lights, as in Hit
    int in_tree = -1;  // a sphere's number among those that stand still; -1 for another shape
};

// A sample of one of a scene's lights.
struct ChosenLight {
    LightSample sample;  // its density is that of choosing this light and this direction
    Color radiance;
    const Light* light = nullptr;
};

// Stands for a scene without lights (given): the compiler removes every call to its functions.
struct NoLights {
    static constexpr bool empty() { return true; }
    static const Light* find(const Hit&) { return nullptr; }
    static Real density(const Light&, Vec3) { return 0; }
    template <class Random>
    static std::optional<ChosenLight> choose(Vec3, Random&) {
        return {};
    }
};

// The lights of a scene (given).
class SceneLights {
  public:
    SceneLights() = default;
    // The lights come in the order of their numbers, from 0 on.
    explicit SceneLights(std::vector<Light> all) : lights_{std::move(all)} {}
    void add(const Light& light) { lights_.push_back(light); }

    bool empty() const { return lights_.empty(); }
    const std::vector<Light>& all() const { return lights_; }

    // The light that was hit; null if something else was hit.
    const Light* find(const Hit& hit) const {
        return hit.light < 0 ? nullptr : &lights_[static_cast<std::size_t>(hit.light)];
    }

    // The probability density with which choose() takes a direction in which this light is seen.
    Real density(const Light& light, Vec3 from) const {
        const auto of_shape = [&](const auto& shape) { return light_density(shape, from); };
        return std::visit(of_shape, light.shape) / static_cast<Real>(lights_.size());
    }

    // One of the lights, each equally likely, and a direction to it.
    template <class Random>
    std::optional<ChosenLight> choose(Vec3 from, Random& random) const {
        const auto count = static_cast<Real>(lights_.size());
        const auto number =
            std::min(static_cast<std::size_t>(random.uniform() * count), lights_.size() - 1);
        const Light& light = lights_[number];
        const Vec2 place = random_place(random);
        const auto of_shape = [&](const auto& shape) { return sample_light(shape, from, place); };
        std::optional<LightSample> sample = std::visit(of_shape, light.shape);
        if (!sample) return {};
        sample->density /= count;
        return ChosenLight{*sample, light.radiance, &light};
    }

  private:
    std::vector<Light> lights_;
};

// Where a ray to a light ends: at t, where it meets shape `in_tree` of the tree; -1 for no shape.
struct LightEnd {
    Real t;
    int in_tree;
};

// A light must not block its own light. So the ray ends at the t that the tree's own formula gives
// for the light, and not at the sample's distance, which is rounded differently.
inline LightEnd light_end(const ChosenLight& chosen, const Ray& ray) {
    const Light& light = *chosen.light;
    const Interval way{0, chosen.sample.distance};
    const auto of_shape = [&](const auto& shape) { return hit_light(shape, ray, way); };
    if (const std::optional<Real> t = std::visit(of_shape, light.shape)) return {*t, light.in_tree};
    return {way.max, -1};
}

// True if nothing lies between a ray's origin and the light. A world that can tell whether anything
// is in the way is asked only that; any other world is asked for the nearest hit.
template <class AnyRay, World<AnyRay> AnyWorld>
bool sees_light(const AnyWorld& world, const AnyRay& ray, const ChosenLight& chosen) {
    const Light& light = *chosen.light;
    const Interval way{0, chosen.sample.distance};
    if constexpr (requires { world.occluded(ray, way, light.in_tree); })
        if (light.in_tree >= 0) {
            const LightEnd end = light_end(chosen, {ray.origin, ray.direction});
            return !world.occluded(ray, {0, end.t}, end.in_tree);
        }
    const std::optional<Hit> hit = world.hit(ray, way);
    return !hit || hit->light == light.number;
}

}  // namespace rt
