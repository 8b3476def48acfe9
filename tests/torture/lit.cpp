// Lamps, fog, motion, a lens and stretched spheres, where they are hard.

#include <rt/directions.hpp>
#include <rt/rng.hpp>
#include <rt/transform.hpp>

#include "torture.hpp"

using namespace torture;

namespace {

const Lambertian matte{{Real(0.8), Real(0.5), Real(0.3)}};
const Metal mirror{{Real(0.9), Real(0.8), Real(0.7)}, 0}, rough{{1, Real(0.9), 1}, Real(0.4)};
const Dielectric glass{Real(1.5)};
const CheckeredMatte checker{{Real(0.1), Real(0.1), Real(0.2)}, {1, 1, Real(0.9)}, Real(0.3)};

// Balls of all materials on a ground, without lamps.
SceneDescription balls() {
    SceneDescription scene;
    scene.camera.view = {{0, 1, 5}, {0, Real(0.5), 0}, {0, 1, 0}, radians(50)};
    scene.sky = plain_sky;
    add(scene, {0, -1000, 0}, 1000, checker);
    add(scene, {-2, 1, 0}, 1, mirror);
    add(scene, {0, 1, 0}, 1, glass);
    add(scene, {2, 1, 0}, 1, rough);
    add(scene, {0, Real(0.25), 2}, Real(0.25), matte);
    return scene;
}

void add_map(SceneDescription& scene, const Mat4& map, const MaterialDescription& material) {
    add(scene, {map(0, 3), map(1, 3), map(2, 3)}, 1, material);
    scene.spheres.back().map = static_cast<int>(scene.maps.size());
    scene.maps.push_back(map);
}

// Lamps that touch the ground, go into a ball, stand in glass, surround all, are larger than the
// ground and smaller than a pixel.
SceneDescription lamps() {
    SceneDescription scene = balls();
    const Emitter lamp{{2, 3, 4}};
    add(scene, {Real(-0.75), Real(0.125), 2}, Real(0.125), lamp);
    add(scene, {2, 2, 0}, Real(0.25), lamp);
    add(scene, {0, 1, 0}, Real(0.25), lamp);
    add(scene, {Real(0.5), Real(0.001), 3}, Real(0.001), lamp);
    add(scene, {0, 0, Real(-1e6)}, Real(9e5), lamp);
    add(scene, {0, 0, 0}, Real(1e7), lamp);
    return scene;
}

}  // namespace

TEST_CASE("fog and motion and a lens and stretched spheres") {
    SceneDescription scene = balls();
    scene.camera.lens = {Real(0.5), 5};
    scene.camera.shutter = 1;
    scene.spheres[4].velocity = {4, 2, Real(-3)};  // through all others
    scene.spheres[1].velocity = {Real(1e-9), 0, 0};
    add(scene, {0, 2, -2}, 1, OwnMaterial{{Real(0.5), Real(0.7), 1}, 1});
    // A needle, a disk of a thousandth's thickness on the ground, and one that is nearly flat.
    add_map(scene, multiply(rotation_z(1), scaling({Real(0.01), 5, Real(0.01)})), mirror);
    add_map(scene, multiply(translation({1, Real(0.001), 2}), scaling({1, Real(0.001), 1})), glass);
    add_map(scene,
            multiply(translation({-1, 1, 2}),
                     multiply(rotation_x(Real(0.3)), scaling({1, 1, Real(1e-5)}))),
            matte);
    for (const Real asymmetry : {Real(-0.99), Real(0), Real(0.99)})
        // Thin fog around all, and fog in which nearly every step ends at a droplet.
        for (const Fog& fog : {Fog{{{0, 0, 0}, 1000}, Real(1e-3), {1, Real(0.9), 1}, asymmetry},
                               Fog{{{0, 1, 3}, 2}, 50, {1, Real(0.9), 1}, asymmetry}}) {
            INFO("fog of density " << checkpoint::text(fog.density) << " and asymmetry "
                                   << checkpoint::text(asymmetry));
            scene.fog = fog;
            check_scene(scene, {12, 8, 2, 60});
        }
}

TEST_CASE("lamps that touch and lamps within and lamps around everything") {
    SceneDescription scene = lamps();
    draw_in_every_way(scene, {24, 16, 4, 30});
    scene.fog = Fog{{{0, 0, 0}, 20}, Real(0.2), {1, 1, 1}, Real(0.9)};
    draw_in_every_way(scene, {24, 16, 4, 30});
    // The eye in a lamp, on its surface, and in glass with a lamp in it.
    for (const Vec3 from :
         {Vec3{2, 2, 0}, Vec3{2, Real(2.25), 0}, Vec3{0, Real(1.5), 0}, Vec3{0, 1, Real(0.25)}}) {
        scene.camera.view.from = from;
        draw_in_every_way(scene, {12, 8, 2, 30});
    }
}

TEST_CASE("all effects times a billion or a billionth are the same picture") {
    SceneDescription scene = lamps();
    scene.camera.lens = {Real(0.25), 5};
    scene.camera.shutter = 1;
    scene.spheres[4].velocity = {1, 1, -1};
    add_map(scene,
            multiply(translation({-1, 1, 2}), multiply(rotation_z(1), scaling({1, Real(0.1), 1}))),
            glass);
    add_map(scene, multiply(translation({1, Real(0.5), 2}), scaling({Real(0.5), Real(0.25), 1})),
            rough);
    scene.fog = Fog{{{0, 0, 0}, 20}, Real(0.05), {1, 1, 1}, Real(0.5)};
    const Frame frame{12, 8, 2, 30};
    const Image usual = draw_in_every_way(scene, frame);
    for (const int power : {-30, 30}) {
        INFO("times 2^" << power << ", where no multiplication is rounded: the same bytes");
        CHECK(draw_in_every_way(scaled(scene, std::ldexp(Real(1), power)), frame) == usual);
    }
}

TEST_CASE("lamps as bright as the sky cannot be seen in a white furnace") {
    // Every pixel's expectation is 1. A picture's mean is tested to 3.89 standard errors, which
    // right code misses in one of 10,000 seeds, and each pixel's to 5.1. With one of 10,000 seeds,
    // right code misses that in some of the 24 pixels and 6 pictures.
    const Frame frame{6, 4, 400, 60};
    for (const bool foggy : {false, true})
        for (const Vec3 from : {Vec3{0, 1, 5}, Vec3{0, Real(1.5), 0}, Vec3{2, Real(2.25), 0}}) {
            SceneDescription scene = whitened(lamps());
            scene.camera.view.from = from;
            if (foggy) scene.fog = Fog{{{0, 0, 0}, 20}, Real(0.2), {1, 1, 1}, Real(0.9)};
            INFO((foggy ? "in fog" : "without fog") << ", eye at " << checkpoint::text(from));
            const auto pixels = pixel_means(scene, frame);
            double sum = 0, variance = 0;
            for (const checkpoint::Mean& pixel : pixels) {
                // Pixels in which every sample is the same are off by rounding alone.
                const double rounding = 100 * static_cast<double>(epsilon);
                CHECK(std::abs(pixel.mean() - 1) <= 5.1 * pixel.standard_error() + rounding);
                sum += pixel.mean();
                variance += pixel.standard_error() * pixel.standard_error();
            }
            const auto count = static_cast<double>(pixels.size());
            INFO("mean " << sum / count << ", standard error " << std::sqrt(variance) / count);
            CHECK(std::abs(sum - count) <= 3.89 * std::sqrt(variance));
        }
}

TEST_CASE("a lamp behind a wall lights nothing") {
    // The eye is in a matte ball under a black sky; every lamp is outside.
    SceneDescription scene = lamps();
    scene.sky = {};
    scene.spheres.erase(scene.spheres.begin() + 1, scene.spheres.begin() + 5);
    add(scene, {0, 1, 3}, Real(0.75), matte);
    add(scene, {0, 1, Real(2.75)}, Real(0.25), glass);
    scene.camera.view.from = {Real(0.125), 1, Real(3.25)};
    scene.fog = Fog{{{0, 0, 0}, 20}, Real(0.5), {1, 1, 1}, Real(0.5)};
    const Frame frame{12, 8, 4, 200};
    CHECK(draw_in_every_way(scene, frame) == Image{frame.width, frame.height});
}
