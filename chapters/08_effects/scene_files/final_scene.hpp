#pragma once
#include <rt/scene.hpp>

namespace effects {

// The picture at the end of the course: more than 10,000 spheres of matte, metal and glass, lit by
// the last light of the evening and by lamps, seen through a lens.
rt::SceneDescription final_scene();

}  // namespace effects
