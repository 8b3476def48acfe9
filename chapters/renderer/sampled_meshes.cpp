#include "sampled_meshes.hpp"

#include <rt/renderer.hpp>

namespace full_renderer {
namespace {

using namespace rt;

auto meshed_renderer(const MeshedDescription& scene, int width, int height,
                     const Quality& quality) {
    return std::make_shared<const Renderer<every_effect, MeshScene<every_effect>>>(
        scene, width, height, quality, meshes_of(scene));
}

}  // namespace

DrawPass make_meshed_passes(const MeshedDescription& scene, int width, int height,
                            const Quality& quality, bool sobol) {
    return kept_passes(meshed_renderer(scene, width, height, quality), quality.samples_per_pixel,
                       sobol);
}

DrawTile make_meshed_tent(const MeshedDescription& scene, int width, int height,
                          const Quality& quality) {
    return kept_tent(meshed_renderer(scene, width, height, quality), quality);
}

}  // namespace full_renderer
