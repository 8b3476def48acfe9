#pragma once
#include <algorithm>
#include <optional>
#include <rt/color.hpp>
#include <rt/hit.hpp>
#include <rt/interval.hpp>
#include <rt/sphere_light.hpp>
#include <vector>

namespace rt {

// A sphere that shines both outward and inward.
struct SphereLight {
    Sphere shape;
    Color radiance;
};

// A sample of one of a scene's lights.
struct ChosenLight {
    LightSample sample;  // its density is that of choosing this light and this direction
    Color radiance;
    int material = 0;
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

// The lights of a scene (given). In the world, light k is a sphere of material first_material + k;
// no other sphere has a material with such a number.
struct SphereLights {
    std::vector<SphereLight> lights;
    int first_material = 0;

    bool empty() const { return lights.empty(); }

    // The light that was hit; null if it was not a light.
    const SphereLight* find(const Hit& hit) const {
        if (hit.material < first_material) return nullptr;
        return &lights[static_cast<std::size_t>(hit.material - first_material)];
    }

    // The probability density with which choose() takes a direction in which this light is seen.
    Real density(const SphereLight& light, Vec3 from) const {
        return light_density(light.shape, from) / static_cast<Real>(lights.size());
    }

    // One of the lights, each equally likely, and a direction to it.
    template <class Random>
    std::optional<ChosenLight> choose(Vec3 from, Random& random) const {
        const auto count = static_cast<Real>(lights.size());
        const auto number =
            std::min(static_cast<std::size_t>(random.uniform() * count), lights.size() - 1);
        auto sample = sample_light(lights[number].shape, from, random_place(random));
        if (!sample) return {};
        sample->density /= count;
        return ChosenLight{*sample, lights[number].radiance,
                           first_material + static_cast<int>(number)};
    }
};

// True if nothing is between a ray's origin and the light along it. What the ray meets first may be
// the light itself, so no distance must be compared with one that was rounded in another way.
template <class World, class AnyRay>
bool sees_light(const World& world, const AnyRay& ray, const ChosenLight& light) {
    const auto hit = world.hit(ray, Interval{0, light.sample.distance});
    return !hit || hit->material == light.material;
}

}  // namespace rt
