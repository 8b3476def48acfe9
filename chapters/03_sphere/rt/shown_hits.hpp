#pragma once
#include <rt/false_color_image.hpp>
#include <rt/make_camera.hpp>
#include <rt/nearest_sphere.hpp>
#include <rt/primary_ray.hpp>
#include <span>

namespace rt {

// What a word of --show tells about a ray (given): its direction, or which sphere it hits first, at
// what distance, and with which normal.
inline Shown shown_hit(const std::string& word, std::span<const SceneSphere> spheres,
                       const Ray& ray) {
    if (word == "direction") return ray.direction;
    const auto nearest = nearest_sphere(spheres, ray, {0, infinity});
    if (!nearest) return {};
    if (word == "sphere") return static_cast<int>(nearest->number);
    if (word == "distance") return nearest->t;
    const Sphere& sphere = spheres[nearest->number].shape;
    return (ray.at(nearest->t) - sphere.center) / sphere.radius;
}

// The picture that --show asks for, drawn by a tracer that follows no paths yet (given).
inline Image shown_hits(const TracerCall& call, const SceneText& scene, const Camera& camera) {
    expect(call.show != "bounces" && call.show != "samples",
           "direction, normal, distance or sphere: this tracer follows no paths yet");
    return false_color_image(call, scene, [&](int x, int y) {
        const Ray ray = primary_ray(camera, x, y, {Real(0.5), Real(0.5)});
        return shown_hit(call.show, scene.spheres, ray);
    });
}

}  // namespace rt
