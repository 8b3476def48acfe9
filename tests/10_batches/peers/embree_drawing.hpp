#pragma once
// A picture drawn with Embree's search, and everything else from the course.

#include <rt/batch_renderer.hpp>
#include <rt/counting_world.hpp>
#include <rt/path.hpp>
#include <rt/ready_scene.hpp>
#include <rt/sample_rng.hpp>
#include <study/timing.hpp>

#include "embree_world.hpp"

namespace peers {

using namespace rt;

inline constexpr int picture_width = 400, picture_height = 225;  // pixels

// Finds the hits of many rays.
using Many = void (EmbreeWorld::*)(EmbreeWorld::Rays&) const;

template <Effects effects>
class EmbreeDrawing {
  public:
    struct Drawn {
        Color sum;
        std::uint64_t rays = 0;
    };

    EmbreeDrawing(const ReadyScene<effects>& scene, const Quality& quality)
        : scene_{scene}, quality_{quality} {}

    // The loop of chapter 08, a path at a time.
    Drawn paths(const EmbreeWorld& world) const {
        Drawn drawn;
        const CountingWorld<EmbreeWorld> counting{world, drawn.rays};
        each_sample([&](const Ray& ray, Rng random) {
            drawn.sum += path_radiance(ray, counting, scene_.materials, scene_.sky, SkyEnding{},
                                       quality_.depth, random);
        });
        return drawn;
    }

    // As many paths as chapter 10 has in a batch make a bounce together; they are shaded one by
    // one. Each wave of rays is shown before it is asked for.
    template <class Show>
    Drawn waves(const EmbreeWorld& world, Many search, const Show& show) const {
        Drawn drawn;
        std::vector<Path> paths;
        EmbreeWorld::Rays rays;
        const auto trace = [&] {
            for (int bounces = 1; !paths.empty(); ++bounces) {
                show(paths);
                rays.resize(paths.size());
                for (std::size_t i = 0; i < paths.size(); ++i)
                    EmbreeWorld::put(paths[i].ray, rays[i]);
                (world.*search)(rays);
                drawn.rays += rays.size();
                std::size_t left = 0;
                for (std::size_t i = 0; i < paths.size(); ++i) {
                    Path& path = paths[i];
                    const auto hit = world.hit_of(path.ray, rays[i]);
                    if (hit && !scatter(path, *hit)) continue;
                    if (hit && bounces < quality_.depth)
                        paths[left++] = path;
                    else
                        drawn.sum += path.throughput * scene_.sky(path.ray.direction);
                }
                paths.resize(left);
            }
        };
        each_sample([&](const Ray& ray, Rng random) {
            paths.push_back({ray, {1, 1, 1}, random});
            if (paths.size() == batch_size) trace();
        });
        trace();
        return drawn;
    }
    Drawn waves(const EmbreeWorld& world, Many search) const {
        return waves(world, search, [](const auto&) {});
    }

  private:
    struct Path {
        Ray ray;
        Color throughput{1, 1, 1};
        Rng random{0, 0};
    };

    bool scatter(Path& path, const Hit& hit) const {
        const auto bounce = scene_.materials(path.ray.direction, hit, path.random);
        if (!bounce) return false;
        path.throughput *= bounce->attenuation;
        path.ray = {leave_surface(hit, bounce->direction), bounce->direction};
        return true;
    }

    // follow(ray, random) for the samples of all pixels, as Renderer has them.
    template <class Follow>
    void each_sample(const Follow& follow) const {
        for (int row = 0; row < picture_height; ++row)
            for (int column = 0; column < picture_width; ++column) {
                Rng places = pixel_rng(quality_.seed, column, row);
                int sample = 0;
                study::keep(pixel_average(quality_.samples_per_pixel, places, [&](Vec2 offset) {
                    Rng random = sample_rng(quality_.seed, column, row, sample++);
                    follow(make_ray(scene_.camera, column, row, offset, random), random);
                    return Color{};
                }));
            }
    }

    const ReadyScene<effects>& scene_;
    Quality quality_;
};

}  // namespace peers
