#pragma once
#include <map>
#include <memory>
#include <rt/aggregate.hpp>
#include <rt/compiler.hpp>
#include <rt/mesh_instances.hpp>
#include <rt/placed_mesh.hpp>
#include <rt/triangle_leaf.hpp>
#include <rt/triangle_shape.hpp>
#include <rt/wide_builder.hpp>
#include <utility>
#include <vector>

namespace rt {

// The triangles of a scene (given): the copies in a tree of the world's coordinates, and beside it
// the instances, each with the tree of its mesh.
class MeshWorld {
  public:
    explicit MeshWorld(std::shared_ptr<const SceneMeshes> meshes) : meshes_{std::move(meshes)} {
        std::map<const Mesh*, std::shared_ptr<const MeshTree>> trees;
        std::vector<SceneTriangle> copies;
        std::vector<MeshInstance> instances;
        for (const PlacedMesh& placed : meshes_->placed()) {
            if (placed.is_copy()) {
                add_copies(placed, copies);
            } else {
                auto& tree = trees[&placed.mesh()];
                if (!tree) tree = std::make_shared<const MeshTree>(placed.mesh());
                instances.emplace_back(placed, tree);
            }
        }
        copies_ = make_wide_tree(copies, threads_to_build());
        instances_ = InstanceTree{std::move(instances)};
    }

    // Compiled once: as a part of all its callers, it would make a renderer take four times as long
    // to compile, and no faster.
    template <class AnyRay>
    RT_NOT_INLINED RT_INLINES_ALL std::optional<Hit> hit(const AnyRay& any_ray,
                                                         Interval within) const {
        const Ray& ray = any_ray;  // no copy if any_ray is a plain Ray
        const auto in_copies = copies_.search(ray, within);
        const bool is_copy = in_copies.nearest >= 0;
        if (!instances_.is_empty()) {
            const int number = is_copy ? number_of_copy(in_copies.nearest) : -1;
            const auto in_all = instances_.search(ray, in_copies.within, number);
            if (in_all.nearest != number)
                return surface_hit(meshes_->mesh_of(in_all.nearest).triangle(in_all.nearest), ray,
                                   in_all.within.max);
        }
        if (!is_copy) return {};
        SceneTriangle copy = copies_.shape(in_copies.nearest);
        copy.number = number_of_copy(copy.number);
        return surface_hit(copy, ray, in_copies.within.max);
    }

    // True if anything is hit within the interval.
    template <class AnyRay>
    RT_NOT_INLINED RT_INLINES_ALL bool occluded(const AnyRay& ray, Interval within) const {
        return copies_.occluded(ray, within) || instances_.occluded(ray, within);
    }

  private:
    void add_copies(const PlacedMesh& placed, std::vector<SceneTriangle>& copies) {
        copied_.push_back({static_cast<int>(copies.size()), placed.first()});
        std::vector<SceneTriangle> added = placed.triangles();
        if (copies.empty())
            copies = std::move(added);
        else
            copies.insert(copies.end(), added.begin(), added.end());
    }
    // The number in the scene of a triangle that is a copy: copies are counted among themselves.
    int number_of_copy(int copy) const {
        const auto after = std::upper_bound(copied_.begin(), copied_.end(), copy,
                                            [](int n, const Copied& of) { return n < of.copy; });
        return copy - (after - 1)->copy + (after - 1)->number;
    }
    struct Copied {
        int copy, number;  // of a mesh's first triangle
    };

    std::shared_ptr<const SceneMeshes> meshes_;
    TriangleTree copies_;
    std::vector<Copied> copied_;
    InstanceTree instances_;
};

}  // namespace rt
