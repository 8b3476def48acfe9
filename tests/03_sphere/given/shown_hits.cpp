#include <rt/shown_hits.hpp>

#include "checkpoint.hpp"

namespace {

using namespace rt;

const std::vector<SceneSphere> two{{{{-2, 0, 0}, 1}}, {{{2, 0, 0}, 1}}};

}  // namespace

TEST_CASE("a ray is shown by its direction or by what it hits", "[show]") {
    const Ray at_second{{2, 0, 5}, {0, 0, -1}}, past{{0, 0, 5}, {0, 0, -1}};
    CHECK(std::get<Vec3>(shown_hit("normal", two, at_second)) == Vec3{0, 0, 1});
    CHECK(std::get<Real>(shown_hit("distance", two, at_second)) == 4);
    CHECK(std::get<int>(shown_hit("sphere", two, at_second)) == 1);
    CHECK(std::get<Vec3>(shown_hit("direction", two, past)) == Vec3{0, 0, -1});
    for (const char* const word : {"normal", "distance", "sphere"})
        CHECK(shown_hit(word, two, past) == Shown{});
}

TEST_CASE("a tracer without paths shows what it hits and refuses the rest", "[show]") {
    SceneText scene;
    scene.width = 2;
    scene.height = 1;
    scene.spheres = two;
    const Camera camera =
        make_camera({{0, 0, 100}, {0, 0, 0}, {0, 1, 0}, radians(Real(2.3))}, 2, 1);
    TracerCall call;
    call.show = "sphere";
    const Image image = shown_hits(call, scene, camera);
    CHECK(image.at(0, 0) == number_color(0));
    CHECK(image.at(1, 0) == number_color(1));
    for (const char* const word : {"bounces", "samples"}) {
        call.show = word;
        CHECK_THROWS_AS(shown_hits(call, scene, camera), std::invalid_argument);
    }
}
