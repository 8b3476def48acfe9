#pragma once
#include <cstdint>
#include <optional>
#include <rt/camera.hpp>
#include <rt/color.hpp>
#include <rt/dielectric.hpp>
#include <rt/image.hpp>
#include <rt/lambertian.hpp>
#include <rt/metal.hpp>
#include <rt/sky.hpp>
#include <rt/sphere.hpp>
#include <variant>
#include <vector>

namespace rt {

// What a scene is, as plain values (given): read from a file or made by a program, and not yet
// sorted into what a renderer needs. The comments say what is allowed; whoever fills a scene keeps
// to it.

// A lens instead of a pinhole. What lies at the distance of focus is sharp.
struct Lens {
    Real aperture = 0;        // the diameter of the lens, 0 or more; 0 is a pinhole
    Real focus_distance = 1;  // from the eye along the direction of view, greater than 0
};

struct CameraDescription {
    View view;
    Lens lens;
    Real shutter = 0;  // the time that it stays open, 0 or more
};

// Fog that fills a ball evenly. Between spheres only: there is none inside of glass.
struct Fog {
    Sphere region;
    Real density = 0;       // how often light meets a droplet on a unit of length, 0 or more
    Color albedo{1, 1, 1};  // the share of light that a droplet scatters, each channel in [0, 1]
    Real forwardness = 0;   // the mean cosine of the turn, in (-1, 1); 0 scatters evenly
};

// A matte material with two colors, in turn in cubes that fill space; the origin is the middle of
// an even one.
struct CheckeredMatte {
    Color even, odd;  // albedos
    Real size = 1;    // the side of a cube, greater than 0
};

// A matte material with an image around the sphere: its upper edge at the north pole (y up), its
// left and right edges meet at -z, its middle looks along +z.
struct PictureMatte {
    int image = 0;  // an index into the scene's images, whose colors are albedos, in [0, 1]
};

// Shines to all sides and reflects nothing. Spheres of it do not move.
struct Emitter {
    Color radiance{1, 1, 1};  // each channel 0 or more; all 0 is a black sphere and no light
};

using MaterialDescription =
    std::variant<Lambertian, Metal, Dielectric, CheckeredMatte, PictureMatte, Emitter>;

struct SphereDescription {
    Sphere shape;        // where it is when the shutter opens
    int material = 0;    // an index into the scene's materials
    Vec3 velocity = {};  // what it moves by in a unit of time
};

// What a picture is made with, unless the person asks for something else.
struct RenderSettings {
    int width = 960, height = 540;  // pixels
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
    std::vector<SphereDescription> spheres;
    RenderSettings settings;
};

}  // namespace rt
