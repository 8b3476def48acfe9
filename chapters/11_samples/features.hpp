#pragma once
// What a denoiser knows about a pixel besides its noisy light: the surface that is seen there.

#include <rt/denoise.hpp>
#include <rt/renderer.hpp>
#include <rt/sobol_samples.hpp>
#include <type_traits>

namespace samples {

using namespace rt;

inline Color albedo_of(const Dielectric&, const Hit&) {
    return {1, 1, 1};
}
template <class Material>
Color albedo_of(const Material& material, const Hit& hit) {
    if constexpr (requires { material.albedo; })
        return material.albedo;
    else
        return albedo_at(material, hit);
}

// The surface that the eye sees along a ray. Lamps and the sky, which shine by themselves, get the
// albedo with which they would look the same in light of this strength. So where a lamp and a lit
// surface share a pixel, light divided by albedo is similar for both.
template <Effects effects>
Features features_along(const ReadyScene<effects>& scene, const Ray& ray, Real strength) {
    const auto hit = scene.world.hit(ray, Interval{0, infinity});
    if (!hit) return {scene.sky(ray.direction) / strength, {}};
    if (const Light* const light = scene.lights.find(*hit))
        return {light->radiance / strength, hit->normal};
    const auto& material = scene.materials.materials[static_cast<std::size_t>(hit->material)];
    return {std::visit([&](const auto& kind) { return albedo_of(kind, *hit); }, material),
            facing_normal(*hit)};
}

// The mean of features_along() over a pixel: at an edge, or where the lens blurs the picture,
// several surfaces have a share in it.
template <Effects effects>
Features features_at(const ReadyScene<effects>& scene, const SobolSamples& samples, int column,
                     int row, Real strength) {
    Vec3 normal;
    const Color albedo =
        samples.average(scene.camera, column, row, [&](const Ray& ray, SobolRandom& /*random*/) {
            const Features one = features_along(scene, ray, strength);
            normal += one.normal;
            return one.albedo;
        });
    return {albedo, normal / static_cast<Real>(samples.count)};
}

}  // namespace samples
