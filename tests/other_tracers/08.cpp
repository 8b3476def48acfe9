// Graft 08, written in another way: a struct that holds the picture, threads that take rows, and a
// lens that is set number by number.

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iostream>
#include <rt/area_split.hpp>
#include <rt/cameras.hpp>
#include <rt/dielectric.hpp>
#include <rt/lambertian.hpp>
#include <rt/make_camera.hpp>
#include <rt/material_set.hpp>
#include <rt/metal.hpp>
#include <rt/ppm.hpp>
#include <rt/render_pixel.hpp>
#include <rt/shape_tree.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>
#include <rt/tracer_call.hpp>
#include <thread>

using namespace rt;

struct Drawing {
    TracerCall call;
    SceneText given;
    LensCamera eye;
    MaterialSet<Dielectric, Lambertian, Metal> surfaces;
    Image drawn;

    template <class Balls>
    void draw(const Balls& balls) {
        std::atomic<int> next{0};
        const auto take_rows = [&] {
            for (int y = next++; y < given.height; y = next++)
                for (int x = given.width; x-- > 0;)
                    drawn.at(x, y) = render_pixel(
                        eye, balls, surfaces, GradientSky{given.below, given.above}, BlackEnding{},
                        {given.samples, given.depth + 1, static_cast<std::uint64_t>(call.seed)}, x,
                        y);
        };
        std::vector<std::thread> threads;
        for (int i = 0; i < call.threads; ++i) threads.emplace_back(take_rows);
        for (std::thread& thread : threads) thread.join();
    }
};

int main(int number, char** arguments) {
    Drawing drawing;
    drawing.call = read_call(number, arguments);
    drawing.given = read_scene(drawing.call.scene);
    const SceneText& given = drawing.given;
    drawing.drawn = Image{given.width, given.height};
    drawing.eye.camera = make_camera(given.view, given.width, given.height);
    drawing.eye.lens.focus_distance = given.focus;
    drawing.eye.lens.aperture = given.aperture;
    for (const TextMaterial& text : given.materials) {
        auto& all = drawing.surfaces.materials;
        if (text.kind == TextMaterial::glass) all.emplace_back(Dielectric{text.index});
        if (text.kind == TextMaterial::metal) all.emplace_back(Metal{text.color, text.fuzz});
        if (text.kind == TextMaterial::matte) all.emplace_back(Lambertian{text.color});
    }
    if (!drawing.call.list)
        drawing.draw(make_tree(given.spheres, AreaSplit{4}));
    else
        drawing.draw(SphereList{given.spheres});
    std::ofstream out{drawing.call.picture};
    write_ppm(out, drawing.drawn);
}
