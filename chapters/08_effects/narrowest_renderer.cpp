// All renderers are compiled here, once, because that takes long.

#include "narrowest_renderer.hpp"

#include <rt/choose_renderer.hpp>
#include <rt/renderers.hpp>

namespace effects {

using namespace rt;

Shader make_narrowest(const Effects& needed, const SceneDescription& scene, int width, int height,
                      const Quality& quality) {
    return renderer_makers[narrowest(needed, renderer_effects)](scene, width, height, quality);
}

Choice choose(const Effects& needed) {
    const Effects chosen = renderer_effects[narrowest(needed, renderer_effects)];
    return {chosen, without(with_all, chosen), renderer_effects.size()};
}

}  // namespace effects
