// terminator_cost [ROUNDS]: what it costs to let light run over a triangle's horizon. Draws the
// scene "ball" with and without it, in turns, in one thread, with few triangles and with many.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <rt/mesh_scene.hpp>
#include <rt/renderer.hpp>
#include <vector>

#include "scene.hpp"

using namespace rt;

namespace {

constexpr Effects lamp_only{.lights = true};
constexpr int width = 160, height = 90;

double seconds_for(const MeshScene<lamp_only>& scene) {
    const JitteredSamples samples{1, 16};
    const std::clock_t start = std::clock();
    Color sum;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            sum += samples.average(scene.camera, x, y, [&](const auto& ray, auto& random) {
                return lit_path_radiance(ray, scene.world, scene.materials, scene.sky, scene.lights,
                                         scene.fog, SkyEnding{}, 12, random);
            });
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return sum.g > 0 ? seconds : 0;  // so that the compiler keeps the loop
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 15;
    for (const int cuts : {2, 6}) {
        triangles::Scene made = triangles::make_clay_ball(true, triangles::scene_view(), cuts);
        MeshScene<lamp_only> scene{made.description, width, height, std::move(made.meshes)};
        const TriangleTree* const with = scene.materials.triangles;
        std::vector<double> ratios;
        for (int round = 0; round < rounds; ++round) {
            scene.materials.triangles = with;
            const double lifted = seconds_for(scene);
            scene.materials.triangles = nullptr;
            ratios.push_back(lifted / seconds_for(scene));
        }
        std::sort(ratios.begin(), ratios.end());
        std::printf("%zu triangles: with the lift, %.3f times as long (%.3f to %.3f)\n",
                    scene.mesh.triangles.size(), ratios[ratios.size() / 2], ratios.front(),
                    ratios.back());
    }
}
