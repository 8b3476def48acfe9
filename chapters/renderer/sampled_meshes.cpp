#include "sampled_meshes.hpp"

#include <rt/lit_mesh_scene.hpp>
#include <rt/renderer.hpp>
#include <rt/sky_scene.hpp>

#include "lit_meshes.hpp"

namespace full_renderer {
namespace {

using namespace rt;

// Calls use() with a renderer of this scene, and returns the result.
template <class Use>
auto with_renderer(const MeshedDescription& scene, int width, int height, const Quality& quality,
                   const Use& use) {
    const auto with = [&]<class Scene>(Scene*) {
        return use(std::make_shared<const Renderer<every_effect, Scene>>(
            scene, width, height, quality, meshes_of(scene)));
    };
    if (has_sky_or_rough(scene)) return with(static_cast<SkyScene<every_effect>*>(nullptr));
    if (has_lamp_meshes(scene)) return with(static_cast<LitMeshScene<every_effect>*>(nullptr));
    return with(static_cast<MeshScene<every_effect>*>(nullptr));
}

}  // namespace

DrawPass make_meshed_passes(const MeshedDescription& scene, int width, int height,
                            const Quality& quality, bool sobol) {
    return with_renderer(scene, width, height, quality, [&](auto renderer) -> DrawPass {
        return kept_passes(renderer, quality.samples_per_pixel, sobol);
    });
}

DrawTile make_meshed_tent(const MeshedDescription& scene, int width, int height,
                          const Quality& quality) {
    return with_renderer(scene, width, height, quality,
                         [&](auto renderer) -> DrawTile { return kept_tent(renderer, quality); });
}

}  // namespace full_renderer
