#pragma once
// The spheres in false colors: how far away they are, and which is which.

#include <rt/make_camera.hpp>
#include <rt/nearest_sphere.hpp>
#include <rt/primary_ray.hpp>
#include <rt/show.hpp>

#include "scene.hpp"

namespace scene {

inline app::Picture show(const app::Settings& settings, app::Progress& progress,
                         const std::vector<SceneSphere>& spheres) {
    const auto camera = rt::make_camera(*settings.view, settings.width, settings.height);
    return app::show(settings, progress, [&](int x, int y) -> rt::Shown {
        const auto ray = rt::primary_ray(camera, x, y, {Real(0.5), Real(0.5)});
        const auto nearest = rt::nearest_sphere(spheres, ray, {0, rt::infinity});
        if (!nearest) return {};
        if (settings.show == "sphere") return static_cast<int>(nearest->number);
        // So far away that all else would look equally near.
        if (nearest->number == sky_number) return {};
        return nearest->t;
    });
}

}  // namespace scene
