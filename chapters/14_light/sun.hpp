#pragma once
// Three balls on a plain, under a small picture of the sky with a sun of one pixel.

#include <rt/sky_scene.hpp>

namespace light {

using namespace rt;

inline View sun_view() {
    View view;
    view.from = {0, Real(1.6), 9};
    view.at = {0, Real(0.75), 0};
    view.vertical_fov = radians(28);
    return view;
}

// A blue sky that is paler near the horizon, over brown ground. The sun stands on the left, behind
// the camera, and is as bright as 100,000 pixels around it.
inline Image sun_picture() {
    constexpr int width = 256, height = 128;
    Image picture = make_image(width, height, [](int, int y) {
        if (y >= height / 2) return Color{Real(0.05), Real(0.04), Real(0.03)};
        const Real up = 1 - static_cast<Real>(y) / (height / 2);
        return rt::mix(Color{Real(0.42), Real(0.5), Real(0.6)},
                       Color{Real(0.06), Real(0.13), Real(0.32)}, up);
    });
    picture.at(30, 44) = {5000, 4200, 3000};
    return picture;
}

inline SceneDescription make_sun(const View& view) {
    SceneDescription scene;
    scene.camera = {view, {}, 0};
    scene.images = {sun_picture()};
    scene.sky_image = SkyImage{};
    scene.materials = {Lambertian{from_hex(0xb8a88c)}, Lambertian{from_hex(0xd04a35)},
                       Lambertian{from_hex(0xe8e4da)}, Lambertian{from_hex(0x3f7d6e)}};
    scene.spheres = {{{{0, -10'000, 0}, 10'000}, 0},
                     {{{Real(-2.2), Real(0.8), 0}, Real(0.8)}, 1},
                     {{{0, 1, Real(-0.4)}, 1}, 2},
                     {{{Real(2.1), Real(0.7), Real(0.3)}, Real(0.7)}, 3}};
    return scene;
}

}  // namespace light
