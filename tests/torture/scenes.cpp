// Scenes that are hard by their geometry, without lamps: no path may be brighter than the sky.

#include <rt/directions.hpp>
#include <rt/leave_surface.hpp>
#include <rt/prepare.hpp>
#include <rt/rng.hpp>
#include <rt/surface_hit.hpp>
#include <rt/uniform_direction.hpp>
#include <rt/wide_builder.hpp>

#include "torture.hpp"

using namespace torture;

namespace {

const Lambertian matte{{Real(0.8), Real(0.5), Real(0.3)}};
const Metal mirror{{Real(0.9), Real(0.8), Real(0.7)}, 0}, rough{{1, Real(0.9), 1}, Real(0.4)};
const Dielectric glass{Real(1.5)}, air{1};
const CheckeredMatte checker{{Real(0.1), Real(0.1), Real(0.2)}, {1, 1, Real(0.9)}, Real(0.3)};

SceneDescription empty_scene(const View& view) {
    SceneDescription scene;
    scene.camera.view = view;
    scene.sky = plain_sky;
    return scene;
}

// 10,000 spheres at the points with whole coordinates, each touching its six neighbors.
SceneDescription lattice() {
    SceneDescription scene = empty_scene({});
    scene.materials = {matte, mirror, glass, rough, checker};
    for (int x = 0; x < 25; ++x)
        for (int y = 0; y < 20; ++y)
            for (int z = 0; z < 20; ++z)
                scene.spheres.push_back(
                    {{{static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)},
                      Real(0.5)},
                     (x + 2 * y + 3 * z) % 5});
    return scene;
}

// Along all axes, forward and backward; the other components are zeros of both signs.
std::vector<Vec3> along_axes() {
    std::vector<Vec3> all;
    for (const Real ahead : {Real(1), Real(-1)})
        for (const Real zero : {Real(0), Real(-0.0)})
            for (const Real other : {Real(0), Real(-0.0)}) {
                all.push_back({ahead, zero, other});
                all.push_back({zero, ahead, other});
                all.push_back({zero, other, ahead});
            }
    return all;
}

}  // namespace

TEST_CASE("ten thousand spheres that touch") {
    SceneDescription scene = lattice();
    // In the gap between eight of them, and in a row of gaps, along the faces of all boxes.
    for (const Vec3 at : {Vec3{5, 2, 1}, Vec3{Real(8.5), Real(10.5), Real(12.5)}}) {
        scene.camera.view = {{Real(8.5), Real(10.5), Real(10.5)}, at, {0, 1, 0}, radians(70)};
        check_scene(scene, {16, 12, 1, 12});
    }
}

TEST_CASE("every ray runs along an axis") {
    const SceneDescription scene = lattice();
    std::vector<Ray> rays;
    // Through centers, through the points where spheres touch, in faces of boxes, and between.
    const auto places = {Real(10), Real(10.25), Real(10.5), Real(-0.5), Real(19.5)};
    for (const Vec3 direction : along_axes())
        for (const Real a : places)
            for (const Real b : places) rays.push_back({{a, b, Real(10.5)}, direction});
    for (const Vec3 direction : along_axes())
        for (const Real a : places) rays.push_back({Vec3{a, a, a} - 100 * direction, direction});
    check_hits(scene, rays);
    light_along(scene, rays, 20);
}

TEST_CASE("a ray grazes a thousand spheres") {
    std::vector<Ray> rays;
    for (const Real up : {Real(0), epsilon, -epsilon, 16 * epsilon, -16 * epsilon, Real(1e-3)})
        rays.push_back({{up, up, -2}, {0, 0, 1}});
    for (const MaterialDescription& material :
         {MaterialDescription{air}, MaterialDescription{glass}, MaterialDescription{mirror},
          MaterialDescription{rough}, MaterialDescription{matte}}) {
        SceneDescription scene = empty_scene({});
        scene.materials = {material};
        for (int i = 0; i < 1000; ++i) {
            const Real side = i % 4 < 2 ? 1 : -1, z = Real(2.5) * static_cast<Real>(i);
            scene.spheres.push_back(
                {{i % 2 == 0 ? Vec3{side, 0, z} : Vec3{0, side, z}, Real(1)}, 0});
        }
        check_hits(scene, rays);
        const std::vector<Color> lights = light_along(scene, rays, 3000);
        if (std::holds_alternative<Dielectric>(material) &&
            std::get<Dielectric>(material).index == 1)
            for (const Color light : lights) {
                INFO("glass of index 1 is invisible: the ray goes straight on into the sky");
                CHECK(light == plain_sky({0, 0, 1}));
            }
        for (const Color light : light_along(whitened(scene), rays, 3000))
            CHECK(light == Color{1, 1, 1});
    }
}

TEST_CASE("rays that graze spheres where these touch their boxes") {
    SceneDescription scene = empty_scene({});
    scene.materials = {glass};
    Rng random{3, 3};
    std::vector<Ray> rays;
    const auto somewhere = [&] { return random.uniform(-1000, 1000); };
    for (int i = 0; i < 1000; ++i) {
        const Vec3 center{somewhere(), somewhere(), somewhere()};
        const Real radius = random.uniform(Real(0.01), 5);
        scene.spheres.push_back({{center, radius}, 0});
        for (int ulps = -2; ulps <= 2; ++ulps) {
            const Real reach = radius * (1 + static_cast<Real>(ulps) * epsilon);
            rays.push_back({center + Vec3{reach, 0, 2000}, {0, 0, -1}});
            rays.push_back({center + Vec3{-100, 0, -reach}, {1, Real(-0.0), 0}});
            rays.push_back({center + Vec3{reach, -10, 0}, {0, 1, 0}});
        }
    }
    check_hits(scene, rays);
    light_along(scene, rays, 3);
}

TEST_CASE("two hundred nested shells of glass") {
    // A shell's distance from the next: wide, and a few units in the last place, where a ray that
    // leaves one of them starts beyond the next.
    for (const Real step : {Real(1) / 256, 8 * epsilon}) {
        INFO("the radii differ by " << checkpoint::text(step));
        SceneDescription scene =
            empty_scene({{0, Real(0.2), 2}, {0, 0, 0}, {0, 1, 0}, radians(60)});
        for (int i = 0; i < 200; ++i)
            add(scene, {0, 0, 0}, 1 - static_cast<Real>(i) * step,
                Dielectric{i % 2 == 0 ? Real(1.5) : 1 / Real(1.5)});
        check_scene(scene, {12, 8, 1, 500});

        INFO("shells of index 1 are invisible");
        SceneDescription nothing = scene;
        nothing.spheres.clear();
        for (MaterialDescription& material : scene.materials) material = air;
        CHECK(check_scene(scene, {12, 8, 1, 500}) == draw_in_every_way(nothing, {12, 8, 1, 1}));
    }
}

TEST_CASE("a black ball in two hundred shells that bend nothing") {
    SceneDescription scene = empty_scene({});
    for (int i = 0; i < 200; ++i) add(scene, {0, 0, 0}, 1 - static_cast<Real>(i) / 256, air);
    const Real radius = Real(0.125);
    add(scene, {0, 0, 0}, radius, Lambertian{});
    // Each shell moves the ray by its point_error and a rounding, when it enters and when it
    // leaves.
    const Real off = 400 * rounding_bound(25);
    std::vector<Ray> rays;
    for (int i = 0; i < 100; ++i) {
        const Real turn = Real(0.7) * static_cast<Real>(i), p = static_cast<Real>(i) / 400;
        rays.push_back({{p * std::cos(turn), p * std::sin(turn), 3}, {0, 0, -1}});
    }
    const std::vector<Color> lights = light_along(scene, rays, 500);
    int black = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Real p = static_cast<Real>(i) / 400;
        INFO("a ray at the distance " << checkpoint::text(p) << " from the center");
        black += lights[i] == Color{};
        if (p < radius - off) CHECK(lights[i] == Color{});
        if (p > radius + off) CHECK(lights[i] == plain_sky({0, 0, -1}));
    }
    CHECK(black > 40);
}

TEST_CASE("a radius of a million beside one of a thousandth") {
    const Real huge = 1e6, tiny = Real(1e-3);
    SceneDescription scene =
        empty_scene({{Real(0.01), Real(0.02), Real(0.03)}, {0, 0, 0}, {0, 1, 0}, radians(50)});
    add(scene, {0, -huge, 0}, huge, checker);
    const MaterialDescription kinds[] = {matte, mirror, glass, rough};
    for (int x = -5; x < 5; ++x)
        for (int z = -5; z < 5; ++z)
            add(scene,
                {Real(0.0025) * static_cast<Real>(x), tiny, Real(0.0025) * static_cast<Real>(z)},
                tiny, kinds[(x + z + 10) % 4]);
    check_scene(scene);
    // In float the ground's surface is known to 0.06, so that it may hide the small spheres. In
    // double each of them is seen, and the ground beside it sees it, too.
    if (std::is_same_v<Real, float>) return;
    const WideTree world = make_wide_tree(prepare_shapes(scene).still);
    const Vec3 eye = scene.camera.view.from;
    for (std::size_t i = 1; i < scene.spheres.size(); ++i) {
        const Sphere& ball = scene.spheres[i].shape;
        const auto seen =
            world.hit(Ray{eye, normalize(ball.center + Vec3{0, tiny / 2, 0} - eye)}, Interval{});
        REQUIRE(seen);
        CHECK(seen->material == static_cast<int>(i));
        // From half a radius beside the contact straight up.
        const Ray down{ball.center + Vec3{tiny / 2, 1, 0}, {0, -1, 0}};
        const Sphere& ground = scene.spheres[0].shape;
        const auto t = hit_sphere(ground, down, Interval{});
        REQUIRE(t);
        const Vec3 up{0, 1, 0};
        const auto above =
            world.hit(Ray{leave_surface(surface_hit(ground, down, *t), up), up}, Interval{});
        REQUIRE(above);
        CHECK(above->material == static_cast<int>(i));
    }
}

TEST_CASE("the eye within glass or metal or exactly on a surface") {
    for (const MaterialDescription& material :
         {MaterialDescription{glass}, MaterialDescription{Dielectric{1 / Real(1.5)}},
          MaterialDescription{air}, MaterialDescription{mirror}, MaterialDescription{rough},
          MaterialDescription{matte}})
        // In the middle, off it, on the near, upper and right side, and where two spheres touch.
        for (const Vec3 from : {Vec3{0, 0, 0}, Vec3{Real(0.3), Real(0.5), Real(-0.2)},
                                Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{-1, 0, 0}}) {
            INFO("material " << material.index() << ", eye at " << checkpoint::text(from));
            SceneDescription scene =
                empty_scene({from, {Real(0.1), Real(-0.2), -3}, {0, 1, 0}, radians(120)});
            add(scene, {0, 0, 0}, 1, material);
            add(scene, {-3, 0, 0}, 2, glass);
            add(scene, {1, 1, -4}, 1, matte);
            add(scene, {0, -101, 0}, 100, checker);
            check_scene(scene, {12, 8, 1, 30});
        }
}

TEST_CASE("a thousand spheres in one place") {
    SceneDescription scene = empty_scene({{0, 1, 4}, {0, 0, 0}, {0, 1, 0}, radians(40)});
    scene.materials = {matte, glass, mirror, rough, checker};
    for (int i = 0; i < 1000; ++i) scene.spheres.push_back({{{0, 0, 0}, 1}, i % 5});
    check_scene(scene, {16, 12, 1, 12});
}

namespace {

// All materials on a ground, within the cube from -2 to 2. Every number is a multiple of 1/64: if
// `away` is one, too, and no larger than 2^15 in float and 2^44 in double, nothing is rounded.
SceneDescription still_life(Vec3 away = {}) {
    SceneDescription scene = empty_scene(
        {Vec3{0, Real(1.25), 2} + away, Vec3{0, Real(0.25), 0} + away, {0, 1, 0}, radians(60)});
    add(scene, Vec3{0, -2, 0} + away, 2, matte);
    add(scene, Vec3{-1, Real(0.5), 0} + away, Real(0.5), mirror);
    add(scene, Vec3{0, Real(0.625), 0} + away, Real(0.5), glass);
    add(scene, Vec3{1, Real(0.5), 0} + away, Real(0.5), rough);
    add(scene, Vec3{Real(0.5), Real(0.25), Real(0.75)} + away, Real(0.25), matte);
    add(scene, Vec3{0, Real(0.625), 0} + away, Real(0.375), air);
    return scene;
}

// The length of a side of the scene is 4: this is 10^4 of them in float, 10^12 in double.
const Real far_away =
    for_this_precision(std::ldexp(Real(1), 15) * Real(1.25), std::ldexp(Real(1), 41) * Real(1.875));

}  // namespace

TEST_CASE("a scene times a billion or a billionth is the same picture") {
    const Frame frame{36, 24, 4, 40};
    const Image usual = check_scene(still_life(), frame);
    for (const int power : {-30, 30}) {
        INFO("times 2^" << power << ", where no multiplication is rounded: the same bytes");
        CHECK(check_scene(scaled(still_life(), std::ldexp(Real(1), power)), frame) == usual);
    }
    for (const Real scale : {Real(1e-9), Real(1e9)}) {
        INFO("times " << checkpoint::text(scale));
        // Every sphere is rounded by itself: a path that just hits may just miss.
        const Image image = check_scene(scaled(still_life(), scale), frame);
        int others = 0;
        for (int y = 0; y < frame.height; ++y)
            for (int x = 0; x < frame.width; ++x) {
                const Color apart = image.at(x, y) - usual.at(x, y);
                others += std::max({std::abs(apart.r), std::abs(apart.g), std::abs(apart.b)}) >
                          Real(1e-3);
            }
        CAPTURE(others);
        CHECK(others <= for_this_precision(frame.width * frame.height / 100, 0));
    }
}

TEST_CASE("a scene far away") {
    const Vec3 away = far_away * Vec3{1, -1, 1};
    // What the eye sees is the same, bit for bit: rays and spheres are subtracted before anything
    // is rounded. A path of one bounce ends in the sky that its new direction points to.
    const Frame seen{36, 24, 4, 1};
    CHECK(check_scene(still_life(away), seen) == check_scene(still_life(), seen));
    // Every bounce then starts from a point whose coordinates are rounded, to 1/256 of a unit in
    // float and 1/2048 in double: shadows are that coarse, and no light comes or goes.
    const Frame frame{36, 24, 16, 40};
    const double near = brightness(check_scene(still_life(), frame)),
                 far = brightness(check_scene(still_life(away), frame));
    CAPTURE(near, far);
    CHECK(std::abs(far / near - 1) < 0.01);
}

TEST_CASE("no light gets into a closed room") {
    for (const Real scale : {Real(1), std::ldexp(Real(1), -30), std::ldexp(Real(1), 30)})
        for (const Vec3 away : {Vec3{}, far_away * Vec3{1, -1, 1}}) {
            // The eye is in a matte ball among glass, mirrors and matte spheres that are a little
            // away from the wall, each other, and the eye.
            SceneDescription scene = empty_scene({});
            add(scene, away, 2, matte);
            for (const Real side : {Real(-1), Real(1)}) {
                add(scene, away + Vec3{side, 0, 0}, Real(0.875), glass);
                add(scene, away + Vec3{0, side, 0}, Real(0.375), mirror);
                add(scene, away + Vec3{0, 0, side}, Real(0.375), rough);
            }
            scene = scaled(scene, scale);
            Rng random{5, 5};
            std::vector<Ray> rays;
            for (int i = 0; i < 500; ++i)
                rays.push_back({scale * away, uniform_direction(random_place(random))});
            for (const Color light : light_along(scene, rays, 200, PathEnd::black))
                REQUIRE(light == Color{});
        }
}
