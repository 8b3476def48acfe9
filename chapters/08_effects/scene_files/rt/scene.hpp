#pragma once
#include <cstdint>
#include <optional>
#include <rt/camera.hpp>
#include <rt/color.hpp>
#include <rt/dielectric.hpp>
#include <rt/effects.hpp>
#include <rt/fog.hpp>
#include <rt/image.hpp>
#include <rt/lambertian.hpp>
#include <rt/lens_and_haze.hpp>
#include <rt/mat4.hpp>
#include <rt/metal.hpp>
#include <rt/own_material.hpp>
#include <rt/sky.hpp>
#include <rt/sphere.hpp>
#include <rt/textures.hpp>
#include <variant>
#include <vector>

namespace rt {

// A scene as plain values (given): read from a file or made by a program, and not yet sorted for a
// renderer. The comments say what is allowed; any code that fills a scene must obey them.

struct CameraDescription {
    View view;
    Lens lens;
    Real shutter = 0;  // the time that it stays open, 0 or more
};

// Shines in all directions and reflects nothing. Spheres made of it do not move.
struct Emitter {
    Color radiance{1, 1, 1};  // each channel 0 or more; all 0 is a black sphere and no light
};

// Metal of tiny facets. Only later chapters draw it.
struct RoughDescription {
    Color albedo;        // head-on, each channel in [0, 1]
    Real roughness = 1;  // from 0.01 to 1
};

using MaterialDescription = std::variant<Lambertian, Metal, Dielectric, CheckeredMatte,
                                         PictureMatte, Emitter, OwnMaterial, RoughDescription>;

// A sphere with a map is an instance: the unit sphere, transformed by the map, a matrix. Its
// `shape` is then a sphere that contains the result. An instance stands still and does not shine.
struct SphereDescription {
    Sphere shape;        // where it is when the shutter opens
    int material = 0;    // an index into the scene's materials
    Vec3 velocity = {};  // how far it moves in a unit of time
    int map = -1;        // an index into the scene's maps; -1 for a plain sphere
};

// A picture of the whole sky, which replaces its two colors. Only later chapters draw it.
struct SkyImage {
    int image = 0;   // an index into the scene's images
    Real turn = 0;   // counterclockwise, seen from above, as a share of a full turn, in [0, 1)
    Real scale = 1;  // of its light, 0 or more
};

// The settings for a picture, unless the user asks for others.
struct RenderSettings {
    int width = 640, height = 360;  // pixels
    int samples_per_pixel = 64;
    int depth = 16;  // the maximum number of bounces of a path
    std::uint64_t seed = 1;
};

struct SceneDescription {
    CameraDescription camera;
    GradientSky sky;  // all 0 is black
    std::optional<Fog> fog;
    std::optional<Haze> haze;
    std::vector<MaterialDescription> materials;
    std::vector<Image> images;  // linear light
    std::vector<Mat4> maps;     // from the unit sphere to the world, none singular
    std::vector<SphereDescription> spheres;
    RenderSettings settings;
    std::optional<SkyImage> sky_image = {};
};

// Calls use(material) for every shape that is not a sphere, with the index of its material. A
// chapter that adds a kind of shape adds a list of them to the scene, and this function for it.
template <class Scene, class Use>
void for_other_shapes(Scene& /*scene*/, const Use& /*use*/) {}

// The effects that a scene calls for beyond those of 08.1. A chapter that adds a kind of shape, of
// material or of light says here when a scene has it. Of the shapes, only spheres need be asked for
// their material: see needed_effects.
inline Effects added_effects(const SceneDescription& scene) {
    return {.haze = scene.haze && scene.haze->density > 0};
}

}  // namespace rt
