#pragma once
#include <rt/cameras.hpp>
#include <rt/effects.hpp>
#include <rt/fog.hpp>
#include <rt/lens_and_haze.hpp>
#include <rt/lights.hpp>
#include <rt/make_camera.hpp>
#include <rt/prepare.hpp>
#include <rt/renderer_materials.hpp>
#include <rt/scene.hpp>
#include <type_traits>

namespace rt {

// The types that make up a renderer with exactly these effects (given). Each type contains what an
// effect needs only if the renderer has this effect, so nothing is decided while the picture is
// drawn.
template <Effects effects>
struct RendererTypes {
    template <bool condition, class Yes, class No>
    using Either = std::conditional_t<condition, Yes, No>;

    using Materials = typename RendererMaterials<effects>::Type;
    using StillCamera = Either<effects.lens, LensCamera, Camera>;
    using SceneCamera = Either<effects.motion, ShutterCamera<StillCamera>, StillCamera>;
    using World = decltype(make_world<effects>({}));
    using Lights = Either<effects.lights, SceneLights, NoLights>;
    using Medium = Either<effects.fog, FogBall, NoFog>;
    using SceneHaze = Either<effects.haze, Haze, NoHaze>;
};

// A scene, made ready for a renderer with these effects (given). These must cover the effects that
// the description calls for. The description must outlive the ReadyScene, because its images are
// not copied.
template <Effects effects>
struct ReadyScene {
    using Types = RendererTypes<effects>;
    typename Types::SceneCamera camera;
    typename Types::World world;
    typename Types::Materials materials;
    GradientSky sky;
    typename Types::Lights lights;
    typename Types::Medium fog;
    typename Types::SceneHaze haze;

    ReadyScene(const SceneDescription& scene, int width, int height)
        : ReadyScene{scene, prepare_shapes(scene), width, height} {}

  private:
    ReadyScene(const SceneDescription& scene, const Prepared& shapes, int width, int height)
        : world{make_world<effects>(shapes)},
          materials{prepare_materials<typename Types::Materials>(scene)},
          sky{scene.sky} {
        set_camera(camera, scene.camera, width, height, !shapes.moving.empty());
        if constexpr (effects.lights) lights = SceneLights{shapes.lights};
        if constexpr (effects.fog)
            if (scene.fog) fog = {*scene.fog};
        if constexpr (effects.haze)
            if (scene.haze) haze = *scene.haze;
    }

    static void set_camera(Camera& pinhole, const CameraDescription& camera, int width, int height,
                           bool) {
        pinhole = make_camera(camera.view, width, height);
    }
    static void set_camera(LensCamera& lens, const CameraDescription& camera, int width, int height,
                           bool) {
        lens = {make_camera(camera.view, width, height), camera.lens};
    }
    template <class StillCamera>
    static void set_camera(ShutterCamera<StillCamera>& shutter, const CameraDescription& camera,
                           int width, int height, bool anything_moves) {
        set_camera(shutter.camera, camera, width, height, anything_moves);
        shutter.anything_moves = anything_moves;
    }
};

}  // namespace rt
