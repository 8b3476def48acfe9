#include "final_scene.hpp"

namespace effects {

rt::SceneDescription final_scene() {
    return {};
}

}  // namespace effects
