// The part of chapter 08's program that draws scenes with meshes if --sampler, --filter,
// --target-error or --time-budget is given. This file is linked into that program.

#include <memory>
#include <rt/draw_passes.hpp>
#include <rt/mesh_scene.hpp>
#include <rt/tent_filter.hpp>

#include "../../11_samples/for_08/sampled_meshes.hpp"

namespace {
using MeshRenderer = rt::Renderer<rt::every_effect, rt::MeshScene<rt::every_effect>>;
}

rt::DrawPass effects::make_meshed_passes(const rt::SceneDescription& scene, int width, int height,
                                         const rt::Quality& quality, bool sobol) {
    return rt::kept_passes(std::make_shared<const MeshRenderer>(scene, width, height, quality),
                           quality.samples_per_pixel, sobol);
}

effects::DrawTile effects::make_meshed_tent(const rt::SceneDescription& scene, int width,
                                            int height, const rt::Quality& quality) {
    return rt::kept_tent(std::make_shared<const MeshRenderer>(scene, width, height, quality),
                         quality.samples_per_pixel);
}
