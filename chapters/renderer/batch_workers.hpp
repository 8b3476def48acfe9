#pragma once
#include <memory>
#include <rt/batch_renderer.hpp>
#include <rt/mesh_scene.hpp>

#include "lit_meshes.hpp"

namespace full_renderer {

inline bool can_be_batched(const rt::MeshedDescription& scene) {
    return scene.meshes.empty() && !has_sky_or_rough(scene) && rt::can_be_batched(scene);
}

// Returns a function that makes workers, which draw tiles of a scene in batches. Each worker has a
// renderer of its own, and calls draw(renderer, arguments...).
template <class Points, class Draw>
auto batch_workers(const rt::SceneDescription& description, int width, int height,
                   const rt::Quality& quality, const Draw& draw) {
    using namespace rt;
    const auto scene =
        std::make_shared<const ReadyScene<batch_effects>>(description, width, height);
    return [scene, quality, draw] {
        return [scene, draw,
                renderer = std::make_shared<BatchRenderer<batch_effects, Points>>(*scene, quality)](
                   auto&&... arguments) { return draw(*renderer, arguments...); };
    };
}

}  // namespace full_renderer
