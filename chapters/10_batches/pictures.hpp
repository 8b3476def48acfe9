#pragma once
// The study's small picture of the chapter's scene, drawn path by path and in batches.

#include <rt/batch_renderer.hpp>
#include <rt/canvas.hpp>
#include <rt/renderer.hpp>

#include "scene.hpp"

namespace batches {

constexpr int study_width = 160, study_height = 90;
constexpr Quality study_quality{4, 16, 1};

// A scene, made ready for both ways of drawing it.
struct StudyScene {
    SceneDescription description;
    ReadyScene<scene_effects> ready;
    Renderer<scene_effects> renderer;

    explicit StudyScene(int spheres)
        : description{make_scene(spheres, scene_view())},
          ready{description, study_width, study_height},
          renderer{description, study_width, study_height, study_quality} {}
};

// draw_singly() and draw_in_batches() draw the picture and return the number of rays.
inline std::uint64_t draw_singly(const StudyScene& scene, Image& image) {
    std::uint64_t rays = 0;
    for (int y = 0; y < study_height; ++y)
        for (int x = 0; x < study_width; ++x) image.at(x, y) = scene.renderer(x, y, rays);
    return rays;
}
inline std::uint64_t draw_in_batches(BatchRenderer<scene_effects>& renderer, Image& image) {
    std::uint64_t rays = 0;
    renderer.draw({0, 0, study_width, study_height}, image, rays);
    return rays;
}

}  // namespace batches
