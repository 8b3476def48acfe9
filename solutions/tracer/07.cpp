#include <fstream>
#include <iostream>
#include <rt/area_split.hpp>
#include <rt/dielectric.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/lambertian.hpp>
#include <rt/make_camera.hpp>
#include <rt/material_set.hpp>
#include <rt/metal.hpp>
#include <rt/ppm.hpp>
#include <rt/render_pixel.hpp>
#include <rt/render_tiles.hpp>
#include <rt/shape_tree.hpp>
#include <rt/shown_image.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>
#include <rt/tracer_call.hpp>

using namespace rt;

int main(int count, char** words) try {
    TracerCall call = read_call(count, words);
    SceneText scene = read_scene(call.scene);
    Camera camera = make_camera(scene.view, scene.width, scene.height);
    MaterialSet<Lambertian, Metal, Dielectric> materials;
    for (TextMaterial material : scene.materials) {
        if (material.kind == TextMaterial::matte)
            materials.materials.push_back(Lambertian{material.color});
        if (material.kind == TextMaterial::metal)
            materials.materials.push_back(Metal{material.color, material.fuzz});
        if (material.kind == TextMaterial::glass)
            materials.materials.push_back(Dielectric{material.index});
    }
    GradientSky sky{scene.below, scene.above};
    // A path that has bounced `depth` times may still see the sky: that takes one ray more.
    Quality quality{scene.samples, scene.depth + 1, std::uint64_t(call.seed)};
    Image image{scene.width, scene.height};
    TileGrid grid{scene.width, scene.height};
    auto draw = [&](const auto& world) {
        if (!call.show.empty())
            image = shown_image(call, scene, camera, world, materials, sky, quality);
        else
            render_tiles(grid, call.threads, [&](const Tile& tile, int) {
                for_each_pixel(tile, [&](int column, int row) {
                    image.at(column, row) = render_pixel(camera, world, materials, sky,
                                                         BlackEnding{}, quality, column, row);
                });
            });
    };
    if (call.list)
        draw(SphereList{scene.spheres});
    else
        draw(make_tree(scene.spheres, AreaSplit{4}));
    std::ofstream file{call.picture};
    write_ppm(file, image);
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
