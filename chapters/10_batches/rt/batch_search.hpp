#pragma once
#include <algorithm>
#include <array>
#include <numeric>
#include <rt/descend.hpp>
#include <rt/hit_pack.hpp>
#include <rt/path_record.hpp>
#include <rt/vector_registers.hpp>
#include <rt/wide_tree.hpp>
#include <vector>

namespace rt {

// Finds the nearest sphere of a tree for each ray of a batch (given). The search takes lists of
// rays down the tree; its results are the same as those of WideTree, bit for bit.
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

    // Makes room for this many rays. Rays that are ready stay ready.
    void make_room(std::size_t rays);

    // The list of the first `count` paths; there must be room for their rays.
    PathList all(std::size_t count) const { return PathList{all_}.first(count); }

    // Makes the rays of up to pack_size paths ready for box tests; the first of these paths has the
    // number `from`. The rays end at t. Unused lanes write to the rays that come next, so make rays
    // ready in ascending order.
    void make_ready(std::size_t from, const Vec3Pack& origin, const Vec3Pack& direction, Pack t);
    // The same for all of these paths, beginning with number 0; makes room for their rays, too.
    void make_ready(std::span<const PathRecord> paths);

    // Sets `t` and `sphere` of these paths to their nearest hits within [0, t]. Their rays must be
    // ready.
    void find_nearest(std::span<PathRecord> paths);

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
            test_leaf(static_cast<std::size_t>(number), list.subspan(i));
    }

  private:
    static constexpr unsigned octants = 8;
    // If a list has at most this many rays, it is faster to search for one ray after the other.
    static constexpr std::size_t few_rays = 4;
    // The largest number of lists on a way down the tree: one for each node, and one for the leaf.
    static constexpr std::size_t most_lists = WideTree::most_nodes + 1;
    using Order = std::array<std::uint8_t, lanes>;
    typedef float Eight RT_VECTOR_OF(lanes * sizeof(float));  // one number of each of eight boxes

    // A ray for box tests, in one cache line. It ends at `max`, where its nearest hit so far is.
    struct alignas(64) BoxRay {
        // 1 / direction, and -origin / direction: a plane at x is met at x * inverse + start. The
        // nearer plane is moved toward the ray, and the farther one away from it, by wide_margin.
        // If a start is too large for float, it is NaN, and the plane does not count. This takes
        // one instruction for a plane where hit_box takes three; the roundings, seven as there, act
        // as if the plane were moved by less than 4 epsilon of float.
        std::array<float, 3> inverse, near_start, far_start;
        Real scale;  // as in WideRay
        float max;
    };

    static Order nearest_first(const WideNode<float>& node, unsigned octant);
    void test_leaf(std::size_t leaf, PathList list);
    void search_alone(WideChild child, PathList list);
    // Sets the nearest hit of a path so far. The path's ray now ends there.
    void set_hit(std::uint32_t path, Real t, PackInteger sphere) {
        paths_[path].t = t;
        paths_[path].sphere = sphere;
        BoxRay& ray = rays_[path];
        ray.max = static_cast<float>(t * ray.scale);
    }

    const WideTree& tree_;
    std::vector<std::array<Order, octants>> orders_;
    std::vector<std::uint8_t> leaf_sizes_;
    PathRecord* paths_ = nullptr;
    std::vector<BoxRay> rays_;
    std::vector<std::uint8_t> octants_;  // of each ray, as a mask: bit k for octant k
    std::vector<std::uint32_t> all_;     // 0, 1, 2 ...
    std::vector<std::uint32_t> lists_;
    std::vector<std::uint8_t> masks_;
    unsigned octant_ = 0;
};

inline BatchSearch::Order BatchSearch::nearest_first(const WideNode<float>& node, unsigned octant) {
    std::array<float, lanes> along{};
    for (std::size_t i = 0; i < lanes; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float middle = node.planes[0][axis][i] + node.planes[1][axis][i];
            along[i] += octant >> axis & 1 ? -middle : middle;
        }
    Order order;
    std::iota(order.begin(), order.end(), std::uint8_t{0});
    // The middle of an empty box is NaN; such boxes come last.
    const auto key = [&](std::uint8_t i) {
        return along[i] == along[i] ? along[i] : std::numeric_limits<float>::infinity();
    };
    std::sort(order.begin(), order.end(),
              [&](std::uint8_t a, std::uint8_t b) { return key(a) < key(b); });
    return order;
}

inline void BatchSearch::make_room(std::size_t rays) {
    if (all_.size() >= rays + pack_size) return;
    // Packs that are not full write and read beyond the last ray.
    rays_.resize(rays + pack_size);
    octants_.resize(rays + pack_size);
    all_.resize(rays + pack_size);
    std::iota(all_.begin(), all_.end(), 0u);
    lists_.resize((most_lists + 1) * rays + pack_size);
    masks_.resize(most_lists * rays);
}

inline void BatchSearch::make_ready(std::size_t from, const Vec3Pack& origin,
                                    const Vec3Pack& direction, Pack t) {
    const Pack scale = max_component(direction);
    const Pack margin = wide_margin<float> * max_component(origin);
    const Pack least = least_component * scale;
    const auto raised = [least](Pack x) { return abs(x) < least ? copysign(least, x) : x; };
    const Pack origins[]{origin.x, origin.y, origin.z},
        directions[]{raised(direction.x), raised(direction.y), raised(direction.z)};
    std::array<Pack, 12> numbers{};  // of a BoxRay
    PackMask octant{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Pack ahead = copysign(margin, directions[k]);
        const Pack inverse = scale / directions[k];
        numbers[k] = inverse;
        numbers[3 + k] = finite_or_nan((-ahead - origins[k]) * inverse);
        numbers[6 + k] = finite_or_nan((ahead - origins[k]) * inverse);
        octant |= (std::bit_cast<PackMask>(directions[k]) < 0) & (1 << k);
    }
    numbers[9] = scale;
    numbers[10] = t * scale;
    if constexpr (sizeof(Real) == sizeof(float))
        store(numbers, [&](std::size_t i) { return &rays_[from + i]; });
    else
        for (std::size_t i = 0; i < pack_size; ++i) {
            BoxRay& ray = rays_[from + i];
            for (std::size_t k = 0; k < 3; ++k) {
                ray.inverse[k] = static_cast<float>(numbers[k][i]);
                ray.near_start[k] = finite_or_nan(static_cast<float>(numbers[3 + k][i]));
                ray.far_start[k] = finite_or_nan(static_cast<float>(numbers[6 + k][i]));
            }
            ray.scale = scale[i];
            ray.max = static_cast<float>(numbers[10][i]);
        }
    typedef std::uint8_t Bytes RT_VECTOR_OF(pack_size);
    const Bytes bytes = __builtin_convertvector((PackMask{} + 1) << octant, Bytes);
    std::memcpy(&octants_[from], &bytes, sizeof bytes);
}

inline void BatchSearch::make_ready(std::span<const PathRecord> paths) {
    make_room(paths.size());
    for (std::size_t i = 0; i < paths.size(); i += pack_size) {
        const PathPack pack{all(paths.size()).subspan(i)};
        const RayPack rays = load_rays(paths.data(), pack);
        make_ready(i, rays.origin, rays.direction, rays.t);
    }
}

inline void BatchSearch::find_nearest(std::span<PathRecord> paths) {
    if (tree_.nodes.empty()) return;
    paths_ = paths.data();
    // Rays of one octant meet the planes of all boxes in the same order.
    for (octant_ = 0; octant_ < octants; ++octant_) {
        const std::size_t count =
            filter_list(all(paths.size()), octants_.data(), octant_, lists_.data());
        if (count > 0)
            descend(*this, 0, {lists_.data(), count}, {lists_.data() + count, masks_.data()});
    }
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
        Eight in{}, out = ray.max - Eight{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Eight enters = RT_FUSED(first[axis], ray.inverse[axis], ray.near_start[axis]),
                        leaves = RT_FUSED(second[axis], ray.inverse[axis], ray.far_start[axis]);
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

// Tests the first pack of rays in a list against the spheres of a leaf. The pack need not be full.
inline void BatchSearch::test_leaf(std::size_t leaf, PathList list) {
    const SphereLeaf& spheres = tree_.leaves[leaf];
    const std::size_t size = leaf_sizes_[leaf];
    const PathPack pack{list};
    RayPack rays = load_rays(paths_, pack);
    const PackMask before = rays.sphere;
    for (std::size_t i = 0; i < size; ++i) hit_pack(spheres.sphere(i), spheres.number[i], rays);
    if (bits_of(rays.sphere != before) == 0) return;
    // All lanes are written, because no processor can predict which hits have changed.
    for (std::size_t k = 0; k < pack_size; ++k) set_hit(pack[k], rays.t[k], rays.sphere[k]);
}

// The search of chapter 07, from this node or leaf on, for one ray after the other.
inline void BatchSearch::search_alone(WideChild child, PathList list) {
    for (const std::uint32_t i : list) {
        const PathRecord& path = paths_[i];
        const auto& [inverse_x, inverse_y, inverse_z] = rays_[i].inverse;
        const auto before = static_cast<std::int32_t>(path.sphere);
        const auto found = tree_.search(
            {path.origin, path.direction},
            wide_ray<float>(path.origin, {inverse_x, inverse_y, inverse_z}, rays_[i].scale),
            {0, path.t}, child, before);
        if (found.nearest != before) set_hit(i, found.within.max, found.nearest);
    }
}

}  // namespace rt
