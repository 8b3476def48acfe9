#pragma once
// What the program says about a scene and the renderer that draws it.

#include <algorithm>
#include <rt/counted.hpp>
#include <rt/scene.hpp>
#include <string>

#include "pixel_renderer.hpp"

namespace effects {

// "the final scene, 3 spheres". `file` is empty for the final scene.
inline std::string name_of(const rt::SceneDescription& scene, const std::string& file) {
    return (file.empty() ? "the final scene" : file) + ", " +
           rt::counted(scene.spheres.size(), "sphere");
}

// What --explain prints: the scene by its name, what it needs, and which renderer draws it.
inline std::string explanation(const std::string& name, const rt::Effects& needed,
                               const Choice& choice) {
    return "scene:    " + name + "\nneeds:    " + names(needed) +
           "\nrenderer: " + names(choice.chosen) + ", " + choice.among +
           "\nunused:   " + names(without(choice.chosen, needed)) +
           "\nleft out: " + names(without(rt::every_effect, choice.chosen)) + '\n';
}

// What the user may have overlooked; "" if nothing.
inline std::string note_on(const rt::SceneDescription& scene) {
    const auto moves = [](const rt::SphereDescription& sphere) {
        return sphere.velocity != rt::Vec3{};
    };
    const auto count = std::count_if(scene.spheres.begin(), scene.spheres.end(), moves);
    if (count == 0 || scene.camera.shutter > 0) return "";
    return "note: " + rt::counted(count, "sphere") + (count == 1 ? " has" : " have") +
           " a velocity and no trail, because camera.shutter is 0\n";
}

}  // namespace effects
