#pragma once
// What the program says about a scene and the renderer that draws it.

#include <algorithm>
#include <rt/counted.hpp>
#include <rt/needed_effects.hpp>
#include <string>

#include "tile_renderer.hpp"

namespace effects {

inline std::string explanation(const rt::SceneDescription& scene, const std::string& file,
                               const Choice& choice) {
    const rt::Effects needed = rt::needed_effects(scene);
    std::size_t triangles = 0;
    for (const rt::MeshDescription& mesh : scene.meshes) triangles += mesh.mesh->triangles.size();
    return "scene:    " + (file.empty() ? "the final scene" : file) + ", " +
           rt::counted(scene.spheres.size(), "sphere") +
           (triangles > 0 ? ", " + rt::counted(triangles, "triangle") : "") +
           "\nneeds:    " + names(needed) + "\nrenderer: " + names(choice.chosen) + ", " +
           (choice.in_batches ? "in batches" : "one of " + std::to_string(choice.renderers)) +
           "\nunused:   " + names(without(choice.chosen, needed)) +
           "\nleft out: " + names(choice.left_out) + '\n';
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
