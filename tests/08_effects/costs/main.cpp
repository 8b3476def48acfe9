// costs SCENE WAY ROWS: draws this many rows of a scene in one of several ways, and prints the sum
// of all colors with all digits. costs.sh counts the instructions.
//   SCENE  matte, metal, glass_lens; or an effect's name: matte spheres and that effect
//   WAY    hand     the loop written by hand for this scene (the first three only)
//          narrow   the narrowest renderer
//          full     the renderer with all effects
//          EFFECT   the narrowest renderer that has this effect, too

#include <cstdio>
#include <cstdlib>
#include <rt/choose_renderer.hpp>
#include <rt/renderers.hpp>
#include <string>

#include "by_hand.hpp"

namespace {

using namespace rt;

const by_hand::Picture picture{48, 27, 4, 8, 1};

// 200 small spheres on a large one, and what the name asks for.
SceneDescription make_scene(const std::string& name) {
    SceneDescription scene;
    scene.sky = {{1, 1, 1}, {Real(0.5), Real(0.7), 1}};
    scene.camera.view = {{0, 3, 9}, {0, Real(0.3), 0}, {0, 1, 0}, radians(35)};
    const auto is = [&](const char* effect) { return name == effect; };
    scene.materials = {Lambertian{{Real(0.6), Real(0.5), Real(0.4)}},
                       Lambertian{{Real(0.2), Real(0.5), Real(0.8)}}};
    if (is("metal") || is("mirror")) scene.materials.push_back(Metal{{1, Real(0.8), 1}, 0});
    if (is("metal") || is("fuzz")) scene.materials.push_back(Metal{{1, 1, 1}, Real(0.3)});
    if (is("glass_lens") || is("glass")) scene.materials.push_back(Dielectric{});
    if (is("texture")) scene.materials.push_back(CheckeredMatte{{0, 0, 0}, {1, 1, 1}, Real(0.1)});
    if (is("lights")) scene.materials.push_back(Emitter{{2, 2, 2}});
    if (is("glass_lens") || is("lens")) scene.camera.lens = {Real(0.2), 9};
    if (is("motion")) scene.camera.shutter = 1;
    if (is("fog")) scene.fog = Fog{{{0, 0, 0}, 20}, Real(0.02)};
    if (is("haze")) scene.haze = Haze{Real(0.05), {Real(0.75), Real(0.85), 1}};
    scene.spheres.push_back({{{0, -1000, 0}, 1000}, 0});
    Rng random{1, 8};
    for (int i = 0; i < 200; ++i) {
        const Real radius = Real(0.1) + Real(0.3) * random.uniform();
        const Vec3 center{random.uniform(-6, 6), radius, random.uniform(-8, 5)};
        const auto kinds = static_cast<int>(scene.materials.size()) - 1;
        SphereDescription sphere{{center, radius}, 1 + i % kinds};
        // As few lights and moving spheres as a scene may have.
        if (is("lights") && sphere.material == 2 && i > 20) sphere.material = 1;
        if (is("motion") && i < 20) sphere.velocity = {0, radius, 0};
        scene.spheres.push_back(sphere);
    }
    return scene;
}

template <class Shade>
Color sum_of(int rows, const Shade& shade) {
    Color sum;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < picture.width; ++x) sum += shade(x, y);
    return sum;
}

const Quality quality{picture.samples, picture.depth, picture.seed};

// Not through renderer_makers: those count rays, which none of the other ways does here.
template <std::size_t... number>
Color draw(std::size_t chosen, const SceneDescription& scene, int rows,
           std::index_sequence<number...>) {
    Color sum;
    const auto draw_with = [&]<std::size_t i>() {
        const Renderer<renderer_effects[i]> renderer{scene, picture.width, picture.height, quality};
        sum = sum_of(rows, [&](int x, int y) { return renderer(x, y); });
    };
    ((chosen == number ? draw_with.template operator()<number>() : void()), ...);
    return sum;
}

Color draw(const std::string& name, const std::string& way, int rows) {
    const SceneDescription scene = make_scene(name);
    if (way == "hand") {
        if (name == "matte") return sum_of(rows, by_hand::Matte{scene, picture});
        if (name == "metal") return sum_of(rows, by_hand::MatteAndMetal{scene, picture});
        if (name == "glass_lens") return sum_of(rows, by_hand::GlassAndLens{scene, picture});
    }
    Effects needed = needed_effects(scene);
    if (way == "full") needed = every_effect;
    for (const NamedEffect& effect : all_effects)
        if (way == effect.name) needed.*effect.member = true;
    return draw(narrowest(needed, renderer_effects), scene, rows,
                std::make_index_sequence<renderer_effects.size()>{});
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return 2;
    const Color sum = draw(argv[1], argv[2], std::min(std::atoi(argv[3]), picture.height));
    std::printf("%.17g %.17g %.17g\n", double(sum.r), double(sum.g), double(sum.b));
}
