#pragma once
#include <cstdint>
#include <optional>
#include <rt/camera.hpp>
#include <rt/color.hpp>
#include <rt/dielectric.hpp>
#include <rt/fog.hpp>
#include <rt/image.hpp>
#include <rt/lambertian.hpp>
#include <rt/lens.hpp>
#include <rt/mat4.hpp>
#include <rt/metal.hpp>
#include <rt/own_material.hpp>
#include <rt/sky.hpp>
#include <rt/sphere.hpp>
#include <rt/textures.hpp>
#include <variant>
#include <vector>

namespace rt {

// What a scene is, as plain values (given): read from a file or made by a program, and not yet
// sorted into what a renderer needs. The comments say what is allowed; whoever fills a scene keeps
// to it.

struct CameraDescription {
    View view;
    Lens lens;
    Real shutter = 0;  // the time that it stays open, 0 or more
};

// Shines to all sides and reflects nothing. Spheres of it do not move.
struct Emitter {
    Color radiance{1, 1, 1};  // each channel 0 or more; all 0 is a black sphere and no light
};

using MaterialDescription =
    std::variant<Lambertian, Metal, Dielectric, CheckeredMatte, PictureMatte, Emitter, OwnMaterial>;

// One with a map is an instance: the unit sphere where that matrix takes it. Its shape is a sphere
// around that; it stands still and does not shine.
struct SphereDescription {
    Sphere shape;        // where it is when the shutter opens
    int material = 0;    // an index into the scene's materials
    Vec3 velocity = {};  // what it moves by in a unit of time
    int map = -1;        // an index into the scene's maps; -1 for a plain sphere
};

// What a picture is made with, unless the person asks for something else.
struct RenderSettings {
    int width = 640, height = 360;  // pixels
    int samples_per_pixel = 64;
    int depth = 16;  // the most bounces of a path
    std::uint64_t seed = 1;
};

struct SceneDescription {
    CameraDescription camera;
    GradientSky sky;  // all 0 is black
    std::optional<Fog> fog;
    std::vector<MaterialDescription> materials;
    std::vector<Image> images;  // linear light
    std::vector<Mat4> maps;     // from the unit sphere to the world, none singular
    std::vector<SphereDescription> spheres;
    RenderSettings settings;
};

}  // namespace rt
