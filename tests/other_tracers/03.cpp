// Graft 03, written in another way: loops and a camera by hand, and a function for the color.

#include <fstream>
#include <iostream>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/look_at.hpp>
#include <rt/nearest_sphere.hpp>
#include <rt/ppm.hpp>
#include <rt/primary_ray.hpp>
#include <rt/tracer_call.hpp>
#include <rt/viewport.hpp>

const rt::Vec3 sun = rt::normalize(rt::Vec3{-2, 2, 1});

rt::Color light(const rt::SceneText& given, const rt::Ray& seen) {
    const auto found = rt::nearest_sphere(given.spheres, seen, {0.001, rt::infinity});
    if (!found) {
        const double height = 0.5 + 0.5 * seen.direction.y;
        return (1 - height) * given.below + height * given.above;
    }
    const rt::SceneSphere& ball = given.spheres[found->number];
    const rt::Vec3 place = seen.origin + found->t * seen.direction;
    const rt::Vec3 outward = (1 / ball.shape.radius) * (place - ball.shape.center);
    const double share = 0.5 + 0.5 * rt::dot(outward, sun);
    const bool dark =
        rt::nearest_sphere(given.spheres, {place, sun}, {0.001, rt::infinity}).has_value();
    return share * (dark ? 0.4 : 1.0) * given.materials[ball.material].color;
}

int main(int number, char** arguments) {
    const auto call = rt::read_call(number, arguments);
    const auto given = rt::read_scene(call.scene);
    rt::Camera eye;
    eye.eye = given.view.from;
    eye.basis = rt::look_at(given.view.from, given.view.at, given.view.up);
    eye.viewport = rt::viewport_size(given.view.vertical_fov, double(given.width) / given.height);
    eye.width = given.width;
    eye.height = given.height;
    rt::Image drawn{given.width, given.height};
    for (int x = 0; x < given.width; ++x)
        for (int y = 0; y < given.height; ++y)
            drawn.at(x, y) = light(given, rt::primary_ray(eye, x, y, {0.5, 0.5}));
    std::ofstream out{call.picture};
    rt::write_ppm(out, drawn);
}
