#pragma once
#include <memory>
#include <rt/batch_renderer.hpp>

namespace rt {

// Returns a function that makes workers, which draw tiles of a scene in batches. Each worker has a
// renderer of its own, and calls draw(renderer, tile, pass, image, rays), where `pass` is a seed or
// a Pass.
template <class Points, class Draw>
auto batch_workers(const SceneDescription& description, int width, int height,
                   const Quality& quality, const Draw& draw) {
    const auto scene =
        std::make_shared<const ReadyScene<batch_effects>>(description, width, height);
    return [scene, quality, draw] {
        return [scene, draw,
                renderer = std::make_shared<BatchRenderer<batch_effects, Points>>(*scene, quality)](
                   const Tile& tile, const auto& pass, Image& image, std::uint64_t& rays) {
            return draw(*renderer, tile, pass, image, rays);
        };
    };
}

}  // namespace rt
