#pragma once
#include <rt/effects.hpp>
#include <rt/eyes.hpp>
#include <rt/fog.hpp>
#include <rt/instance_tree.hpp>
#include <rt/lights.hpp>
#include <rt/make_camera.hpp>
#include <rt/moving_spheres.hpp>
#include <rt/prepare.hpp>
#include <rt/scene.hpp>
#include <rt/wide_builder.hpp>
#include <type_traits>

namespace rt {

// The types that make up a renderer with these effects, and no others (given). These types either
// contain what an effect needs or they do not: nothing is decided while the picture is drawn.
template <Effects effects>
struct Parts {
    template <bool condition, class Yes, class No>
    using Either = std::conditional_t<condition, Yes, No>;

    static constexpr bool metal = effects.mirror || effects.fuzz;
    static constexpr bool one_material = !metal && !effects.glass && !effects.texture;
    using GivenMaterials =
        Either<one_material, MaterialList<Lambertian>,
               Either<!effects.glass && !effects.texture, MaterialSet<Lambertian, Mirror, Metal>,
                      Either<!metal && !effects.texture, MaterialSet<Lambertian, Dielectric>,
                             MaterialSet<Lambertian, Mirror, Metal, Dielectric, CheckeredMatte,
                                         ImageMatte>>>>;
    using Materials = Either<
        effects.own,
        MaterialSet<Lambertian, Mirror, Metal, Dielectric, CheckeredMatte, ImageMatte, OwnMaterial>,
        GivenMaterials>;
    using StillEye = Either<effects.lens, LensCamera, Camera>;
    using Eye = Either<effects.motion, ShutterCamera<StillEye>, StillEye>;
    using PlainWorld = Either<effects.motion, MovingWorld, WideTree>;
    using World = Either<effects.instances, TwoWorlds<PlainWorld, InstanceTree>, PlainWorld>;
    using Lights = Either<effects.lights, SphereLights, NoLights>;
    using Medium = Either<effects.fog, FogBall, NoFog>;
};

// A scene, made ready for a renderer with these effects (given). They must cover those of the
// scene, which must outlive it (its images are not copied).
template <Effects effects>
struct ReadyScene {
    typename Parts<effects>::Eye eye;
    typename Parts<effects>::World world;
    typename Parts<effects>::Materials materials;
    GradientSky sky;
    typename Parts<effects>::Lights lights;
    typename Parts<effects>::Medium fog;

    ReadyScene(const SceneDescription& scene, int width, int height)
        : materials{prepare_materials<typename Parts<effects>::Materials>(scene)}, sky{scene.sky} {
        const Prepared prepared = prepare_spheres(scene);
        set_eye(eye, scene.camera, width, height, !prepared.moving.empty());
        if constexpr (effects.instances)
            world = {plain_world(prepared), make_instance_tree(prepared.instances)};
        else
            world = plain_world(prepared);
        if constexpr (effects.lights)
            lights = {prepared.lights, static_cast<int>(scene.materials.size())};
        if constexpr (effects.fog)
            if (scene.fog) fog = {*scene.fog};
    }

  private:
    static auto plain_world(const Prepared& prepared) {
        if constexpr (effects.motion)
            return MovingWorld{make_wide_tree(prepared.still), make_moving_tree(prepared.moving)};
        else
            return make_wide_tree(prepared.still);
    }

    static void set_eye(Camera& pinhole, const CameraDescription& camera, int width, int height,
                        bool) {
        pinhole = make_camera(camera.view, width, height);
    }
    static void set_eye(LensCamera& lens, const CameraDescription& camera, int width, int height,
                        bool) {
        lens = {make_camera(camera.view, width, height), camera.lens};
    }
    template <class StillEye>
    static void set_eye(ShutterCamera<StillEye>& shutter, const CameraDescription& camera,
                        int width, int height, bool anything_moves) {
        set_eye(shutter.camera, camera, width, height, anything_moves);
        shutter.anything_moves = anything_moves;
    }
};

}  // namespace rt
