#pragma once
#include <rt/lit_mesh_scene.hpp>
#include <rt/picture_sky.hpp>
#include <rt/rough_materials.hpp>

namespace rt {

// A sky of two colors, or of a picture (given).
struct SceneSky {
    GradientSky colors;
    std::optional<PictureSky> picture;

    Color operator()(Vec3 direction) const {
        return picture ? (*picture)(direction) : colors(direction);
    }
};

// What shines in a scene (given): its lamps, and its sky, if that is a picture. It has the
// functions of MeshLights, and sky_density.
class SkyLights {
  public:
    // The sky must outlive the lights.
    SkyLights(MeshLights lamps, const SceneSky& sky) : lamps_{std::move(lamps)}, sky_{&sky} {
        light_of_sky_.number = -2;  // that of no shape
    }

    bool empty() const { return lamps_.empty() && !sky_->picture; }
    const Light* find(const Hit& hit) const { return lamps_.empty() ? nullptr : lamps_.find(hit); }
    Real density(const Light& light, Vec3 from, Vec3 point) const {
        return (1 - share_of_sky()) * lamps_.density(light, from, point);
    }
    // The probability density with which choose() takes a direction to the sky.
    Real sky_density(Vec3 direction) const {
        return sky_->picture ? share_of_sky() * sky_->picture->density(direction) : 0;
    }

    // One of the lamps or the sky, and a direction to it.
    template <class Random>
    std::optional<ChosenLight> choose(Vec3 from, Random& random) const {
        const Real share = share_of_sky();
        if (share == 0 || (share < 1 && random.uniform() >= share)) {
            std::optional<ChosenLight> chosen = lamps_.choose(from, random);
            if (chosen) chosen->sample.density *= 1 - share;
            return chosen;
        }
        std::optional<LightSample> sample = sky_->picture->sample(random_place(random));
        if (!sample) return {};
        sample->density *= share;
        return ChosenLight{*sample, (*sky_->picture)(sample->direction), &light_of_sky_};
    }

  private:
    // The probability with which choose() takes the sky.
    Real share_of_sky() const {
        if (!sky_->picture) return 0;
        return lamps_.empty() ? 1 : Real(0.5);
    }

    MeshLights lamps_;
    const SceneSky* sky_;
    Light light_of_sky_{};
};

// A scene whose sky may be a picture, whose meshes may shine, and in which there may be rough
// metals, made ready for a renderer with these effects (given).
template <Effects effects>
struct SkyScene : MeshScene<effects> {
    using Meshes = MeshScene<effects>;
    RoughMaterials<decltype(Meshes::materials)> materials;
    SceneSky sky;
    LightsByWays<SkyLights> lights;

    SkyScene(const SceneDescription& scene, int width, int height, SceneMeshes placed,
             Ways ways = Ways::power)
        : SkyScene{MeshLights{prepare_shapes(scene).lights, lamp_triangles(scene, placed)},
                   scene,
                   width,
                   height,
                   std::move(placed),
                   ways} {}

  private:
    SkyScene(MeshLights lamps, const SceneDescription& scene, int width, int height,
             SceneMeshes placed, Ways ways)
        : Meshes{scene, width, height, std::move(placed)},
          materials{with_rough_metals(Meshes::materials, scene, this->meshes.get())},
          sky{sky_of(scene)},
          lights{{std::move(lamps), sky}, ways} {}

    static SceneSky sky_of(const SceneDescription& scene) {
        if (!scene.sky_image) return {scene.sky, {}};
        const auto& [image, turn, scale] = *scene.sky_image;
        return {scene.sky, PictureSky{scene.images[static_cast<std::size_t>(image)], turn, scale}};
    }
};

}  // namespace rt
