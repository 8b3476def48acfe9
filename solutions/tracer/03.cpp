#include <fstream>
#include <iostream>
#include <rt/dot.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/length.hpp>
#include <rt/make_camera.hpp>
#include <rt/nearest_sphere.hpp>
#include <rt/ppm.hpp>
#include <rt/primary_ray.hpp>
#include <rt/shown_hits.hpp>
#include <rt/tracer_call.hpp>

using namespace rt;

int main(int count, char** words) try {
    TracerCall call = read_call(count, words);
    SceneText scene = read_scene(call.scene);
    Camera camera = make_camera(scene.view, scene.width, scene.height);
    Vec3 to_light = normalize(Vec3{-2, 2, 1});
    Image image{scene.width, scene.height};
    for_each_pixel({0, 0, scene.width, scene.height}, [&](int column, int row) {
        Ray ray = primary_ray(camera, column, row, {0.5, 0.5});
        Color color = mix(scene.below, scene.above, (ray.direction.y + 1) / 2);
        if (auto nearest = nearest_sphere(scene.spheres, ray, {0, infinity})) {
            SceneSphere sphere = scene.spheres[nearest->number];
            Vec3 point = ray.at(nearest->t);
            Vec3 normal = normalize(point - sphere.shape.center);
            color = (1 + dot(normal, to_light)) / 2 * scene.materials[sphere.material].color;
            if (nearest_sphere(scene.spheres, {point, to_light}, {0.001, infinity}))
                color = 0.4 * color;
        }
        image.at(column, row) = color;
    });
    if (!call.show.empty()) image = shown_hits(call, scene, camera);
    std::ofstream file{call.picture};
    write_ppm(file, image);
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
