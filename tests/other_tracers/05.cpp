// Graft 05, written in another way: the spheres in the reverse order, each with a material of its
// own.

#include <algorithm>
#include <fstream>
#include <iostream>
#include <rt/dielectric.hpp>
#include <rt/lambertian.hpp>
#include <rt/make_camera.hpp>
#include <rt/material_set.hpp>
#include <rt/metal.hpp>
#include <rt/ppm.hpp>
#include <rt/render_pixel.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>
#include <rt/tracer_call.hpp>
#include <variant>

using Surface = std::variant<rt::Metal, rt::Dielectric, rt::Lambertian>;

Surface surface(const rt::TextMaterial& text) {
    switch (text.kind) {
        case rt::TextMaterial::metal:
            return rt::Metal{text.color, text.fuzz};
        case rt::TextMaterial::glass:
            return rt::Dielectric{text.index};
        default:
            return rt::Lambertian{text.color};
    }
}

int main(int number, char** arguments) {
    const auto call = rt::read_call(number, arguments);
    const auto given = rt::read_scene(call.scene);
    rt::MaterialSet<rt::Metal, rt::Dielectric, rt::Lambertian> surfaces;
    rt::SphereList balls;
    for (auto ball = given.spheres.rbegin(); ball != given.spheres.rend(); ++ball) {
        balls.spheres.push_back({ball->shape, int(surfaces.materials.size())});
        surfaces.materials.push_back(surface(given.materials[ball->material]));
    }
    rt::Quality work;
    work.seed = call.seed;
    work.depth = 1 + given.depth;
    work.samples_per_pixel = given.samples;
    const rt::GradientSky above_all{given.below, given.above};
    const auto eye = rt::make_camera(given.view, given.width, given.height);
    rt::Image drawn{given.width, given.height};
    for (int x = 0; x < given.width; ++x)
        for (int y = 0; y < given.height; ++y)
            drawn.at(x, y) =
                rt::render_pixel(eye, balls, surfaces, above_all, rt::BlackEnding{}, work, x, y);
    std::ofstream out{call.picture};
    rt::write_ppm(out, drawn);
}
