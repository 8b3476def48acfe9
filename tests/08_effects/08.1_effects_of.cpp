#include <checkpoint.hpp>
#include <rt/effects_of.hpp>
#include <rt/rng.hpp>
#include <statistics.hpp>

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
    INFO("Hint: " << hint);
    CHECK(names(found) == names(expected));
}

}  // namespace

TEST_CASE("08.1 matte spheres under a sky call for no effect", "[08.1]") {
    check(ball_of(matte), {}, "matte spheres, the pinhole and the sky need no effect");
    check({}, {}, "an empty scene calls for no effect");
}

TEST_CASE("08.1 each material calls for its effect", "[08.1]") {
    check(ball_of(rt::Metal{{1, 1, 1}, 0}), {.mirror = true}, "metal of fuzz 0 is a mirror");
    check(ball_of(rt::Metal{{1, 1, 1}, Real(0.2)}), {.fuzz = true}, "metal of fuzz 0.2 is rough");
    check(ball_of(rt::Metal{{1, 1, 1}, Real(1e-9)}), {.fuzz = true},
          "any fuzz other than 0 makes it rough, even 1e-9");
    check(ball_of(rt::Dielectric{}), {.glass = true}, "a Dielectric is glass");
    check(ball_of(rt::CheckeredMatte{}), {.texture = true}, "a checker is a texture");
    check(ball_of(rt::PictureMatte{}), {.texture = true}, "an image is a texture");
    check(ball_of(rt::OwnMaterial{}), {.own = true},
          "OwnMaterial is the material of 05.6: effects.own, whatever its color and amount");
    check(ball_of(rt::Emitter{{0, 2, 0}}), {.lights = true},
          "a light that shines in only one channel is a light");
}

TEST_CASE("08.1 lens and fog and motion each call for an effect", "[08.1]") {
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
    scene = ball_of(matte);
    scene.camera.lens.aperture = Real(1e-6);
    scene.fog = rt::Fog{{{0, 0, 0}, 5}, Real(1e-6)};
    check(scene, {.lens = true, .fog = true}, "aperture and density are small, but not 0");
}

TEST_CASE("08.1 a sphere with a map is an instance", "[08.1]") {
    SceneDescription scene = ball_of(rt::Metal{{1, 1, 1}, 0});
    scene.maps = {rt::scaling({2, 1, 1}), rt::scaling({1, 2, 1})};
    check(scene, {.mirror = true}, "the sphere has no map: its member map is -1");
    for (const int map : {0, 1}) {
        scene.spheres[0].map = map;
        check(
            scene, {.mirror = true, .instances = true},
            "the sphere has map 0, because maps are numbered from 0; its material counts as usual");
    }
}

TEST_CASE("08.1 a scene calls for the effects of all its spheres", "[08.1]") {
    SceneDescription scene = ball_of(rt::Dielectric{});
    scene.materials.push_back(rt::Metal{{1, 1, 1}, 0});
    scene.materials.push_back(rt::Metal{{1, 1, 1}, 1});
    scene.materials.push_back(rt::OwnMaterial{{1, 1, 1}, 1});
    scene.materials.push_back(matte);
    for (const int material : {1, 2, 3, 4}) scene.spheres.push_back({{{1, 1, 1}, 1}, material});
    scene.maps = {rt::scaling({2, 1, 1})};
    scene.camera.shutter = 1;
    scene.spheres[1].velocity = {0, 1, 0};
    scene.spheres[1].map = 0;
    check(scene,
          {.mirror = true,
           .fuzz = true,
           .glass = true,
           .motion = true,
           .instances = true,
           .own = true},
          "glass, a mirror with a map that moves, rough metal, your own material and a matte "
          "sphere: the last sphere must not reset the effects of those before it");
}

TEST_CASE("08.1 a material that no sphere is made of calls for no effect", "[08.1][hard]") {
    SceneDescription scene = ball_of(matte);
    scene.materials.push_back(rt::Dielectric{});
    scene.materials.push_back(rt::Metal{{1, 1, 1}, Real(0.5)});
    scene.materials.push_back(rt::Emitter{});
    scene.materials.push_back(rt::OwnMaterial{});
    check(scene, {}, "no sphere has a material other than number 0");
    scene.spheres.clear();
    check(scene, {}, "there are no spheres at all");
}

TEST_CASE("08.1 a light whose radiance is black does not count as a light", "[08.1][hard]") {
    check(ball_of(rt::Emitter{{0, 0, 0}}), {}, "a light of radiance 0 lights nothing");
    check(ball_of(rt::Emitter{{0, 0, std::numeric_limits<Real>::min()}}), {.lights = true},
          "even the faintest light is a light");
}

TEST_CASE("08.1 all motion counts while the shutter is open and none while it is closed",
          "[08.1][hard]") {
    SceneDescription scene = ball_of(matte);
    scene.spheres[0].velocity = {0, -1, 0};
    check(scene, {}, "the sphere moves, but the shutter time is 0");
    scene.camera.shutter = 1;
    scene.spheres[0].velocity = {0, 0, 0};
    check(scene, {}, "the shutter is open, but nothing moves");
    scene.spheres[0].velocity = {-1, 0, 1};
    check(scene, {.motion = true},
          "the components of the velocity (-1, 0, 1) add up to 0, but the sphere moves");
    scene.spheres[0].velocity = {0, for_this_precision(Real(1e-30), Real(1e-200)), 0};
    check(scene, {.motion = true},
          "even the slowest motion is motion, but the square of its speed underflows to 0: compare "
          "the velocity with Vec3{}");
}

TEST_CASE("08.1 fog of density 0 and a lens of aperture 0 do not count", "[08.1][hard]") {
    SceneDescription scene = ball_of(matte);
    scene.fog = rt::Fog{{{0, 0, 0}, 5}, 0};
    scene.camera.lens = {0, 7};
    check(scene, {}, "the fog's density and the aperture are both 0");
    scene.fog->density = std::numeric_limits<Real>::min();
    check(scene, {.fog = true}, "even the thinnest fog is fog");
    scene.fog = rt::Fog{{{0, 0, 0}, 5}, Real(0.2), {0, 0, 0}};
    check(scene, {.fog = true},
          "fog of the color black scatters nothing, but like smoke it dims what is behind it");
    scene = ball_of(matte);
    scene.camera.lens.aperture = Real(1e-9);
    check(scene, {.lens = true}, "a scene may be small: even an aperture of 1e-9 is a lens");
}

// Scenes with everything there is, much of it just not visible, and the effects that they call for.
TEST_CASE("08.1 a scene calls for exactly the effects that can be seen in it", "[08.1][hard]") {
    rt::Rng rng{81, 1};
    const auto one_of = [&](unsigned n) { return rng() % n == 0; };
    const auto any_number = [&] {
        return any_size(rng, for_this_precision(Real(-30), Real(-300)), 3);
    };
    const auto channel = [&](bool there) { return there && one_of(2) ? any_number() : Real(0); };
    for (int i = 0; i < 3000; ++i) {
        SceneDescription scene;
        Effects expected;
        std::string list;
        const bool short_time = one_of(2);  // or else slow motion
        scene.camera.shutter = one_of(3) ? Real(0) : short_time ? any_number() : Real(0.5);
        scene.camera.lens = {one_of(2) ? Real(0) : any_number(), any_size(rng, -6, 6)};
        expected.lens = scene.camera.lens.aperture > 0;
        // Where there is no fog, there was fog before: code that reads it anyway finds the old one.
        scene.fog = rt::Fog{{{9, 9, 9}, any_size(rng, -3, 3)}, 1, {1, 1, 1}, rng.uniform(-1, 1)};
        if (one_of(2)) {
            scene.fog.reset();
        } else {
            scene.fog->density = one_of(3) ? Real(0) : any_number();
            if (one_of(2)) scene.fog->albedo = {0, 0, 0};
            expected.fog = scene.fog->density > 0;
            list += ", fog of density " + text(scene.fog->density);
        }
        struct Kind {
            std::string name;
            bool Effects::*effect;
        };
        std::vector<Kind> kinds;
        const auto material = [&](const rt::MaterialDescription& description, std::string name,
                                  bool Effects::*effect) {
            scene.materials.push_back(description);
            kinds.push_back({std::move(name), effect});
        };
        for (unsigned k = 1 + rng() % 6; k > 0; --k) switch (rng() % 8) {
                case 0:
                    material(matte, "matte", nullptr);
                    break;
                case 1:
                    material(rt::Metal{{1, 1, 1}, 0}, "a mirror", &Effects::mirror);
                    break;
                case 2: {
                    const Real fuzz = std::min(Real(1), any_number());
                    material(rt::Metal{{1, 1, 1}, fuzz}, "metal of fuzz " + text(fuzz),
                             &Effects::fuzz);
                    break;
                }
                case 3:
                    material(rt::Dielectric{Real(1.5)}, "glass", &Effects::glass);
                    break;
                case 4:
                    material(rt::CheckeredMatte{{0, 0, 0}, {1, 1, 1}, 1}, "a checker",
                             &Effects::texture);
                    break;
                case 5:
                    material(rt::PictureMatte{}, "an image", &Effects::texture);
                    break;
                case 6:
                    material(rt::OwnMaterial{{1, 1, 1}, rng.uniform()}, "a material of your own",
                             &Effects::own);
                    break;
                default: {
                    const bool shines = one_of(2);
                    const rt::Color light{channel(shines), channel(shines), channel(shines)};
                    const bool black = light.r == 0 && light.g == 0 && light.b == 0;
                    material(rt::Emitter{light}, black ? "a black light" : "a light",
                             black ? nullptr : &Effects::lights);
                }
            }
        for (unsigned k = rng() % 12; k > 0; --k) {
            const std::size_t number = rng() % kinds.size();
            const bool light = std::holds_alternative<rt::Emitter>(scene.materials[number]);
            const Real speed = short_time ? Real(1) : any_number();
            Vec3 velocity;
            if (!light && one_of(3))
                velocity = one_of(3)   ? Vec3{speed, -speed, 0}
                           : one_of(3) ? Vec3{-speed, 0, 0}
                           : one_of(2) ? Vec3{0, speed, 0}
                                       : Vec3{0, 0, -speed};
            scene.spheres.push_back(
                {{any_direction(rng), any_size(rng, -3, 3)}, static_cast<int>(number), velocity});
            const bool moves = velocity.x != 0 || velocity.y != 0 || velocity.z != 0;
            if (!light && velocity == Vec3{} && one_of(8)) {
                scene.spheres.back().map = static_cast<int>(scene.maps.size());
                scene.maps.push_back(rt::scaling({1, 2, 3}));
                expected.instances = true;
            }
            if (kinds[number].effect) expected.*kinds[number].effect = true;
            if (moves && scene.camera.shutter > 0) expected.motion = true;
            list += ", a sphere of " + kinds[number].name +
                    (moves ? " with the velocity " + text(velocity) : "") +
                    (scene.spheres.back().map >= 0 ? " with a map" : "");
        }
        const Effects found = rt::effects_of(scene);
        INFO("the shutter is open for " << text(scene.camera.shutter) << ", the aperture is "
                                        << text(scene.camera.lens.aperture) << list);
        INFO(
            "Hint: lens and fog count with or without spheres, and a sphere of any material may "
            "move. Only ever set an effect to true: no sphere may set it back to false");
        REQUIRE(names(found) == names(expected));
    }
}
