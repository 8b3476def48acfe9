#pragma once
#include <rt/batch_search.hpp>
#include <rt/ready_scene.hpp>
#include <rt/rng.hpp>
#include <rt/scatter_packs.hpp>
#include <rt/sort_by_kind.hpp>
#include <rt/surfaces.hpp>

namespace rt {

// A batch of paths that make each bounce together (given). It does what path_radiance of 04.7 does,
// but finishes each step for all paths before the next step begins. The paths are sorted by the
// kind of material that they meet, and each kind has its own kernel. The paths that go on are
// written without gaps, and their rays are made ready for the next search.
template <Effects effects, class Random = Rng>
class PlainBatch {
  public:
    PlainBatch(const ReadyScene<effects>& scene, std::size_t most_paths)
        : paths(most_paths + pack_size),
          light(most_paths),
          scene_{scene},
          surfaces_{scene.world, scene.materials},
          search_{scene.world},
          next_(paths.size()),
          kinds_(most_paths),
          sorted_(2 * most_paths) {
        randoms.reserve(most_paths);
        search_.make_room(most_paths);
    }

    std::vector<PathRecord> paths;  // on their way; with room for unused lanes of the last pack
    std::vector<Color> light;       // of each sample, once its path has ended
    std::vector<Random> randoms;    // each sample's generator

    // Sets the light of the first `count` samples to 0, for new paths.
    void begin(std::size_t count) { std::fill_n(light.begin(), count, Color{}); }

    // Sets the rays of a pack of paths, the first of which has the number `from`. Calls must come
    // in ascending order of `from`.
    void set_rays(std::size_t from, const Vec3Pack& origin, const Vec3Pack& direction) {
        set_rays(paths, from, origin, direction);
    }

    // Follows the first `count` paths to their next bounce, or to their end. Returns how many paths
    // go on, and adds the number of rays to `rays`.
    std::size_t bounce(std::size_t count, bool is_last, std::uint64_t& rays) {
        rays += count;
        search_.find_nearest(std::span{paths}.first(count));
        for (std::size_t i = 0; i < count; ++i)
            kinds_[i] = surfaces_.kinds[static_cast<std::size_t>(paths[i].sphere + 1)];
        const auto first =
            sort_by_kind<types + 1>(search_.all(count), kinds_.data(), sorted_.data());
        left_ = 0;
        const auto of_kind = [&](std::size_t kind) {
            return PathList{sorted_}.subspan(first[kind], first[kind + 1] - first[kind]);
        };
        [&]<std::size_t... kind>(std::index_sequence<kind...>) {
            (scatter_all<std::tuple_element_t<kind, Types>>(of_kind(kind)), ...);
        }
        (std::make_index_sequence<types>{});
        for (const std::uint32_t i : of_kind(sky)) end_in_sky(paths[i]);
        std::swap(paths, next_);
        if (!is_last) return left_;
        for (std::size_t i = 0; i < left_; ++i) end_in_sky(paths[i]);
        return 0;
    }

  private:
    using Materials = typename RendererTypes<effects>::Materials;
    using Types = typename MaterialTypes<Materials>::All;
    static constexpr std::size_t types = std::tuple_size_v<Types>, sky = types;

    void end_in_sky(const PathRecord& path) {
        light[static_cast<std::size_t>(path.sample)] = path.throughput * scene_.sky(path.direction);
    }

    void set_rays(std::vector<PathRecord>& of, std::size_t from, const Vec3Pack& origin,
                  const Vec3Pack& direction) {
        const Pack t = pack_of(infinity), none = std::bit_cast<Pack>(PackMask{} - 1);
        store(std::array<Pack, 8>{origin.x, origin.y, origin.z, direction.x, direction.y,
                                  direction.z, t, none},
              [&](std::size_t i) { return &of[from + i]; });
        search_.make_ready(from, origin, direction, t);
    }

    template <class Material>
    void scatter_all(PathList list) {
        for (std::size_t i = 0; i < list.size(); i += pack_size)
            scatter_some<Material>(PathPack{list.subspan(i)});
    }

    template <class Material>
    RT_INLINES_ALL void scatter_some(const PathPack& pack) {
        const Arrivals at = arrive(paths.data(), surfaces_.all.data(), pack);
        const auto random = [&](std::size_t i) -> Random& {
            return randoms[static_cast<std::size_t>(paths[pack[i]].sample)];
        };
        const Vec3Pack direction =
            scatter_pack(static_cast<const Material*>(nullptr), at, random, pack);
        set_rays(next_, left_, leave_surface(at, direction), direction);
        for (std::size_t i = 0; i < pack.size; ++i) {
            const PathRecord& path = paths[pack[i]];
            PathRecord& next = next_[left_++];
            next.throughput = path.throughput * attenuation<Material>(path, at, i);
            next.sample = path.sample;
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

    const ReadyScene<effects>& scene_;
    Surfaces<Materials> surfaces_;
    BatchSearch search_;
    std::vector<PathRecord> next_;
    std::size_t left_ = 0;
    std::vector<std::uint8_t> kinds_;    // of each path, as a mask: bit k for kind k
    std::vector<std::uint32_t> sorted_;  // has the room that sort_by_kind asks for
};

}  // namespace rt
