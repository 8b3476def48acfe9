#include <checkpoint.hpp>
#include <rt/effects_of.hpp>

using namespace checkpoint;
using rt::Color;
using rt::Effects;
using rt::SceneDescription;

namespace {

// One sphere of this material, seen by a pinhole.
SceneDescription ball_of(const rt::MaterialDescription& material) {
    SceneDescription scene;
    scene.materials = {material};
    scene.spheres = {{{{0, 0, -3}, 1}, 0}};
    return scene;
}

const rt::Lambertian matte{{1, 0, 0}};

void check(const SceneDescription& scene, const Effects& expected, const char* hint) {
    const Effects found = rt::effects_of(scene);
    INFO("expected " << names(expected) << ", but yours gives " << names(found)
                     << ".\nHint: " << hint);
    CHECK((found == expected));
}

}  // namespace

TEST_CASE("08.1 matte spheres under a sky call for nothing", "[08.1]") {
    check(ball_of(matte), {}, "a matte sphere, a pinhole and the sky are there anyway");
    check({}, {}, "an empty scene calls for nothing");
}

TEST_CASE("08.1 each material calls for its effect", "[08.1]") {
    check(ball_of(rt::Metal{{1, 1, 1}, 0}), {.mirror = true}, "metal of fuzz 0 is a mirror");
    check(ball_of(rt::Metal{{1, 1, 1}, Real(0.2)}), {.fuzz = true}, "metal of fuzz 0.2 is rough");
    check(ball_of(rt::Metal{{1, 1, 1}, Real(1e-9)}), {.fuzz = true},
          "any fuzz other than 0 makes it rough, even 1e-9");
    check(ball_of(rt::Dielectric{}), {.glass = true}, "a Dielectric is glass");
    check(ball_of(rt::CheckeredMatte{}), {.texture = true}, "a checker is a texture");
    check(ball_of(rt::PictureMatte{}), {.texture = true}, "an image is a texture");
    check(ball_of(rt::Emitter{{0, 2, 0}}), {.lights = true},
          "it shines, if only in one of the three channels");
}

TEST_CASE("08.1 lens and fog and motion are found", "[08.1]") {
    SceneDescription scene = ball_of(matte);
    scene.camera.lens.aperture = Real(0.1);
    check(scene, {.lens = true}, "the aperture is 0.1");
    scene = ball_of(matte);
    scene.fog = rt::Fog{{{0, 0, 0}, 5}, Real(0.2)};
    check(scene, {.fog = true}, "there is fog, of density 0.2");
    scene = ball_of(matte);
    scene.camera.shutter = Real(0.5);
    scene.spheres[0].velocity = {0, -1, 0};
    check(scene, {.motion = true}, "the sphere moves while the shutter is open");
    scene.spheres[0].velocity = {1, 0, 0};
    check(scene, {.motion = true}, "the sphere moves along x");
    scene.spheres[0].velocity = {0, 0, 1};
    check(scene, {.motion = true}, "the sphere moves along z");
}

TEST_CASE("08.1 all spheres are looked at", "[08.1]") {
    SceneDescription scene = ball_of(rt::Dielectric{});
    scene.materials.push_back(rt::Metal{{1, 1, 1}, 0});
    scene.materials.push_back(rt::Metal{{1, 1, 1}, 1});
    scene.materials.push_back(matte);
    for (const int material : {1, 2, 3}) scene.spheres.push_back({{{1, 1, 1}, 1}, material});
    scene.camera.shutter = 1;
    scene.spheres[1].velocity = {0, 1, 0};
    check(scene, {.mirror = true, .fuzz = true, .glass = true, .motion = true},
          "glass, a mirror that moves, rough metal and a matte sphere: the last one does not undo "
          "what those before it need");
}

TEST_CASE("08.1 a material that no sphere is made of calls for nothing", "[08.1][hard]") {
    SceneDescription scene = ball_of(matte);
    scene.materials.push_back(rt::Dielectric{});
    scene.materials.push_back(rt::Metal{{1, 1, 1}, Real(0.5)});
    scene.materials.push_back(rt::Emitter{});
    check(scene, {}, "no sphere has a material other than number 0");
    scene.spheres.clear();
    check(scene, {}, "there are no spheres at all");
}

TEST_CASE("08.1 light that is black is none", "[08.1][hard]") {
    check(ball_of(rt::Emitter{{0, 0, 0}}), {}, "a light of radiance 0 lights nothing");
    check(ball_of(rt::Emitter{{0, 0, std::numeric_limits<Real>::min()}}), {.lights = true},
          "even the faintest light is one");
}

TEST_CASE("08.1 a closed shutter stops all motion", "[08.1][hard]") {
    SceneDescription scene = ball_of(matte);
    scene.spheres[0].velocity = {0, -1, 0};
    check(scene, {}, "the sphere moves, but the shutter is open for a time of 0");
    scene.camera.shutter = 1;
    scene.spheres[0].velocity = {0, 0, 0};
    check(scene, {}, "the shutter is open, but nothing moves");
    scene.spheres[0].velocity = {-1, 0, 1};
    check(scene, {.motion = true}, "the velocity (-1, 0, 1) adds up to 0, but is motion");
    scene.spheres[0].velocity = {0, for_this_precision(Real(1e-30), Real(1e-200)), 0};
    check(scene, {.motion = true},
          "the slowest motion is one, and its square is too small for a number: compare with "
          "Vec3{}");
}

TEST_CASE("08.1 fog without density and a lens without opening are none", "[08.1][hard]") {
    SceneDescription scene = ball_of(matte);
    scene.fog = rt::Fog{{{0, 0, 0}, 5}, 0};
    scene.camera.lens = {0, 7};
    check(scene, {}, "the fog's density is 0, and the aperture as well");
    scene.fog->density = std::numeric_limits<Real>::min();
    check(scene, {.fog = true}, "the thinnest fog still is fog");
    scene.fog = rt::Fog{{{0, 0, 0}, 5}, Real(0.2), {0, 0, 0}};
    check(scene, {.fog = true},
          "fog of the color black scatters nothing, but like smoke it dims what is behind it");
    scene = ball_of(matte);
    scene.camera.lens.aperture = Real(1e-9);
    check(scene, {.lens = true}, "a scene may be small: an aperture of 1e-9 still is one");
}
