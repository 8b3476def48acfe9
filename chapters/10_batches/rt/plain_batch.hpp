#pragma once
#include <optional>
#include <rt/batch_search.hpp>
#include <rt/leave_surface.hpp>
#include <rt/ready_scene.hpp>
#include <rt/scatter_packs.hpp>
#include <rt/sort_by_kind.hpp>
#include <rt/still_world.hpp>
#include <rt/surfaces.hpp>

namespace rt {

// One bounce of all paths of a batch (given), in a scene without lights and fog: path_radiance of
// 04.7, one step for all paths at a time. Paths are sorted by what they meet. Each kind of material
// has its own kernel, which writes the paths that go on, one after the other.
template <Effects effects>
class PlainBatch {
  public:
    PlainBatch(const ReadyScene<effects>& scene, std::size_t most_paths)
        : paths(most_paths),
          light(most_paths),
          times(effects.motion ? most_paths : 0),
          scene_{scene},
          surfaces_{still_part(scene.world), scene.materials},
          search_{still_part(scene.world)},
          next_(most_paths),
          kinds_(most_paths),
          sorted_(most_paths) {}

    std::vector<PathRecord> paths;  // on their way
    std::vector<Color> light;       // of samples, once they have ended
    std::vector<Real> times;        // of samples, if anything moves

    // Makes room for the light of this many new paths.
    void begin(std::size_t count) { std::fill_n(light.begin(), count, Color{}); }

    // Takes the first `count` paths on to their next bounce, or to their end; returns how many are
    // left, and adds the number of rays to `rays`.
    std::size_t bounce(std::size_t count, bool is_last, std::uint64_t& rays) {
        rays += count;
        search_.find_nearest(std::span{paths}.first(count));
        for (std::size_t i = 0; i < count; ++i) kinds_[i] = kind_of(i);
        const auto first = sort_by_kind<types + 2>(std::span{kinds_}.first(count),
                                                   std::span{sorted_}.first(count));
        left_ = 0;
        const auto of_kind = [&](std::size_t kind) {
            return PathList{sorted_}.subspan(first[kind], first[kind + 1] - first[kind]);
        };
        [&]<std::size_t... kind>(std::index_sequence<kind...>) {
            (scatter_all<std::tuple_element_t<kind, Types>>(of_kind(kind)), ...);
        }
        (std::make_index_sequence<types>{});
        for (const std::uint32_t i : of_kind(sky)) end_in_sky(paths[i]);
        if constexpr (others) {
            for (const std::uint32_t i : of_kind(other)) scatter_other(i);
            hits_.clear();
        }
        std::swap(paths, next_);
        if (!is_last) return left_;
        for (std::size_t i = 0; i < left_; ++i) end_in_sky(paths[i]);
        return 0;
    }

  private:
    using World = typename RendererTypes<effects>::World;
    using Materials = typename RendererTypes<effects>::Materials;
    using Types = typename MaterialTypes<Materials>::All;
    static constexpr std::size_t types = std::tuple_size_v<Types>, sky = types, other = types + 1;
    static constexpr bool others = has_other_part<World>;

    std::uint8_t kind_of(std::size_t i) {
        const PathRecord& path = paths[i];
        if constexpr (others)
            if (const auto hit = hit_other_part(scene_.world, ray_of<effects>(path, times),
                                                Interval{0, path.t})) {
                hits_.push_back({static_cast<std::uint32_t>(i), *hit});
                return other;
            }
        return surfaces_.kinds[static_cast<std::size_t>(path.sphere + 1)];
    }

    void end_in_sky(const PathRecord& path) {
        light[static_cast<std::size_t>(path.sample)] = path.throughput * scene_.sky(path.direction);
    }

    template <class Material>
    void scatter_all(PathList list) {
        for (std::size_t i = 0; i < list.size(); i += pack_size)
            scatter_some<Material>(list.subspan(i, std::min(pack_size, list.size() - i)));
    }

    template <class Material>
    void scatter_some(PathList list) {
        const Arrivals at = arrive(paths.data(), surfaces_.all.data(), list);
        const Vec3Pack direction =
            scatter_pack(static_cast<const Material*>(nullptr), at, paths.data(), list);
        const Vec3Pack origin = leave_surface(at, direction);
        PathRecord* const next = &next_[left_];
        left_ += list.size();
        store(
            std::array<Pack, 8>{origin.x, origin.y, origin.z, direction.x, direction.y, direction.z,
                                pack_of(infinity), std::bit_cast<Pack>(PackMask{} - 1)},
            list.size(), [&](std::size_t i) { return &next[i]; });
        for (std::size_t i = 0; i < list.size(); ++i) {
            const PathRecord& path = paths[list[i]];
            next[i].throughput = path.throughput * attenuation<Material>(path, at, i);
            next[i].sample = path.sample;
            next[i].random = path.random;
        }
    }

    template <class Material>
    Color attenuation(const PathRecord& path, const Arrivals& at, std::size_t i) const {
        const auto sphere = static_cast<std::size_t>(path.sphere);
        if constexpr (requires(const Material& m, Hit hit) { albedo_at(m, hit); }) {
            const auto number = static_cast<std::size_t>(surfaces_.materials[sphere]);
            Hit hit;
            hit.point = get(at.point, i);
            hit.normal = get(at.normal, i);
            return albedo_at(MaterialTypes<Materials>::template get<Material>(
                                 scene_.materials.materials[number]),
                             hit);
        } else {
            return surfaces_.all[sphere].color;
        }
    }

    // Paths seldom meet what the tree does not hold: these are scattered one by one.
    void scatter_other(std::uint32_t i) {
        const auto found = std::lower_bound(
            hits_.begin(), hits_.end(), i,
            [](const auto& hit, std::uint32_t number) { return hit.first < number; });
        const Hit& hit = found->second;
        PathRecord& path = paths[i];
        const auto bounce = scene_.materials(path.direction, hit, path.random);
        if (!bounce) return;
        PathRecord& next = next_[left_++] = path;
        next.throughput *= bounce->attenuation;
        next.origin = leave_surface(hit, bounce->direction);
        next.direction = bounce->direction;
        next.t = infinity;
        next.sphere = -1;
    }

    const ReadyScene<effects>& scene_;
    Surfaces<Materials> surfaces_;
    BatchSearch search_;
    std::vector<PathRecord> next_;
    std::size_t left_ = 0;
    std::vector<std::uint8_t> kinds_;
    std::vector<std::uint32_t> sorted_;
    std::vector<std::pair<std::uint32_t, Hit>> hits_;
};

}  // namespace rt
