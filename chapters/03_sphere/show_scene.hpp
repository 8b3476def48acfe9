#pragma once
// The spheres in false colors: how far away they are, which is which, and their normals.

#include <rt/make_camera.hpp>
#include <rt/show.hpp>
#include <rt/shown_hits.hpp>

#include "scene.hpp"

namespace scene {

inline app::Picture show(const app::Settings& settings, app::Progress& progress,
                         std::span<const SceneSphere> spheres) {
    const auto camera = rt::make_camera(*settings.view, settings.width, settings.height);
    // The sky's sphere is left out, except for the word "sphere". It is so far away that, compared
    // with it, everything else would look equally near.
    if (settings.show != "sphere") spheres = spheres.subspan(sky_number + 1);
    return app::show(settings, progress, [&](int x, int y) {
        return rt::shown_hit(settings.show, spheres,
                             rt::primary_ray(camera, x, y, {Real(0.5), Real(0.5)}));
    });
}

}  // namespace scene
