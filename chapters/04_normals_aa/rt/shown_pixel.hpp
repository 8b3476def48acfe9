#pragma once
#include <cmath>
#include <rt/false_colors.hpp>
#include <rt/render_pixel.hpp>
#include <vector>

namespace rt {

// A world that counts the hits along a path (given).
template <World AnyWorld>
struct HitCounter {
    const AnyWorld& world;
    int& hits;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        const std::optional<Hit> found = world.hit(ray, within);
        hits += found.has_value();
        return found;
    }
    // Shadow rays, from chapter 08 on, are not part of the path, so they are not counted.
    template <class AnyRay>
    bool occluded(const AnyRay& ray, Interval within, int number) const {
        return world.occluded(ray, within, number);
    }
};

// Which of a hit's numbers says which sphere was hit: in a world of several lists or trees, its
// material can, if each sphere has a material of its own.
using SphereNumber = int Hit::*;

// What a word of --show tells about a ray: its direction, or what it meets first.
template <class AnyRay, World<AnyRay> AnyWorld>
Shown show_hit(const std::string& word, const AnyRay& ray, const AnyWorld& world,
               SphereNumber number = &Hit::shape) {
    if (word == "direction") return ray.direction;
    const std::optional<Hit> hit = world.hit(ray, Interval{0, infinity});
    if (!hit) return {};
    if (word == "normal") return hit->normal;
    if (word == "sphere") return (*hit).*number;
    return hit->t;
}

// The standard deviation of 2 or more numbers.
inline Real deviation_of(const std::vector<Real>& numbers) {
    const auto count = static_cast<Real>(numbers.size());
    Real sum = 0, squares = 0;
    for (const Real x : numbers) sum += x;
    for (const Real x : numbers) squares += (x - sum / count) * (x - sum / count);
    return std::sqrt(squares / (count - 1));
}

// What a word of --show tells about a pixel (given): path(ray, world, random) gives the light of
// one path.
template <class AnyCamera, World AnyWorld, class Path>
Shown shown_pixel(const std::string& word, const AnyCamera& camera, const AnyWorld& world,
                  const Path& path, int samples, std::uint64_t seed, int x, int y,
                  SphereNumber number = &Hit::shape) {
    Rng random = pixel_rng(seed, x, y);
    if (word != "bounces" && word != "samples")
        return show_hit(word, make_ray(camera, x, y, {Real(0.5), Real(0.5)}, random), world,
                        number);
    int hits = 0;
    std::vector<Real> lights;
    pixel_average(samples, random, [&](Vec2 offset) {
        const Color light =
            path(make_ray(camera, x, y, offset, random), HitCounter<AnyWorld>{world, hits}, random);
        lights.push_back((light.r + light.g + light.b) / 3);
        return light;
    });
    if (hits == 0) return {};
    if (word == "samples") return deviation_of(lights);
    return static_cast<Real>(hits) / static_cast<Real>(samples);
}

}  // namespace rt
