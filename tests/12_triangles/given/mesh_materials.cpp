#include <rt/leave_surface.hpp>
#include <rt/mesh_materials.hpp>
#include <rt/triangle_point.hpp>
#include <rt/wide_builder.hpp>

#include "../shapes.hpp"

using namespace checkpoint;
using rt::Corner;
using rt::Hit;

namespace {

// One triangle whose corners have normals that lean far, and a hit of it from above or from below.
struct Leaning {
    rt::SceneMeshes meshes;
    Hit hit;
    Vec3 incoming;
};
Leaning any_leaning(rt::Rng& rng) {
    Leaning made;
    rt::Mesh mesh;
    const Triangle shape{{-1, 0, -1}, {0, 0, 1}, {1, 0, -1}};
    mesh.points = {shape.a, shape.b, shape.c};
    for (int i = 0; i < 3; ++i) {
        const Vec3 sum = Vec3{0, 1, 0} + real(0.85) * any_direction(rng);
        mesh.normals.push_back(sum / std::sqrt(rt::dot(sum, sum)));
    }
    mesh.triangles = {{Corner{0, 0, -1}, {1, 1, -1}, {2, 2, -1}}};
    made.meshes.add(mesh, {}, 0);
    for (;;) {
        made.incoming = any_direction(rng);
        if (std::abs(made.incoming.y) < real(0.01)) continue;
        const Vec3 aim = point_of(shape, real(0.2), real(0.3));
        const Ray ray{aim - made.incoming, made.incoming};
        const auto met = rt::hit_triangle(shape, ray, {});
        if (!met) continue;
        made.hit = rt::surface_hit({shape, 0, 0}, ray, met->t);
        return made;
    }
}

}  // namespace

TEST_CASE("light that is reflected stays on its side of a mesh and glass sends light through") {
    rt::Rng rng{12, 30};
    using Materials = rt::MaterialSet<rt::Lambertian, rt::Mirror, rt::Metal, rt::Dielectric>;
    for (int i = 0; i < 20'000; ++i) {
        const Leaning at = any_leaning(rng);
        for (const auto& material :
             std::vector<std::variant<rt::Lambertian, rt::Mirror, rt::Metal, rt::Dielectric>>{
                 rt::Lambertian{{1, 1, 1}}, rt::Mirror{{1, 1, 1}},
                 rt::Metal{{1, 1, 1}, real(0.5)}}) {
            const rt::MeshMaterials<Materials> set{{{material}}, &at.meshes};
            const auto bounce = set(at.incoming, at.hit, rng);
            REQUIRE(bounce);
            CHECK(bounce->attenuation == rt::Color{1, 1, 1});
            REQUIRE(rt::dot(bounce->direction, rt::facing_normal(at.hit)) > 0);
            REQUIRE(std::abs(rt::dot(bounce->direction, bounce->direction) - 1) < real(1e-4));
        }
        const rt::MeshMaterials<Materials> glass{{{rt::Dielectric{real(1.5)}}}, &at.meshes};
        const auto bounce = glass(at.incoming, at.hit, rng);
        REQUIRE(bounce);
        REQUIRE(rt::dot(bounce->direction, at.hit.normal) != 0);
    }
}

TEST_CASE("the density of a matte mesh is that of its directions") {
    rt::Rng rng{12, 31};
    using Materials = rt::MaterialList<rt::Lambertian>;
    for (int round = 0; round < 20; ++round) {
        const Leaning at = any_leaning(rng);
        // Light may run over the horizon, or it may not.
        const rt::MeshWorld world{std::make_shared<rt::SceneMeshes>(at.meshes)};
        const rt::MeshMaterials<Materials> set{
            {{rt::Lambertian{{1, 1, 1}}}}, &at.meshes, round % 2 == 0 ? nullptr : &world};
        // A quantity by directions of the material, and by even directions weighted by the density.
        Mean drawn, weighted, whole;
        const auto quantity = [](Vec3 d) {
            return static_cast<double>(d.x * d.x + d.y + d.z * d.x);
        };
        for (int i = 0; i < 100'000; ++i) {
            drawn.add(quantity(set(at.incoming, at.hit, rng)->direction));
            const Vec3 even = any_direction(rng);
            const double density =
                4 * 3.14159265358979 * static_cast<double>(rt::scatter_density(set, at.hit, even));
            weighted.add(density * quantity(even));
            whole.add(density);
        }
        CHECK(std::abs(whole.mean() - 1) < 5 * whole.standard_error());
        CHECK(std::abs(drawn.mean() - weighted.mean()) <
              5 * (drawn.standard_error() + weighted.standard_error()));
    }
}

TEST_CASE("lamps are sampled on rough metal beside a mesh, too") {
    const Leaning at = [] {
        rt::Rng rng{12, 31};
        return any_leaning(rng);
    }();
    using Materials = rt::MaterialSet<rt::Lambertian, rt::Metal>;
    const Materials materials{{rt::Metal{{1, 1, 1}, real(0.5)}}};
    const rt::MeshMaterials<Materials> set{materials, &at.meshes};
    Hit sphere = at.hit;
    sphere.light = 0;  // no number of a triangle
    const Vec3 mirrored = rt::reflect(at.incoming, facing_normal(sphere));
    REQUIRE(!rt::is_triangle(sphere));
    CHECK(scatter_density(set, at.incoming, sphere, mirrored) > 0);
    CHECK(scatter_density(set, at.incoming, sphere, mirrored) ==
          scatter_density(materials, at.incoming, sphere, mirrored));
    CHECK(scatter_density(set, at.incoming, at.hit, mirrored) == 0);
}
