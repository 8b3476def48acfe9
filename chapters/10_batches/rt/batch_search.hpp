#pragma once
#include <algorithm>
#include <array>
#include <numeric>
#include <rt/descend.hpp>
#include <rt/hit_pack.hpp>
#include <rt/path_record.hpp>
#include <rt/sort_by_kind.hpp>
#include <rt/vector_registers.hpp>
#include <rt/wide_tree.hpp>
#include <vector>

namespace rt {

// Finds which spheres of a tree the rays of a batch meet first, or whether they meet any (given).
// It takes lists of rays down the tree, and finds what WideTree finds, bit for bit.
class BatchSearch {
  public:
    // The tree must outlive the search.
    explicit BatchSearch(const WideTree& tree) : tree_{tree}, orders_(tree.nodes.size()) {
        for (const SphereLeaf& leaf : tree.leaves) {
            std::uint8_t size = 0;
            while (size < lanes && leaf.is_used(size)) ++size;
            leaf_sizes_.push_back(size);
        }
        for (std::size_t node = 0; node < orders_.size(); ++node)
            for (unsigned octant = 0; octant < octants; ++octant)
                orders_[node][octant] = nearest_first(tree.nodes[node], octant);
    }

    // Sets t and sphere of these paths, within [0, t].
    void find_nearest(std::span<PathRecord> paths) { search(paths, false); }

    // Sets t of those paths to `stopped` that meet anything before the hit that they come with, at
    // t on a sphere or, if that is -1, on none. Once a path is stopped, nothing is searched for it.
    void find_any(std::span<PathRecord> paths) { search(paths, true); }
    static constexpr Real stopped = -1;

    // The functions that descend() calls.
    unsigned test(std::int32_t node, PathList list, std::uint8_t* masks);
    const auto& order(std::int32_t node) const {
        return orders_[static_cast<std::size_t>(node)][octant_];
    }
    WideChild child(std::int32_t node, unsigned place) const {
        return tree_.nodes[static_cast<std::size_t>(node)].child[place];
    }
    void leaf(std::int32_t number, PathList list) {
        if (list.size() <= few_rays) return search_alone(WideChild::leaf(number), list);
        for (std::size_t i = 0; i < list.size(); i += pack_size)
            test_leaf(static_cast<std::size_t>(number),
                      list.subspan(i, std::min(pack_size, list.size() - i)));
    }

  private:
    static constexpr unsigned octants = 8;
    // This many rays or fewer are faster one by one.
    static constexpr std::size_t few_rays = 8;
    // The most lists on the way down: one for each node, and a leaf's.
    static constexpr std::size_t most_lists = WideTree::most_nodes + 1;
    using Order = std::array<std::uint8_t, lanes>;
    typedef float Eight RT_VECTOR_OF(lanes * sizeof(float));  // one number of each of eight boxes

    // WideRay of chapter 07, in one cache line, with the end that the nearest hit so far sets.
    struct alignas(64) BoxRay {
        std::array<float, 3> near_origin, far_origin, inverse;
        float max, scale;
        float unused;
    };

    static Order nearest_first(const WideNode<float>& node, unsigned octant) {
        std::array<float, lanes> along{};
        for (std::size_t i = 0; i < lanes; ++i)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const float middle = node.planes[0][axis][i] + node.planes[1][axis][i];
                along[i] += octant >> axis & 1 ? -middle : middle;
            }
        Order order;
        std::iota(order.begin(), order.end(), std::uint8_t{0});
        // Empty boxes have no middle, so they come last.
        const auto key = [&](std::uint8_t i) {
            return along[i] == along[i] ? along[i] : std::numeric_limits<float>::infinity();
        };
        std::sort(order.begin(), order.end(),
                  [&](std::uint8_t a, std::uint8_t b) { return key(a) < key(b); });
        return order;
    }

    void search(std::span<PathRecord> paths, bool any) {
        if (tree_.nodes.empty()) return;
        any_ = any;
        paths_ = paths.data();
        make_room(paths.size());
        for (std::size_t i = 0; i < paths.size(); i += pack_size)
            make_ready(i, std::min(pack_size, paths.size() - i));
        // Rays of one octant meet the planes of all boxes in the same order.
        const auto first = sort_by_kind<octants>(std::span{octants_}.first(paths.size()),
                                                 std::span{lists_}.first(paths.size()));
        for (octant_ = 0; octant_ < octants; ++octant_) {
            const std::size_t count = first[octant_ + 1] - first[octant_];
            if (count > 0)
                descend(*this, 0, PathList{lists_.data() + first[octant_], count},
                        {lists_.data() + paths.size(), masks_.data()});
        }
    }
    void make_room(std::size_t paths) {
        if (rays_.size() >= paths) return;
        rays_.resize(paths);
        octants_.resize(paths + pack_size);
        lists_.resize((most_lists + 1) * paths);
        masks_.resize(most_lists * paths);
    }
    void make_ready(std::size_t from, std::size_t size);
    void test_leaf(std::size_t leaf, PathList list);
    void search_alone(WideChild child, PathList list);
    // Sets the nearest hit of a path so far, which ends its ray.
    void set_hit(std::uint32_t path, Real t, PackInteger sphere) {
        paths_[path].t = t;
        paths_[path].sphere = sphere;
        BoxRay& ray = rays_[path];
        ray.max = static_cast<float>(t * static_cast<Real>(ray.scale));
    }

    // No ray ends before it begins: it meets no box and no sphere any more.
    void stop(std::uint32_t path) {
        paths_[path].t = stopped;
        rays_[path].max = stopped;
    }

    const WideTree& tree_;
    bool any_ = false;  // what is searched for: any hit, or the nearest
    std::vector<std::array<Order, octants>> orders_;
    std::vector<std::uint8_t> leaf_sizes_;
    PathRecord* paths_ = nullptr;
    std::vector<BoxRay> rays_;
    std::vector<std::uint8_t> octants_;
    std::vector<std::uint32_t> lists_;
    std::vector<std::uint8_t> masks_;
    unsigned octant_ = 0;
};

// Makes the rays of some paths ready for box tests, as WideRay does.
inline void BatchSearch::make_ready(std::size_t from, std::size_t size) {
    const auto packs = load_eight(size, [&](std::size_t i) { return &paths_[from + i]; });
    const Vec3Pack origin{packs[0], packs[1], packs[2]}, direction{packs[3], packs[4], packs[5]};
    const Pack scale = max_component(direction);
    const Pack margin = wide_margin<float> * max_component(origin);
    std::array<Pack, 12> numbers{};  // of a BoxRay
    PackMask octant{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Pack along = packs[3 + k], ahead = copysign(margin, along);
        numbers[k] = packs[k] + ahead;
        numbers[3 + k] = packs[k] - ahead;
        numbers[6 + k] = scale / along;
        octant |= (std::bit_cast<PackMask>(along) < 0) & (1 << k);
    }
    numbers[9] = packs[6] * scale;
    numbers[10] = scale;
    const auto record = [&](std::size_t i) { return &rays_[from + i]; };
    if constexpr (sizeof(Real) == sizeof(float))
        store(numbers, size, record);
    else
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t k = 0; k < numbers.size(); ++k)
                reinterpret_cast<float*>(record(i))[k] = static_cast<float>(numbers[k][i]);
    typedef std::uint8_t Bytes RT_VECTOR_OF(pack_size);
    const Bytes bytes = __builtin_convertvector(octant, Bytes);
    std::memcpy(&octants_[from], &bytes, sizeof bytes);
}

// Tests each ray of the list against eight boxes at once, like hit_boxes of chapter 07.
inline unsigned BatchSearch::test(std::int32_t number, PathList list, std::uint8_t* masks) {
    if (list.size() <= few_rays) {
        search_alone(WideChild::node(number), list);
        return 0;
    }
    const WideNode<float>& node = tree_.nodes[static_cast<std::size_t>(number)];
    std::array<Eight, 3> first, second;  // the planes met first and second along each axis
    for (unsigned axis = 0; axis < 3; ++axis) {
        const bool backward = octant_ >> axis & 1;
        std::memcpy(&first[axis], &node.planes[backward][axis], sizeof(Eight));
        std::memcpy(&second[axis], &node.planes[!backward][axis], sizeof(Eight));
    }
    unsigned any = 0;
    for (std::size_t n = 0; n < list.size(); ++n) {
        const BoxRay& ray = rays_[list[n]];
        Eight in{}, out = Eight{} + ray.max;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Eight enters = (first[axis] - ray.near_origin[axis]) * ray.inverse[axis],
                        leaves = (second[axis] - ray.far_origin[axis]) * ray.inverse[axis];
            // A t that is NaN fails the comparison, and its plane does not count.
            in = enters > in ? enters : in;
            out = leaves < out ? leaves : out;
        }
        const unsigned met = RT_VECTOR_BITS(in <= out);
        masks[n] = static_cast<std::uint8_t>(met);
        any |= met;
    }
    return any;
}

inline void BatchSearch::test_leaf(std::size_t leaf, PathList list) {
    const SphereLeaf& spheres = tree_.leaves[leaf];
    const std::size_t size = leaf_sizes_[leaf];  // 1 or more
    RayPack rays = load_rays(paths_, list);
    const PackMask before = rays.sphere;
    PackMask hit{};
    std::size_t i = 0;
    do hit |= hit_pack(spheres.sphere(i), spheres.number[i], rays);
    while (++i < size);
    const PackBits bits = bits_of(hit) & first_bits(list.size());
    if (any_)
        for_each_bit(bits & bits_of(rays.sphere != before), [&](std::size_t k) { stop(list[k]); });
    else
        for_each_bit(bits, [&](std::size_t k) { set_hit(list[k], rays.t[k], rays.sphere[k]); });
}

// The search of chapter 07, from a node or leaf on, for one ray after the other.
inline void BatchSearch::search_alone(WideChild child, PathList list) {
    for (const std::uint32_t i : list) {
        const PathRecord& path = paths_[i];
        const Ray ray{path.origin, path.direction};
        const auto before = static_cast<std::int32_t>(path.sphere);
        if (any_) {
            if (path.t >= 0 && tree_.occluded(ray, {0, path.t}, before, child)) stop(i);
            continue;
        }
        WideHit best{path.t, before};
        if (child.is_leaf())
            hit_leaf(tree_.leaves[static_cast<std::size_t>(child.number())], ray, 0, best);
        else
            best = tree_.search(ray, {0, path.t}, child, before).best;
        if (best.number != before) set_hit(i, best.t, best.number);
    }
}

}  // namespace rt
