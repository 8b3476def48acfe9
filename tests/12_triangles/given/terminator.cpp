// The shadow terminator: a matte mesh of few triangles under a lamp, beside the true ball.

#include <rt/leave_surface.hpp>
#include <rt/make_ball.hpp>
#include <rt/mesh_scene.hpp>
#include <rt/renderer.hpp>

#include "../shapes.hpp"

using namespace checkpoint;
using rt::Corner;
using rt::Hit;
using rt::Image;
using rt::Interval;

namespace {

constexpr int width = 160;
constexpr rt::Effects lamp_only{.lights = true};
constexpr int clay = 0;

// A small lamp on the right, above and a little behind what is at the origin.
rt::SceneDescription under_a_lamp() {
    rt::SceneDescription scene;
    scene.camera.view.from = {0, 0, 5};
    scene.camera.view.at = {0, 0, 0};
    scene.camera.view.vertical_fov = rt::radians(26);
    scene.sky = {{0, 0, 0}, {0, 0, 0}};
    scene.materials = {rt::Lambertian{{real(0.8), real(0.8), real(0.8)}},
                       rt::Emitter{{600, 600, 600}}};
    scene.spheres.push_back({{{8, 4, -1}, real(0.3)}, 1});
    return scene;
}

template <class Renderer>
Image draw(const Renderer& renderer) {
    Image image(width, width);
    for (int y = 0; y < width; ++y)
        for (int x = 0; x < width; ++x) image.at(x, y) = renderer(x, y);
    return image;
}

constexpr rt::Quality quality{16, 4, 1};  // samples, bounces, seed

// What differs between the pictures of a mesh and of the true ball, where both are seen.
struct Off {
    int seen = 0, black = 0, lit = 0;  // black where the ball is clearly lit, and the other way
    int off = 0;                       // by more than 16 of 255
};
Off compare(const Image& mesh, const Image& ball, const rt::SceneDescription& scene,
            const rt::MeshWorld& tree) {
    const rt::Camera camera = rt::make_camera(scene.camera.view, width, width);
    Off off;
    for (int y = 0; y < width; ++y)
        for (int x = 0; x < width; ++x) {
            bool inside = true;
            for (const Real right : {0, 1})
                for (const Real down : {0, 1})
                    inside = inside && tree.hit(rt::primary_ray(camera, x, y, {right, down}),
                                                Interval{0, rt::infinity});
            if (!inside) continue;
            const int of_mesh = rt::to_byte(mesh.at(x, y).g),
                      of_ball = rt::to_byte(ball.at(x, y).g);
            ++off.seen;
            off.black += of_mesh == 0 && of_ball > 40;
            off.lit += of_mesh > 40 && of_ball == 0;
            off.off += std::abs(of_mesh - of_ball) > 16;
        }
    return off;
}

}  // namespace

TEST_CASE("the shadow of a lamp ends on a mesh where it ends on the true ball") {
    rt::SceneDescription scene = under_a_lamp();
    rt::SceneMeshes mesh;
    mesh.add(rt::make_ball(2), {}, clay);
    REQUIRE(mesh.size() == 320);
    const rt::MeshWorld tree{std::make_shared<const rt::SceneMeshes>(mesh)};
    const Image with_lift = draw(rt::Renderer<lamp_only, rt::MeshScene<lamp_only>>{
        scene, width, width, quality, std::move(mesh)});
    rt::SceneDescription round = scene;
    round.spheres.push_back({{{0, 0, 0}, 1}, clay});
    const Image ball = draw(rt::Renderer<lamp_only>{round, width, width, quality});
    const Off off = compare(with_lift, ball, scene, tree);
    CAPTURE(off.seen, off.black, off.lit, off.off);
    CHECK(off.seen > 10'000);
    CHECK(off.black == 0);
    CHECK(off.lit == 0);
    CHECK(off.off == 0);
}

TEST_CASE("without the lift the same picture has black corners") {
    // So the test above can fail.
    rt::SceneDescription scene = under_a_lamp();
    rt::SceneMeshes mesh;
    mesh.add(rt::make_ball(2), {}, clay);
    const rt::MeshWorld tree{std::make_shared<const rt::SceneMeshes>(mesh)};
    rt::MeshScene<lamp_only> ready{scene, width, width, std::move(mesh)};
    ready.materials.triangles = nullptr;
    const rt::JitteredSamples samples{quality.seed, quality.samples_per_pixel};
    const Image image = draw([&](int x, int y) {
        return samples.average(ready.camera, x, y, [&](const auto& ray, auto& random) {
            return rt::lit_path_radiance(ray, ready.world, ready.materials, ready.sky, ready.lights,
                                         ready.fog, rt::SkyEnding{}, quality.depth, random);
        });
    });
    rt::SceneDescription round = scene;
    round.spheres.push_back({{{0, 0, 0}, 1}, clay});
    const Image ball = draw(rt::Renderer<lamp_only>{round, width, width, quality});
    const Off off = compare(image, ball, scene, tree);
    CAPTURE(off.seen, off.black, off.lit, off.off);
    CHECK(off.black > 20);
    CHECK(off.off > 50);
}

namespace {

using Materials = rt::MaterialSet<rt::Lambertian, rt::Metal, rt::Dielectric>;
enum { matte, metal, glass };

// A closed surface with hills and hollows, and the normals that add_normals gives it.
rt::Mesh any_rock(rt::Rng& rng, Real size, Vec3 at) {
    rt::Mesh rock = rt::make_ball(2);
    for (Vec3& point : rock.points) point = at + size * rng.uniform(real(0.6), 1) * point;
    for (auto& triangle : rock.triangles)
        for (Corner& corner : triangle) corner.normal = -1;
    rock.normals.clear();
    rt::add_normals(rock);
    return rock;
}

// A scene's triangles, and their materials as a renderer for scenes with lamps has them.
struct Rocks {
    std::shared_ptr<const rt::SceneMeshes> all;
    rt::MeshWorld tree;
    rt::MeshMaterials<Materials> materials;

    explicit Rocks(rt::SceneMeshes meshes)
        : all{std::make_shared<const rt::SceneMeshes>(std::move(meshes))}, tree{all} {
        materials = {{{rt::Lambertian{{1, 1, 1}}, rt::Metal{{1, 1, 1}, real(0.5)},
                       rt::Dielectric{real(1.5)}}},
                     all.get(),
                     &tree};
    }
    Rocks(const Rocks&) = delete;
    Rocks& operator=(const Rocks&) = delete;
};

// Where light starts that is not lifted.
Vec3 plain_start(const Rocks& rocks, const Hit& hit, Vec3 direction) {
    return rt::leave_surface(rt::off_edges(rt::triangle_of(*rocks.all, hit), hit), direction);
}

}  // namespace

TEST_CASE("light that falls on a closed mesh stays outside and light inside stays inside") {
    rt::Rng rng{12, 40};
    long over = 0;
    for (int round = 0; round < 40; ++round) {
        const Real size = any_size(rng, -6, 6);
        const Vec3 at = size * any_size(rng, -1, for_this_precision(1, 4)) * any_direction(rng);
        rt::SceneMeshes meshes;
        meshes.add(any_rock(rng, size, at), {}, round % 4 == 3 ? metal : matte);
        const Rocks rocks{std::move(meshes)};
        for (int i = 0; i < 5000; ++i) {
            const bool from_inside = i % 2 == 0;
            const Vec3 start = at + (from_inside ? real(0.2) : Real(3)) * size * any_direction(rng);
            const Vec3 aim = at + real(0.5) * size * any_direction(rng);
            Ray ray{start, aim - start};
            for (int bounce = 0; bounce < 6; ++bounce) {
                const auto hit = rocks.tree.hit(ray, Interval{0, rt::infinity});
                const bool right = hit ? hit->front != from_inside : !from_inside;
                if (!right) {
                    INFO("round " << round << ", path " << i << ", bounce " << bounce << ": "
                                  << text(ray) << (from_inside ? " left" : " got into")
                                  << " the mesh");
                    REQUIRE(right);
                }
                if (!hit) break;
                const auto next = rocks.materials(ray.direction, *hit, rng);
                REQUIRE(next);
                over += !(rt::dot(next->direction, rt::facing_normal(*hit)) > 0);
                ray = {rt::leaving_point(rocks.materials, *hit, next->direction), next->direction};
            }
        }
    }
    CHECK(over > 1000);
}

TEST_CASE("light that runs over the horizon does not start beyond another triangle") {
    rt::Rng rng{12, 41};
    long over = 0, kept = 0;
    for (int round = 0; round < 30; ++round) {
        const Real size = any_size(rng, -6, 6);
        // A ball, and a plate that is nearer to it than the lift.
        rt::SceneMeshes meshes;
        rt::Mesh ball = rt::make_ball(1);
        for (Vec3& point : ball.points) point = size * point;
        meshes.add(ball, {}, matte);
        rt::Mesh plate;
        const Real y = size * rng.uniform(real(0.86), real(1.02)), far = 4 * size;
        plate.points = {{-far, y, -far}, {far, y, -far}, {0, y, far}};
        plate.triangles = {{Corner{0}, Corner{1}, Corner{2}}};
        meshes.add(plate, {}, matte);
        const Rocks rocks{std::move(meshes)};
        for (int i = 0; i < 20'000; ++i) {
            const Vec3 from = size * Vec3{rng.uniform(-2, 2), real(0.5), rng.uniform(-2, 2)};
            const Vec3 aim =
                size * Vec3{rng.uniform(real(-0.5), real(0.5)), rng.uniform(real(0.7), 1),
                            rng.uniform(real(-0.5), real(0.5))};
            const Ray ray{from, aim - from};
            const auto hit = rocks.tree.hit(ray, Interval{0, rt::infinity});
            if (!hit || hit->point.y > y || !hit->front) continue;
            const auto next = rocks.materials(ray.direction, *hit, rng);
            REQUIRE(next);
            const bool lifted = !(rt::dot(next->direction, rt::facing_normal(*hit)) > 0);
            over += lifted;
            const Vec3 origin = rt::leaving_point(rocks.materials, *hit, next->direction);
            // No higher than rounding lets it be without a lift.
            const bool below = origin.y < y || !lifted;
            if (!below) {
                INFO("the plate is at a height of " << text(y) << ", and light that leaves "
                                                    << text(hit->point) << " starts at "
                                                    << text(origin));
                REQUIRE(below);
            }
            kept += !lifted;
        }
    }
    CHECK(over > 100);
    CHECK(kept > 1000);
}

TEST_CASE("only matte light is lifted") {
    rt::Rng rng{12, 42};
    for (const int material : {metal, glass}) {
        rt::SceneMeshes meshes;
        meshes.add(any_rock(rng, 1, {}), {}, material);
        const Rocks rocks{std::move(meshes)};
        rt::MeshMaterials<Materials> never = rocks.materials;
        never.triangles = nullptr;
        long through = 0;
        for (int i = 0; i < 50'000; ++i) {
            const Vec3 start = (i % 2 == 0 ? real(0.2) : Real(3)) * any_direction(rng);
            const Ray ray{start, real(0.5) * any_direction(rng) - start};
            const auto hit = rocks.tree.hit(ray, Interval{0, rt::infinity});
            if (!hit) continue;
            rt::Rng same{12, static_cast<std::uint64_t>(i)}, again = same;
            const auto next = rocks.materials(ray.direction, *hit, same);
            const auto plain = never(ray.direction, *hit, again);
            REQUIRE(next);
            REQUIRE(plain);
            REQUIRE(next->direction == plain->direction);
            through += rt::dot(next->direction, rt::facing_normal(*hit)) < 0;
            REQUIRE(rt::leaving_point(rocks.materials, *hit, next->direction) ==
                    plain_start(rocks, *hit, next->direction));
        }
        CHECK((through > 1000) == (material == glass));
    }
}

TEST_CASE("flat meshes scatter light as if nothing could be lifted") {
    rt::Rng rng{12, 43};
    rt::Mesh flat = any_rock(rng, 1, {});
    for (auto& triangle : flat.triangles)
        for (Corner& corner : triangle) corner.normal = -1;
    rt::SceneMeshes meshes;
    meshes.add(flat, {}, matte);
    const Rocks rocks{std::move(meshes)};
    rt::MeshMaterials<Materials> never = rocks.materials;
    never.triangles = nullptr;
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 start = 3 * any_direction(rng);
        const Ray ray{start, real(0.5) * any_direction(rng) - start};
        const auto hit = rocks.tree.hit(ray, Interval{0, rt::infinity});
        if (!hit) continue;
        rt::Rng same{12, static_cast<std::uint64_t>(i)}, again = same;
        const Vec3 direction = rocks.materials(ray.direction, *hit, same)->direction;
        REQUIRE(direction == never(ray.direction, *hit, again)->direction);
        REQUIRE(rt::leaving_point(rocks.materials, *hit, direction) ==
                plain_start(rocks, *hit, direction));
        const Vec3 any = any_direction(rng);
        REQUIRE(scatter_density(rocks.materials, *hit, any) == scatter_density(never, *hit, any));
    }
    SUCCEED();
}
