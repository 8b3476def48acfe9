// No ray slips out of a closed mesh: neither where a triangle without area joins its parts, nor
// where light bounces near its edges.

#include <map>
#include <rt/directions.hpp>
#include <rt/leave_surface.hpp>
#include <rt/make_ball.hpp>
#include <rt/mesh_materials.hpp>
#include <rt/mesh_world.hpp>

#include "../box.hpp"
#include "../shapes.hpp"

using namespace checkpoint;
using rt::Corner;
using rt::Hit;
using rt::Interval;
using rt::Mesh;
using rt::SceneTriangle;

namespace {

const Interval ahead{0, rt::infinity};

// A ball, some of whose edges have one, two or three points in the middle that only one of the two
// triangles at the edge ends at. Triangles without area join both sides.
struct Cracked {
    Mesh mesh;
    std::vector<std::array<int, 2>> edges;
};
Cracked cracked_ball(rt::Rng& rng) {
    Cracked made;
    Mesh& mesh = made.mesh;
    mesh = rt::make_ball(1);
    // Coordinates of a few digits, so that the points between them are exact.
    for (Vec3& point : mesh.points)
        point = {std::round(64 * point.x) / 8, std::round(64 * point.y) / 8,
                 std::round(64 * point.z) / 8};
    std::vector<bool> used(mesh.triangles.size());
    const std::size_t count = mesh.triangles.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (used[i] || rng() % 2 == 0) continue;
        used[i] = true;
        const Corner a = mesh.triangles[i][0], b = mesh.triangles[i][1], c = mesh.triangles[i][2];
        made.edges.push_back({a.point, b.point});
        const auto at = [&](const Corner& corner) {
            return mesh.points[static_cast<std::size_t>(corner.point)];
        };
        // The triangle a, b, c becomes some triangles with the corner c; from b back to a run
        // triangles without area, in any order.
        const int parts = 2 + static_cast<int>(rng() % 3);
        std::vector<Corner> along{a};
        for (int k = 1; k < parts; ++k) {
            const Real share = static_cast<Real>(k) / 4;
            mesh.points.push_back(at(a) + share * (at(b) - at(a)));
            const int number = static_cast<int>(mesh.points.size()) - 1;
            along.push_back({number, a.normal, -1});
        }
        along.push_back(b);
        mesh.triangles[i] = {along[0], along[1], c};
        for (std::size_t k = 1; k + 1 < along.size(); ++k)
            mesh.triangles.push_back({along[k], along[k + 1], c});
        // A fan from a, or from b.
        for (std::size_t k = 1; k + 1 < along.size(); ++k)
            if (i % 2 == 0)
                mesh.triangles.push_back({along[0], along[k + 1], along[k]});
            else
                mesh.triangles.push_back({along.back(), along[k], along[k - 1]});
    }
    return made;
}

double volume(const std::vector<SceneTriangle>& triangles) {
    double six = 0;
    for (const SceneTriangle& triangle : triangles) {
        const auto& [a, b, c] = triangle.shape;
        six += dot(exact_vector(a), cross(exact_vector(b), exact_vector(c))).high;
    }
    return six / 6;
}

long leaks(const std::vector<SceneTriangle>& triangles, const Cracked& ball, const rt::Mat4& map,
           rt::Rng rng) {
    const rt::TriangleTree tree = rt::make_wide_tree(triangles);
    long count = 0;
    for (int i = 0; i < 30'000; ++i) {
        const auto& [a, b] = ball.edges[rng() % ball.edges.size()];
        const auto at = [&](int number) {
            return rt::transform_point(map, ball.mesh.points[static_cast<std::size_t>(number)]);
        };
        const Vec3 from = rt::transform_point(map, 3 * in_cube(rng));
        const Vec3 aim = at(a) + rng.uniform() * (at(b) - at(a));
        count += !tree.hit(Ray{from, aim - from}, ahead);
    }
    return count;
}

}  // namespace

TEST_CASE("triangles without area leave no cracks") {
    rt::Rng rng{12, 50};
    long before = 0, flat = 0;
    for (int round = 0; round < 20; ++round) {
        const Cracked ball = cracked_ball(rng);
        const rt::Mat4 map = round == 0
                                 ? rt::Mat4{}
                                 : rt::translation(static_cast<Real>(round) * any_direction(rng));
        rt::SceneMeshes meshes;
        Mesh placed = ball.mesh;
        for (Vec3& point : placed.points) point = rt::transform_point(map, point);
        const auto as_they_are = rt::triangles_of(placed, 7, 0);
        meshes.add(ball.mesh, map, 7);
        meshes.make_copies();
        const rt::PlacedMesh& mesh = meshes.placed()[0];
        const auto all = mesh.triangles();
        REQUIRE(all.size() == as_they_are.size());
        const double whole = volume(as_they_are);
        CHECK(std::abs(volume(all) - whole) <= 1000 * static_cast<double>(rt::epsilon) * whole);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto& [a, b, c] = all[i].shape;
            flat += rt::cross(b - a, c - a) == Vec3{};
            const auto corners = mesh.corners(static_cast<int>(i));
            REQUIRE(mesh.point(corners[0]) == a);
            REQUIRE(mesh.point(corners[1]) == b);
            REQUIRE(mesh.point(corners[2]) == c);
            REQUIRE(all[i].material == 7);
            REQUIRE(all[i].number == static_cast<int>(i));
            for (const Corner& corner : corners) {
                REQUIRE(corner.normal >= 0);
                REQUIRE(corner.normal < static_cast<int>(mesh.mesh().normals.size()));
            }
        }
        before += leaks(as_they_are, ball, map, rng);
        REQUIRE(leaks(all, ball, map, rng) == 0);
    }
    CHECK(before > 20);  // so that this test can fail
    CHECK(flat <= 2);    // rounding may leave one
}

namespace {

// A box, a tetrahedron, or a ball, turned at random.
Mesh any_room(rt::Rng& rng, int kind) {
    Mesh room;
    if (kind == 0) {
        room = make_box();
    } else if (kind == 1) {
        room.points = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
        room.triangles = {{Corner{0}, Corner{2}, Corner{1}},
                          {Corner{0}, Corner{1}, Corner{3}},
                          {Corner{0}, Corner{3}, Corner{2}},
                          {Corner{1}, Corner{2}, Corner{3}}};
    } else {
        room = rt::make_ball(1);
        room.normals.clear();
        for (auto& triangle : room.triangles)
            for (Corner& corner : triangle) corner.normal = -1;
    }
    const Vec3 y = any_direction(rng);
    Vec3 x = any_direction(rng);
    x = x - rt::dot(x, y) * y;
    x = x / std::sqrt(rt::dot(x, x));
    const Vec3 z = rt::cross(x, y);
    for (Vec3& p : room.points) p = p.x * x + p.y * y + p.z * z;
    return room;
}

// How many of this many bounces lead out of a room. Three in four aim at an edge.
template <class Leave>
long bounces_out(const std::vector<SceneTriangle>& room, Vec3 middle, int bounces, rt::Rng& rng,
                 const Leave& leave) {
    const rt::TriangleTree tree = rt::make_wide_tree(room);
    long out = 0;
    Ray ray{middle, any_direction(rng)};
    for (int i = 0; i < bounces; ++i) {
        const auto hit = tree.hit(ray, ahead);
        if (!hit) {
            ++out;
            ray = {middle, any_direction(rng)};
            continue;
        }
        const Vec3 normal = rt::facing_normal(*hit);
        const auto& [a, b, c] = room[rng() % room.size()].shape;
        Vec3 next = a + rng.uniform() * (b - a) - hit->point;
        if (rng() % 4 == 0 ||
            !(rt::dot(next, normal) > real(1e-3) * std::sqrt(rt::dot(next, next))))
            next = normal + real(0.999) * any_direction(rng);
        next = next / std::sqrt(rt::dot(next, next));
        ray = {leave(*hit, next), next};
    }
    return out;
}

}  // namespace

TEST_CASE("light that bounces near the edges of a room stays inside") {
    rt::Rng rng{12, 51};
    long without = 0;
    for (int round = 0; round < 60; ++round) {
        const Real size = any_size(rng, -6, 6);
        const Vec3 middle = round % 4 == 0 ? Vec3{}
                                           : size * any_size(rng, 0, for_this_precision(4, 12)) *
                                                 any_direction(rng);
        Mesh room = any_room(rng, round % 3);
        for (Vec3& point : room.points) point = middle + size * point;
        const auto triangles = rt::triangles_of(room, 0, 0);
        rt::SceneMeshes meshes;
        meshes.add(room, {}, 0);
        using Materials = rt::MaterialList<rt::Lambertian>;
        const rt::MeshMaterials<Materials> materials{{{rt::Lambertian{{1, 1, 1}}}}, &meshes};
        INFO("round " << round << ", size " << size << ", middle " << text(middle));
        REQUIRE(bounces_out(triangles, middle, 50'000, rng, [&](const Hit& hit, Vec3 direction) {
                    return rt::leaving_point(materials, hit, direction);
                }) == 0);
        without += bounces_out(triangles, middle, 5000, rng, rt::leave_surface);
    }
    CHECK(without > 100);  // so that this test can fail
}

TEST_CASE("light leaves a triangle four error bounds off its edges if it has so much room") {
    rt::Rng rng{12, 52};
    long moved = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Triangle shape = placed(plain_triangle(rng), any_size(rng, -9, 9), Vec3{});
        const Real u = any_size(rng, for_this_precision(-8, -17), 0), v = (1 - u) * rng.uniform();
        Hit hit;
        hit.point = point_of(shape, u, v);
        const ExactVec3 normal = exact_unit(exact_normal(shape));
        hit.normal = {static_cast<Real>(normal.x.high), static_cast<Real>(normal.y.high),
                      static_cast<Real>(normal.z.high)};
        const Hit off = rt::off_edges(shape, hit);
        const Real size =
            std::max({rt::max_component(shape.b - shape.a), rt::max_component(shape.c - shape.b),
                      rt::max_component(shape.a - shape.c)});
        const double error = 20 * static_cast<double>(rt::epsilon * size);
        const std::array<Vec3, 3> corners{shape.a, shape.b, shape.c};
        for (std::size_t k = 0; k < 3; ++k) {
            const ExactVec3 edge = exact_unit(exact_vector(corners[(k + 1) % 3] - corners[k]));
            const double inside =
                dot(cross(normal, edge), exact_vector(off.point - corners[k])).high;
            REQUIRE(inside >= 3.9 * error);
        }
        REQUIRE(off_plane(shape, exact_vector(off.point)) <= error);
        if (off.point != hit.point) ++moved;
        REQUIRE(rt::max_component(off.point - hit.point) <= 3000 * rt::epsilon * size);
    }
    CHECK(moved > 1000);
    CHECK(moved < 90'000);
}

namespace {

// A square of two triangles in the plane through `middle` with the axes x and y.
void add_square(std::vector<SceneTriangle>& to, Vec3 middle, Vec3 x, Vec3 y, int material) {
    const std::array<Vec3, 4> corner{middle - x - y, middle + x - y, middle + x + y,
                                     middle - x + y};
    for (const std::size_t k : {1, 2})
        to.push_back({{corner[0], corner[k], corner[k + 1]},
                      material,
                      static_cast<std::int32_t>(to.size())});
}

// A large square, the floor, and a smaller one in a parallel plane, the bottom of a box.
struct Standing {
    std::vector<SceneTriangle> triangles;
    Vec3 up, x, y, middle;  // x and y reach to the sides of the small square
    Real largest;           // coordinate of a corner
};
enum { floor_material, box_material };
Standing box_on_floor(rt::Rng& rng, Real gap) {
    const Vec3 up = any_direction(rng);
    Vec3 x = any_direction(rng);
    x = x - rt::dot(x, up) * up;
    x = x / std::sqrt(rt::dot(x, x));
    const Vec3 y = rt::cross(up, x);
    const Real size = any_size(rng, -6, 6), small = size * any_size(rng, -3, 0);
    const Vec3 at = size * any_size(rng, -3, 1) * any_direction(rng);
    Standing made{{}, up, small * x, small * y, at, 0};
    const bool box_first = rng() % 2 == 0;
    const auto add_box = [&](Real lift) {
        add_square(made.triangles, at + lift * up, made.x, made.y, box_material);
    };
    const auto largest = [&] {
        Real most = 0;
        for (const SceneTriangle& t : made.triangles)
            for (const Vec3 corner : {t.shape.a, t.shape.b, t.shape.c})
                most = std::max(most, rt::max_component(corner));
        return most;
    };
    add_square(made.triangles, at, size * x, size * y, floor_material);
    made.largest = largest();
    if (!box_first) {
        add_box(gap * made.largest);
        return made;
    }
    made.triangles.clear();
    add_box(gap * made.largest);
    add_square(made.triangles, at, size * x, size * y, floor_material);
    return made;
}

// How often a ray meets the wrong one of the two first: from above, from below, and between them.
struct Wrong {
    long above = 0, below = 0, between = 0;
};
Wrong wrong_order(Real gap) {
    rt::Rng rng{12, 53};
    Wrong wrong;
    for (int round = 0; round < 300; ++round) {
        const Standing at = box_on_floor(rng, gap);
        const rt::TriangleTree tree = rt::make_wide_tree(at.triangles);
        for (int i = 0; i < 300; ++i) {
            const bool above = i % 2 == 0;
            // The gap is in proportion to the largest coordinate of the surfaces and of the eye.
            Vec3 from = at.middle + at.largest * rng.uniform() * any_direction(rng);
            const Real most = rt::max_component(from);
            if (most > at.largest) from = at.middle + at.largest / (2 * most) * (from - at.middle);
            if (rt::max_component(from) > at.largest) continue;
            const Real height = rt::dot(from - at.middle, at.up);
            if ((height > 0) != above) from = from - 2 * height * at.up;
            if (rt::max_component(from) > at.largest || std::abs(height) < 4 * gap * at.largest)
                continue;
            const Vec3 aim = at.middle + (above ? gap * at.largest : Real(0)) * at.up +
                             rng.uniform(real(-0.9), real(0.9)) * at.x +
                             rng.uniform(real(-0.9), real(0.9)) * at.y;
            const auto hit = tree.hit(Ray{from, aim - from}, ahead);
            if (!hit) continue;
            const bool meets_box =
                std::any_of(at.triangles.begin(), at.triangles.end(), [&](const SceneTriangle& t) {
                    return t.material == box_material &&
                           rt::hit_triangle(t.shape, Ray{from, aim - from}, ahead);
                });
            if (above && meets_box && hit->material != box_material) ++wrong.above;
            if (!above && hit->material != floor_material) ++wrong.below;
            if (!above || !meets_box) continue;
            // Down from the box's bottom, straight enough to meet the floor.
            const Vec3 down = any_direction(rng) - 2 * at.up;
            const auto next = tree.hit(Ray{rt::leave_surface(*hit, down), down}, ahead);
            if (!next || next->material != floor_material) ++wrong.between;
        }
    }
    return wrong;
}

}  // namespace

TEST_CASE("a gap of a hundred thousandth keeps two surfaces apart even in float") {
    // 84 epsilon of float are a hundred thousandth.
    const Wrong apart = wrong_order(84 * rt::epsilon);
    CHECK(apart.above == 0);
    CHECK(apart.below == 0);
    CHECK(apart.between == 0);
    // So that this test can fail: without a gap, rounding decides.
    const Wrong touching = wrong_order(0);
    CHECK(touching.above > 1000);
    CHECK(touching.below > 1000);
}
