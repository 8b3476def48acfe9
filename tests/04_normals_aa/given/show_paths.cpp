#include <rt/lambertian.hpp>
#include <rt/show_paths.hpp>
#include <rt/shown_image.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>

#include "checkpoint.hpp"

namespace {

using namespace rt;

// Two spheres, one beside the other; both are of material 0.
SphereList two_spheres() {
    return {{{{{-2, 0, 0}, 1}, 0}, {{{2, 0, 0}, 1}, 0}}};
}

// The two spheres fill the left and the right half of two pixels.
app::Picture show(const std::string& word, int spp) {
    app::Settings settings;
    settings.width = 2;
    settings.height = 1;
    settings.spp = spp;
    settings.depth = 3;
    settings.seed = 1;
    settings.view = View{{0, 0, 100}, {0, 0, 0}, {0, 1, 0}, radians(Real(2.3))};
    settings.show = word;
    const MaterialList<Lambertian> materials{{{{1, 1, 1}}}};
    app::Progress progress{false};
    return show_paths(settings, progress, two_spheres(), materials, UniformSky{}, SkyEnding{});
}

}  // namespace

TEST_CASE("a ray is shown by its direction, or by its hit", "[show]") {
    const SphereList world = two_spheres();
    const Ray at_second{{2, 0, 5}, {0, 0, -1}}, past{{0, 0, 5}, {0, 0, -1}};
    CHECK(std::get<Vec3>(show_hit("normal", at_second, world)) == Vec3{0, 0, 1});
    CHECK(std::get<Real>(show_hit("distance", at_second, world)) == 4);
    CHECK(std::get<int>(show_hit("sphere", at_second, world)) == 1);
    CHECK(std::get<int>(show_hit("sphere", at_second, world, &Hit::material)) == 0);
    CHECK(show_hit("distance", past, world) == Shown{});
    CHECK(std::get<Vec3>(show_hit("direction", past, world)) == Vec3{0, 0, -1});
}

TEST_CASE("each sphere is shown in its own color", "[show]") {
    const Image image = show("sphere", 1).image;
    CHECK(image.at(0, 0) == number_color(0));
    CHECK(image.at(1, 0) == number_color(1));
}

TEST_CASE("nothing varies in a white furnace", "[show]") {
    // Whatever the path, its light is 1: the spread is 0 wherever a sphere is hit.
    const app::Picture picture = show("samples", 9);
    CHECK(picture.words().find("black is 0 or less, red the median, 0") != std::string::npos);
}

TEST_CASE("the hits of a path are counted and shadow rays are not", "[show]") {
    int hits = 0;
    const SphereList world = two_spheres();
    const HitCounter<SphereList> counter{world, hits};
    counter.hit(Ray{{2, 0, 5}, {0, 0, -1}}, {0, infinity});
    counter.hit(Ray{{0, 0, 5}, {0, 0, -1}}, {0, infinity});
    CHECK(hits == 1);
}

TEST_CASE("the standard deviation of samples", "[show]") {
    CHECK(deviation_of({1, 1, 1}) == 0);
    CHECK(deviation_of({2, 4, 6}) == 2);
}

TEST_CASE("samples can be compared only if there are two", "[show]") {
    CHECK_THROWS_AS(show("samples", 1), app::UsageError);
    CHECK_NOTHROW(show("bounces", 1));
}

TEST_CASE("a tracer shows what its world finds", "[show]") {
    const SphereList world = two_spheres();
    SceneText scene;
    scene.width = 2;
    scene.height = 1;
    scene.spheres = world.spheres;
    TracerCall call;
    const auto show_by = [&](const char* word, int samples) {
        call.show = word;
        return shown_image(
            call, scene, make_camera({{0, 0, 100}, {0, 0, 0}, {0, 1, 0}, radians(Real(2.3))}, 2, 1),
            world, MaterialList<Lambertian>{{{{1, 1, 1}}}}, GradientSky{}, Quality{samples, 2, 1});
    };
    const Image spheres = show_by("sphere", 1);
    CHECK(spheres.at(0, 0) == number_color(0));
    CHECK(spheres.at(1, 0) == number_color(1));
    // Every path bounces at the one ball or flies by.
    const Image bounces = show_by("bounces", 16);
    CHECK(bounces.at(0, 0) != nothing_color);
    CHECK_THROWS_AS(show_by("samples", 1), std::invalid_argument);
}

TEST_CASE("a tracer is told which words it can show", "[show]") {
    std::string words[] = {"tracer", "a.txt", "b.ppm", "--show", "depth"};
    char* all[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(),
                   words[4].data()};
    CHECK_THROWS_AS(read_call(5, all), std::invalid_argument);
    words[4] = "sphere";
    all[4] = words[4].data();
    CHECK(read_call(5, all).show == "sphere");
}
