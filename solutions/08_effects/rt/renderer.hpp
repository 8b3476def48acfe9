#pragma once
#include <rt/compiler.hpp>
#include <rt/counting_world.hpp>
#include <rt/effects.hpp>
#include <rt/eyes.hpp>
#include <rt/instance_tree.hpp>
#include <rt/lit_path.hpp>
#include <rt/make_camera.hpp>
#include <rt/moving_spheres.hpp>
#include <rt/prepare.hpp>
#include <rt/render_pixel.hpp>
#include <rt/sample_rng.hpp>
#include <rt/scene.hpp>
#include <rt/wide_builder.hpp>
#include <type_traits>

namespace rt {

// The types that a renderer with these effects, and no others, is made of (given). What an effect
// needs is in these types or it is not: nothing is left to ask while the picture is drawn.
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

// A scene, made ready for a renderer with these effects. They must cover those of the scene, which
// must outlive the renderer (its images are not copied).
template <Effects effects>
class Renderer {
  public:
    Renderer(const SceneDescription& scene, int width, int height, const Quality& quality)
        : materials_{prepare_materials<typename Parts<effects>::Materials>(scene)},
          sky_{scene.sky},
          quality_{quality} {
        const Prepared prepared = prepare_spheres(scene);
        set_eye(eye_, scene.camera, width, height, !prepared.moving.empty());
        if constexpr (effects.instances)
            world_ = {plain_world(prepared), make_instance_tree(prepared.instances)};
        else
            world_ = plain_world(prepared);
        if constexpr (effects.lights)
            lights_ = {prepared.lights, static_cast<int>(scene.materials.size())};
        if constexpr (effects.fog)
            if (scene.fog) fog_ = {*scene.fog};
    }

    // The color of a pixel, which depends on the scene, the quality and the pixel alone.
    Color operator()(int column, int row) const { return pixel(world_, column, row); }

    // The same, and counts the rays.
    Color operator()(int column, int row, std::uint64_t& rays) const {
        return pixel(CountingWorld<typename Parts<effects>::World>{world_, rays}, column, row);
    }

  private:
    template <class World>
    Color pixel(const World& world, int column, int row) const {
        if constexpr (effects.lights || effects.fog)
            return lit_pixel(world, column, row);
        else
            return plain_pixel(world, column, row);
    }

    // The average of path(ray, random) over the samples of a pixel. Each has random numbers of its
    // own (06.4), so that none depends on how many another one draws.
    template <class Path>
    Color average(int column, int row, const Path& path) const {
        Rng places = pixel_rng(quality_.seed, column, row);
        int sample = 0;
        return pixel_average(quality_.samples_per_pixel, places, [&](Vec2 offset) {
            Rng random = sample_rng(quality_.seed, column, row, sample++);
            return path(make_ray(eye_, column, row, offset, random), random);
        });
    }

    template <class World>
    RT_INLINES_ALL Color plain_pixel(const World& world, int column, int row) const {
        return average(column, row, [&](const auto& ray, Rng& random) {
            return path_radiance(ray, world, materials_, sky_, SkyEnding{}, quality_.depth, random);
        });
    }

    // The same with the loop of this chapter.
    template <class World>
    Color lit_pixel(const World& world, int column, int row) const {
        return average(column, row, [&](const auto& ray, Rng& random) {
            return lit_path_radiance(ray, world, materials_, sky_, lights_, fog_, SkyEnding{},
                                     quality_.depth, random);
        });
    }

    static auto plain_world(const Prepared& prepared) {
        if constexpr (effects.motion)
            return MovingWorld{make_wide_tree(prepared.still), make_moving_tree(prepared.moving)};
        else
            return make_wide_tree(prepared.still);
    }

    static void set_eye(Camera& eye, const CameraDescription& camera, int width, int height, bool) {
        eye = make_camera(camera.view, width, height);
    }
    static void set_eye(LensCamera& eye, const CameraDescription& camera, int width, int height,
                        bool) {
        eye = {make_camera(camera.view, width, height), camera.lens};
    }
    template <class StillEye>
    static void set_eye(ShutterCamera<StillEye>& eye, const CameraDescription& camera, int width,
                        int height, bool anything_moves) {
        set_eye(eye.camera, camera, width, height, anything_moves);
        eye.anything_moves = anything_moves;
    }

    typename Parts<effects>::Eye eye_;
    typename Parts<effects>::World world_;
    typename Parts<effects>::Materials materials_;
    GradientSky sky_;
    typename Parts<effects>::Lights lights_;
    typename Parts<effects>::Medium fog_;
    Quality quality_;
};

}  // namespace rt
