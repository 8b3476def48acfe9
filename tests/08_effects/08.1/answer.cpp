#include <answer.hpp>
#include <rt/effects_of.hpp>

namespace answer EXPORTED {

rt::Effects effects_of(const rt::SceneDescription& scene) {
    return rt::effects_of(scene);
}

}  // namespace EXPORTED
