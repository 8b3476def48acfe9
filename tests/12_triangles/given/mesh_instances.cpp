// Meshes that are placed many times: instances give the same bits as copies.

#include <rt/make_teapot.hpp>
#include <rt/mesh_materials.hpp>
#include <rt/mesh_world.hpp>

#include "../shapes.hpp"

using namespace checkpoint;
using rt::Interval, rt::Mat4, rt::Mesh;

namespace {

// A matrix that turns, stretches, shears, mirrors and moves.
Mat4 any_place(rt::Rng& rng, int kind) {
    const auto turn = [&] { return rt::rotation_y(in_cube(rng).x * 4); };
    const auto tilt = [&] { return rt::rotation_x(in_cube(rng).x * 4); };
    const Real far = kind % 5 == 4 ? real(1e4) : 3;
    Mat4 place = multiply(turn(), tilt());
    if (kind % 4 == 1) place = multiply(place, rt::scaling({3, real(0.01), -1}));
    if (kind % 4 == 2) place = multiply(place, multiply(rt::scaling({1, 50, 1}), turn()));
    if (kind % 4 == 3) {
        place = rt::scaling({real(1e-3), real(1e-3), real(1e-3)});
        place(0, 1) = real(2e-3);
    }
    if (kind % 6 == 5)  // the inverse has only a few digits in float
        place =
            multiply(turn(), multiply(rt::scaling({1, 1, real(3e-4)}), multiply(tilt(), turn())));
    return multiply(rt::translation(far * in_cube(rng)), place);
}

// Triangles of all kinds: needles, flat ones, some in one plane, some without area.
Mesh any_mesh(rt::Rng& rng) {
    Mesh mesh;
    for (int i = 0; i < 60; ++i) {
        const Triangle shape = placed(plain_triangle(rng), Real(0.4), in_cube(rng));
        for (const Vec3& point : {shape.a, shape.b, shape.c}) mesh.points.push_back(point);
        const int first = 3 * i;
        mesh.triangles.push_back({rt::Corner{first}, {first + 1}, {first + 2}});
        if (i % 3 == 0) mesh.points[static_cast<std::size_t>(first)].y = mesh.points.back().y;
        if (i % 7 == 0) mesh.triangles.push_back(mesh.triangles.back());
        if (i % 11 == 0) mesh.triangles.back()[2] = mesh.triangles.back()[1];
    }
    return mesh;
}

void check_same(const rt::MeshWorld& copies, const rt::MeshWorld& instances, const Ray& ray,
                Interval within) {
    const auto expected = copies.hit(ray, within), actual = instances.hit(ray, within);
    const bool is_same =
        expected.has_value() == actual.has_value() &&
        (!expected || (expected->t == actual->t && expected->point == actual->point &&
                       expected->normal == actual->normal && expected->front == actual->front &&
                       expected->material == actual->material && expected->light == actual->light &&
                       expected->point_error == actual->point_error));
    if (is_same && instances.occluded(ray, within) == expected.has_value()) return;
    INFO(text(ray));
    INFO("copies: " << (expected ? text(expected->point) : "none"));
    INFO("instances: " << (actual ? text(actual->point) : "none"));
    REQUIRE(is_same);
    REQUIRE(instances.occluded(ray, within) == expected.has_value());
}

}  // namespace

TEST_CASE("an instance of a mesh is hit as its copy is, to the last bit") {
    rt::Rng rng{12, 59};
    long hits = 0;
    for (int round = 0; round < 60; ++round) {
        const auto one = std::make_shared<const Mesh>(any_mesh(rng));
        const auto other =
            std::make_shared<const Mesh>(round % 2 ? any_mesh(rng) : rt::make_teapot(1));
        const auto materials = std::make_shared<const std::vector<int>>(one->triangles.size(), 7);
        auto placed = std::make_shared<rt::SceneMeshes>();
        for (int i = 0; i < 12; ++i) {
            // Some stand in the place of another.
            const Mat4 place = i % 4 == 3 ? placed->placed()[0].instance().object_to_world
                                          : any_place(rng, round + i);
            if (i % 4 == 2)
                placed->add(std::make_shared<const Mesh>(any_mesh(rng)), place, 5);
            else if (i % 2)
                placed->add(other, place, i);
            else
                placed->add(one, place, i, i % 4 ? materials : rt::TriangleMaterials{});
        }
        const rt::MeshWorld instances{placed};
        auto copied = std::make_shared<rt::SceneMeshes>(*placed);
        copied->make_copies();
        const rt::MeshWorld copies{copied};
        auto some_copied = std::make_shared<rt::SceneMeshes>(*placed);
        some_copied->make_copies(0);  // those of one place alone
        const rt::MeshWorld some{some_copied};
        for (int i = 0; i < 1500; ++i) {
            const auto any_point = [&] {
                const rt::PlacedMesh& mesh = placed->placed()[rng() % placed->placed().size()];
                const auto& shape =
                    mesh.triangle(mesh.first() +
                                  static_cast<int>(rng() % static_cast<unsigned>(mesh.size())))
                        .shape;
                return rng() % 3 == 0   ? shape.a
                       : rng() % 2 == 0 ? Real(0.5) * shape.b + Real(0.5) * shape.c
                                        : point_of(shape, Real(0.3), Real(0.3));
            };
            const Vec3 from = i % 3 == 0 ? any_point() : 5 * in_cube(rng), aim = any_point();
            const Ray ray{from, aim == from ? Vec3{1, 0, 0} : aim - from};
            hits += copies.hit(ray, {0, rt::infinity}).has_value();
            for (const auto* other_world : {&instances, &some}) {
                check_same(copies, *other_world, ray, {0, rt::infinity});
                check_same(copies, *other_world, ray, {Real(0.5), Real(1)});
            }
        }
    }
    CHECK(hits > 40'000);
}

TEST_CASE("an instance of a mesh has the normals, colors and materials of its copy") {
    Mesh one;
    one.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    one.normals = {{0, 0, 1}};
    one.triangles = {{rt::Corner{0, 0, -1}, {1, 0, -1}, {2, -1, -1}}};
    one.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const auto mesh = std::make_shared<const Mesh>(one);
    rt::SceneMeshes all;
    all.add(mesh, {}, 3);
    all.add(mesh, rt::multiply(rt::translation({5, 0, 0}), rt::scaling({2, 1, 4})), 7);
    all.add(mesh, rt::scaling({1, 1, -1}), 9, {}, true);
    REQUIRE(all.size() == 3);
    CHECK(&all.mesh_of(0) == &all.placed()[0]);
    CHECK(&all.mesh_of(2) == &all.placed()[2]);
    const rt::PlacedMesh& second = all.mesh_of(1);
    CHECK(second.triangle(1).material == 7);
    CHECK(second.triangle(1).number == 1);
    CHECK(text(second.triangle(1).shape) == text(Triangle{{5, 0, 0}, {7, 0, 0}, {5, 1, 0}}));
    CHECK(second.corners(1)[1] == rt::Corner{1, 0, -1});
    CHECK(second.normal(second.corners(1)[1]) == Vec3{0, 0, 1});
    // A mirror turns the outside around, and the corners with it.
    const rt::PlacedMesh& mirrored = all.mesh_of(2);
    CHECK(text(mirrored.triangle(2).shape) == text(Triangle{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}));
    CHECK(mirrored.normal(mirrored.corners(2)[2]) == Vec3{0, 0, -1});
    rt::Hit hit;
    hit.light = rt::kept_as_light(2);
    hit.point = {Real(0.25), Real(0.25), 0};
    CHECK(rt::MeshPoint{all, hit}.color() == rt::Color{Real(0.5), Real(0.25), Real(0.25)});
}
