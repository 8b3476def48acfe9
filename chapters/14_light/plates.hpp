#pragma once
// Four plates that mirror four lamps, from sharp to dull, and from small to large.
// Source of the idea: Veach and Guibas, "Optimally combining sampling techniques for Monte Carlo
// rendering", SIGGRAPH 1995.

#include <rt/aggregate.hpp>
#include <rt/cameras.hpp>
#include <rt/lens_and_haze.hpp>
#include <rt/lobe.hpp>
#include <rt/make_camera.hpp>
#include <rt/renderer.hpp>
#include <rt/triangle_leaf.hpp>
#include <rt/two_way_path.hpp>
#include <rt/wide_builder.hpp>

namespace light {

using namespace rt;

inline View plates_view() {
    View view;
    view.from = {0, 2, 15};
    view.at = {0, Real(-1.9), Real(2.5)};
    view.vertical_fov = radians(28);
    return view;
}

// The scene, ready for a Renderer.
struct PlatesScene {
    Camera camera;
    MaterialSet<Lambertian, Lobe> materials;
    Aggregate<decltype(make_wide_tree(std::vector<SceneSphere>{})), TriangleTree> world;
    GradientSky sky{};
    WayLights lights;
    NoFog fog{};
    NoHaze haze{};

    PlatesScene(const SceneDescription& scene, int width, int height, Ways ways)
        : PlatesScene{scene, width, height, ways, Shapes{}} {}

  private:
    struct Shapes {
        std::vector<SceneSphere> spheres;
        std::vector<Light> lights;
        std::vector<SceneTriangle> triangles;
        MaterialSet<Lambertian, Lobe> materials;

        Shapes() {
            materials.materials = {Lambertian{}, Lambertian{{Real(0.4), Real(0.4), Real(0.4)}}};
            const Vec3 eye = plates_view().from;
            // All lamps send out the same power: the smaller, the brighter.
            const unsigned colors[]{0xff6a4du, 0xffc04du, 0x6ad06au, 0x6aa0ffu};
            const Real radii[]{Real(0.0333), Real(0.1), Real(0.3), Real(0.9)};
            for (int i = 0; i < 4; ++i) {
                const Real radius = radii[i], x = Real(-3.75) + Real(2.5) * static_cast<Real>(i);
                add_lamp({{x, 0, 0}, radius}, Real(1.3) / (radius * radius) * from_hex(colors[i]));
            }
            // A plate turns its face halfway between the eye and the middle of the lamps.
            const Real places[][2]{{Real(-2.4), Real(0)},
                                   {Real(-3.05), Real(1)},
                                   {Real(-3.6), Real(2.2)},
                                   {Real(-3.9), Real(3.6)}};
            const Real spreads[]{Real(0.006), Real(0.025), Real(0.08), Real(0.2)};
            for (int i = 0; i < 4; ++i) {
                const Vec3 middle{0, places[i][0], places[i][1]};
                const Vec3 normal = normalize(normalize(eye - middle) + normalize(-middle));
                const Vec3 across{4, 0, 0}, up = Real(0.5) * normalize(cross(normal, across));
                const auto material = static_cast<int>(materials.materials.size());
                materials.materials.push_back(
                    Lobe{{Real(0.9), Real(0.9), Real(0.9)}, 1 / (spreads[i] * spreads[i])});
                add_square(material, middle, across, up);
            }
            add_square(1, {0, Real(-4.6), 0}, {0, 0, 20}, {20, 0, 0});  // the floor
            add_square(1, {0, 0, Real(-2.5)}, {20, 0, 0}, {0, 20, 0});  // the wall
        }
        void add_lamp(const Sphere& shape, Color radiance) {
            const auto number = static_cast<int>(lights.size());
            lights.push_back({shape, radiance, number, static_cast<int>(spheres.size())});
            spheres.push_back({shape, 0, number});
        }
        void add_square(int material, Vec3 middle, Vec3 across, Vec3 up) {
            const Vec3 a = middle - across - up, c = middle + across + up;
            for (const Triangle& half :
                 {Triangle{a, middle + across - up, c}, Triangle{a, c, middle - across + up}})
                triangles.push_back({half, material, static_cast<int>(triangles.size())});
        }
    };

    PlatesScene(const SceneDescription& scene, int width, int height, Ways ways,
                const Shapes& shapes)
        : camera{make_camera(scene.camera.view, width, height)},
          materials{shapes.materials},
          world{make_wide_tree(shapes.spheres), make_wide_tree(shapes.triangles)},
          lights{{shapes.lights, {}}, ways} {}
};

}  // namespace light
