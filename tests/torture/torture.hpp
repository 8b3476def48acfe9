#pragma once
// What must hold of every scene, however hard.

#include <rt/hit.hpp>
#include <rt/image.hpp>
#include <rt/ray.hpp>
#include <rt/scene.hpp>
#include <statistics.hpp>
#include <vector>

#include "checkpoint.hpp"

namespace torture {

using checkpoint::for_this_precision;
using namespace rt;

// The size and quality of a test's pictures.
struct Frame {
    int width = 24, height = 16;  // pixels
    int samples = 2;              // per pixel
    int depth = 40;
};

// Draws a scene with a list, with the two-wide trees, with the eight-wide one, in batches, and with
// several numbers of threads, and returns the picture. Fails unless
//   - all pictures are the same;
//   - in each sample each channel is a number, 0 or more and at most 1 in a scene without lamps.
// The second holds of every single path: all albedos and the sky are at most 1.
Image draw_in_every_way(const SceneDescription& scene, const Frame& frame = {});

// draw_in_every_way, of the scene and of the same one all in white: white light from everywhere,
// and all materials and droplets send back all light. There every sample must be exactly 1, so that
// nothing of the scene can be seen. For scenes without lamps. Returns the scene's picture.
Image check_scene(const SceneDescription& scene, const Frame& frame = {});

// The same scene all in white, as for check_scene.
SceneDescription whitened(SceneDescription scene);

// The same scene with all lengths times this.
SceneDescription scaled(SceneDescription scene, Real scale);

// The mean of all channels of all pixels.
double brightness(const Image& image);

// For each pixel the mean of its samples' brightness.
std::vector<checkpoint::Mean> pixel_means(const SceneDescription& scene, const Frame& frame);

// Fails unless a list, the two-wide trees, the eight-wide one and a batch of all rays find the same
// hits, bit for bit.
void check_hits(const SceneDescription& scene, const std::vector<Ray>& rays);

// The light along each ray, which every tree must agree on and which must be in [0, 1]. A path that
// is not over after `depth` bounces ends in the sky or in black.
enum class PathEnd { sky, black };
std::vector<Color> light_along(const SceneDescription& scene, const std::vector<Ray>& rays,
                               int depth, PathEnd end = PathEnd::sky);

// Adds a sphere of a material of its own.
inline void add(SceneDescription& scene, Vec3 center, Real radius,
                const MaterialDescription& material) {
    scene.spheres.push_back({{center, radius}, static_cast<int>(scene.materials.size())});
    scene.materials.push_back(material);
}

// A sky that tells every direction from its neighbors, and is nowhere brighter than 1.
inline constexpr GradientSky plain_sky{{Real(0.9), Real(0.6), Real(0.3)},
                                       {Real(0.2), Real(0.5), 1}};

}  // namespace torture
