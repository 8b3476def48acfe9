#pragma once
// The cover as a scene of chapter 08. Only programs of that chapter and later ones may include this
// file: the libraries in common/ know no scenes.

#include <rt/scene.hpp>
#include <study/cover.hpp>

namespace study {

inline rt::SceneDescription cover_scene(const Cover& cover) {
    rt::SceneDescription scene;
    scene.camera.view = cover.view;
    scene.sky = {cover.horizon, cover.above};
    for (const CoverSphere& sphere : cover.spheres) {
        const auto number = static_cast<int>(scene.spheres.size());
        scene.spheres.push_back({{sphere.center, sphere.radius}, number, {}});
        switch (sphere.material) {
            case CoverMaterial::matte:
                scene.materials.push_back(rt::Lambertian{sphere.color});
                break;
            case CoverMaterial::metal:
                scene.materials.push_back(rt::Metal{sphere.color, sphere.fuzz});
                break;
            case CoverMaterial::glass:
                scene.materials.push_back(rt::Dielectric{cover_glass_index});
                break;
        }
    }
    return scene;
}

}  // namespace study
