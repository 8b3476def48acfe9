#pragma once
#include <algorithm>
#include <memory>
#include <rt/any_hit.hpp>
#include <rt/area_split.hpp>
#include <rt/instance.hpp>
#include <rt/placed_mesh.hpp>
#include <rt/shape_tree.hpp>
#include <rt/triangle_leaf.hpp>
#include <rt/triangle_shape.hpp>
#include <rt/wide_builder.hpp>
#include <thread>
#include <utility>
#include <vector>

namespace rt {

// All threads that run at the same time.
inline int threads_to_build() {
    return static_cast<int>(std::thread::hardware_concurrency());
}

// A mesh as it is stored for its instances (given): its triangles in a tree, and the box around
// them, in the mesh's own coordinates.
struct MeshTree {
    TriangleTree tree;
    Box box;

    explicit MeshTree(const Mesh& mesh)
        : tree{make_wide_tree(triangles_of(mesh, 0, 0), threads_to_build())} {
        for (const Vec3& point : mesh.points) box = join(box, {point, point});
    }
};

// A place of a mesh that is not copied (given). A ray that meets its box goes on in the mesh's own
// coordinates, through the mesh's tree. Only boxes are tested there, with a margin for all
// roundings; the triangles of the leaves that are met are put at their places, and tested there.
// So each hit has the same bits as that of a copy.
class MeshInstance {
  public:
    MeshInstance(const PlacedMesh& placed, std::shared_ptr<const MeshTree> tree)
        : placed_{&placed}, tree_{std::move(tree)} {
        const auto& [to_world, to_object, material] = placed.instance();
        Real rounded = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const Box& of = tree_->box;
            const Vec3 here{corner & 1 ? of.high.x : of.low.x, corner & 2 ? of.high.y : of.low.y,
                            corner & 4 ? of.high.z : of.low.z};
            const Vec3 there = transform_point(to_world, here);
            box_ = join(box_, {there, there});
            rounded = std::max(rounded, largest_sum(to_world, abs(here)));
            // The two matrices are inverse to each other except for rounding.
            slack_ = std::max(slack_, 2 * max_component(transform_point(to_object, there) - here));
        }
        reach_ = {std::max(std::abs(box_.low.x), std::abs(box_.high.x)),
                  std::max(std::abs(box_.low.y), std::abs(box_.high.y)),
                  std::max(std::abs(box_.low.z), std::abs(box_.high.z))};
        const Real grow = hit_margin * max_component(reach_) + rounding_bound(8) * rounded;
        box_ = {box_.low - Vec3{grow, grow, grow}, box_.high + Vec3{grow, grow, grow}};
    }

    const PlacedMesh& placed() const { return *placed_; }
    const TriangleTree& tree() const { return tree_->tree; }
    const Box& box() const { return box_; }  // in the world, grown by a margin

    // The ray in the mesh's coordinates, ready for boxes. Its margin also covers what is rounded on
    // the way: the ray's two maps, the places of the corners, and the 16 epsilon of hit_triangle.
    WideRay<float> wide_ray_in_mesh(const Ray& ray) const {
        const Instance& at = placed_->instance();
        WideRay<float> wide = wide_ray<float>(object_ray(at, ray));
        const Real size = largest_sum(at.world_to_object, abs(ray.origin) + reach_);
        wide.margin += static_cast<float>(slack_ + 64 * epsilon * size);
        return wide;
    }

  private:
    // The largest sum of the absolute values that are added when the map is applied to a point
    // whose coordinates have these absolute values.
    static Real largest_sum(const Mat4& map, Vec3 size) {
        return max_component(transform_point(abs(map), size));
    }

    const PlacedMesh* placed_;
    std::shared_ptr<const MeshTree> tree_;
    Box box_;
    Vec3 reach_;      // the largest coordinates in the box, as absolute values
    Real slack_ = 0;  // how far the matrices take a point off its place, there and back
};

inline Box bounds_of(const MeshInstance& instance) {
    return instance.box();
}

// A ray on its way through the tree of one mesh (given). Numbers are those of the scene.
struct SearchInMesh : WideSearch<TriangleTree> {
    const PlacedMesh& placed;
    TriangleLeaf leaf;  // the last one that was met, at its place

    SearchInMesh(const MeshInstance& instance, const TriangleRay& in_world, Interval where,
                 int nearest_so_far)
        : WideSearch{instance.tree(), in_world, instance.wide_ray_in_mesh(in_world), where,
                     nearest_so_far},
          placed{instance.placed()} {}

    SomeOfLeaf shapes_in(WideChild child) {
        ++shape_tests;
        const TriangleLeaf& from = tree.leaves[static_cast<std::size_t>(child.number())];
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& [x, y, z] = from.corner[k];
            auto& to = leaf.corner[placed.is_mirrored() && k > 0 ? 3 - k : k];
            for (std::size_t i = 0; i < lanes; ++i) {
                const Vec3 point = placed.placed({x[i], y[i], z[i]});
                to[0][i] = point.x;
                to[1][i] = point.y;
                to[2][i] = point.z;
            }
        }
        for (std::size_t i = 0; i < lanes; ++i) leaf.number[i] = placed.first() + from.number[i];
        return {leaf.number, may_meet(leaf, ray, within)};
    }
    std::optional<Real> meets_shape(int number) const {
        return hit_shape(leaf.shape(leaf.place_of(number)), ray, within);
    }
};

// A ray on its way through the tree of all instances (given). `nearest` is the number of a
// triangle.
struct SearchInInstances : SearchOf<MeshInstance, TriangleRay> {
    bool is_any_enough = false;

    // Searches the mesh itself, so that find_nearest has nothing to remember.
    std::optional<Real> meets_shape(int id) {
        SearchInMesh in_mesh{shape(id), ray, within, nearest};
        if (is_any_enough) {
            AnyHit<SearchInMesh> any{std::move(in_mesh)};
            find_nearest(WideChild::node(0), any);
            nearest = any.nearest;
        } else {
            find_nearest(WideChild::node(0), in_mesh);
            within = in_mesh.within;
            nearest = in_mesh.nearest;
        }
        return {};
    }
};

// All instances of a scene (given).
class InstanceTree {
  public:
    InstanceTree() = default;
    explicit InstanceTree(std::vector<MeshInstance> instances)
        : tree_{make_tree(std::move(instances), AreaSplit{})} {}

    bool is_empty() const { return !tree_.root; }

    // The nearest hit; that of the triangle `number` at within.max may already be known.
    SearchInInstances search(const Ray& ray, Interval within, int number) const {
        SearchInInstances search = at_start(ray, within, number);
        run(search);
        return search;
    }
    bool occluded(const Ray& ray, Interval within) const {
        AnyHit<SearchInInstances> search{at_start(ray, within, -1)};
        search.is_any_enough = true;
        run(search);
        return search.found();
    }

  private:
    SearchInInstances at_start(const Ray& ray, Interval within, int number) const {
        return {{tree_.shapes, tree_.order, TriangleRay{ray}, within, number}};
    }
    template <class Search>
    void run(Search& search) const {
        if (tree_.root && search.meets(tree_.root->box)) find_nearest(*tree_.root, search);
    }

    TreeOf<MeshInstance> tree_;
};

}  // namespace rt
