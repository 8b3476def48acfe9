#pragma once
#include <optional>
#include <rt/batch_search.hpp>
#include <rt/lit_path.hpp>
#include <rt/ready_scene.hpp>
#include <rt/shared_weight.hpp>
#include <rt/still_world.hpp>
#include <rt/surface_hit.hpp>
#include <rt/surfaces.hpp>

namespace rt {

// A world that already knows its answer.
struct FoundHit {
    std::optional<Hit> found;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay&, Interval) const {
        return found;
    }
};

// A world that is searched later: direct_light() goes on as if the light were seen, and its shadow
// ray is kept, with its end, and the light to which it leads.
struct AskedLater {
    PathRecord& shadow_ray;
    const Light*& light;
};
template <class AnyRay>
bool sees_light(const AskedLater& world, const AnyRay& ray, const ChosenLight& chosen) {
    const LightEnd end = light_end(chosen, {ray.origin, ray.direction});
    world.shadow_ray.origin = ray.origin;
    world.shadow_ray.direction = ray.direction;
    world.shadow_ray.t = end.t;
    world.shadow_ray.sphere = end.in_tree;
    world.light = chosen.light;
    return true;
}

// One bounce of all paths of a batch (given), in a scene with lights or fog: lit_path_radiance of
// 08.4, one step for all paths at a time. Rays and shadow rays go down the tree in lists; the
// scalar code computes the light of each path.
template <Effects effects>
class LitBatch {
  public:
    LitBatch(const ReadyScene<effects>& scene, std::size_t most_paths)
        : paths(most_paths),
          light(most_paths),
          times(effects.motion ? most_paths : 0),
          scene_{scene},
          surfaces_{still_part(scene.world), scene.materials},
          search_{still_part(scene.world)},
          origins_(most_paths) {}

    std::vector<PathRecord> paths;  // on their way
    std::vector<Color> light;       // of samples, as far as it has been collected
    std::vector<Real> times;        // of samples, if anything moves

    // Makes room for the light of this many new paths.
    void begin(std::size_t count) {
        std::fill_n(light.begin(), count, Color{});
        std::fill_n(origins_.begin(), count, Origin{});
    }

    std::size_t bounce(std::size_t count, bool is_last, std::uint64_t& rays) {
        search_.find_nearest(std::span{paths}.first(count));
        shadow_rays_.clear();
        aims_.clear();
        ends_.clear();
        std::size_t left = 0;
        for (std::size_t i = 0; i < count; ++i) {
            PathRecord path = paths[i];
            if (!go_on(path, is_last)) continue;
            path.t = infinity;
            path.sphere = -1;
            paths[left++] = path;
        }
        rays += count + shadow_rays_.size();
        search_.find_any(shadow_rays_);
        for (std::size_t i = 0; i < shadow_rays_.size(); ++i)
            if (arrives(shadow_rays_[i], *aims_[i]))
                light[index(shadow_rays_[i])] += shadow_rays_[i].throughput;
        for (const auto& [sample, last] : ends_) light[sample] += last;
        return left;
    }

  private:
    // Where a sample's ray comes from, and the density with which its direction was drawn.
    struct Origin {
        Vec3 from;
        Real drawn = 0;
    };

    static std::size_t index(const PathRecord& path) {
        return static_cast<std::size_t>(path.sample);
    }
    // The hit of a ray: on the tree's nearest sphere, unless something else is nearer.
    std::optional<Hit> found(const PathRecord& path) const {
        const auto ray = ray_of<effects>(path, times);
        if (const auto other = hit_other_part(scene_.world, ray, Interval{0, path.t})) return other;
        if (path.sphere < 0) return {};
        const auto number = static_cast<std::size_t>(path.sphere);
        Hit hit = surface_hit(surfaces_.sphere(number), {path.origin, path.direction}, path.t);
        hit.material = surfaces_.materials[number];
        hit.light = surfaces_.lights[number];
        return hit;
    }

    // True if nothing is in the way of a shadow ray: sees_light, after the search through the tree.
    bool arrives(const PathRecord& shadow_ray, const Light& aim) const {
        if (shadow_ray.t == BatchSearch::stopped) return false;
        const auto ray = ray_of<effects>(shadow_ray, times);
        const Interval way{0, shadow_ray.t};
        if (aim.in_tree >= 0) return !other_part_occludes(scene_.world, ray, way);
        const auto hit = hit_other_part(scene_.world, ray, way);
        return !hit || hit->light == aim.number;
    }

    void end(const PathRecord& path, Color last) { ends_.push_back({index(path), last}); }

    // The body of lit_path_radiance's loop; false if the path ends.
    bool go_on(PathRecord& path, bool is_last) {
        const auto ray = ray_of<effects>(path, times);
        Origin& origin = origins_[index(path)];
        const auto place =
            next_place(ray, FoundHit{found(path)}, scene_.materials, scene_.fog, path.random);
        if (place.is_sky()) {
            end(path, path.throughput * scene_.sky(ray.direction));
            return false;
        }
        if (const Light* const met = place.light(scene_.lights)) {
            const Real weight =
                origin.drawn > 0
                    ? shared_weight(origin.drawn, scene_.lights.density(*met, origin.from))
                    : Real(1);
            end(path, path.throughput * (weight * met->radiance));
            return false;
        }
        const std::optional<Scatter> bounce = place.scatter(path.random);
        if (!bounce) return false;
        path.throughput *= bounce->attenuation;
        if (!scene_.lights.empty()) {
            origin.drawn = place.density(bounce->direction);
            if (origin.drawn > 0) look_for_light(path, ray, place, !is_last);
        }
        origin.from = place.point;
        path.origin = place.origin(bounce->direction);
        path.direction = bounce->direction;
        if (!is_last) return true;
        end(path, path.throughput * scene_.sky(path.direction));
        return false;
    }

    template <class AnyRay, class Place>
    void look_for_light(PathRecord& path, const AnyRay& ray, const Place& place, bool goes_on) {
        PathRecord shadow_ray;
        const Light* aim = nullptr;
        const Color share =
            path.throughput * direct_light(ray, AskedLater{shadow_ray, aim}, scene_.lights, place,
                                           goes_on, path.random);
        if (!aim) return;
        shadow_ray.throughput = share;
        shadow_ray.sample = path.sample;
        shadow_rays_.push_back(shadow_ray);
        aims_.push_back(aim);
    }

    const ReadyScene<effects>& scene_;
    Surfaces<typename RendererTypes<effects>::Materials> surfaces_;
    BatchSearch search_;
    std::vector<Origin> origins_;
    std::vector<PathRecord> shadow_rays_;  // throughput: the light, if nothing is in the way
    std::vector<const Light*> aims_;       // of the shadow rays
    std::vector<std::pair<std::size_t, Color>> ends_;
};

}  // namespace rt
