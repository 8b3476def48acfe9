// triangle_leaks [MILLIONS [BELTS]]: how many of this many million rays from inside leave a closed
// mesh, by the star of 12.1 and by Möller and Trumbore's plain test. Half of the rays go to points
// of edges, a quarter to corners, and the rest anywhere. Then, how many of a million bounces toward
// edges leave a box far from the origin. Run by hand: 1000 million take some minutes.

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <rt/leave_surface.hpp>
#include <rt/off_edges.hpp>
#include <rt/rng.hpp>
#include <rt/shape_tree.hpp>
#include <rt/triangle_leaf.hpp>
#include <rt/wide_builder.hpp>
#include <thread>
#include <vector>

#include "../box.hpp"
#include "triangle_ways.hpp"

using namespace rt;
using triangles::Plain;

namespace plain {

// A triangle for chapter 07's tree that is hit by the plain test.
struct Shape {
    SceneTriangle triangle;
};
Box bounds_of(const Shape& shape) {
    return rt::bounds_of(shape.triangle);
}
std::optional<Real> hit_shape(const Shape& shape, const Ray& ray, Interval within) {
    return Plain{shape.triangle.shape}.hit(ray, within);
}

}  // namespace plain

namespace {

// A ray from inside of the ball.
Ray any_ray(const std::vector<SceneTriangle>& ball, Rng& random) {
    const auto in_cube = [&] {
        const Real x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
        return Vec3{x, y, z};
    };
    const Vec3 from = Real(0.4) * in_cube();
    const auto& [a, b, c] = ball[random() % ball.size()].shape;
    const unsigned kind = random() % 4;
    const Real along = random.uniform();
    const Vec3 aim = kind < 2 ? a + along * (b - a) : kind == 2 ? c : in_cube();
    return {from, aim - from};
}

// Counts the rays that leave, on all cores; meets(ray) says whether a ray is stopped.
template <class Meets>
long count_leaks(const std::vector<SceneTriangle>& ball, long millions, const Meets& meets) {
    std::atomic<long> next = 0, leaks = 0;
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
        threads.emplace_back([&] {
            for (long part; (part = next++) < millions;) {
                Rng random{12, static_cast<std::uint64_t>(part)};
                long mine = 0;
                for (int k = 0; k < 1'000'000; ++k) mine += !meets(any_ray(ball, random));
                leaks += mine;
            }
        });
    for (std::thread& thread : threads) thread.join();
    return leaks;
}

// A box with sides of length 1, turned, with its middle at (`far`, 0, 0).
std::vector<SceneTriangle> box(Real far) {
    const Vec3 x{Real(0.48), Real(0.6), Real(0.64)}, y{Real(0.64), Real(-0.8), Real(0.27)},
        z = normalize(cross(x, y));
    const Vec3 y_too = normalize(cross(z, x));
    Mesh mesh = checkpoint::make_box();
    for (Vec3& p : mesh.points) p = Vec3{far, 0, 0} + p.x * x + p.y * y_too + p.z * z;
    return triangles_of(mesh, 0, 0);
}

// Counts the bounces that lead out of the box, of a million; start(hit) is the hit that the next
// ray leaves from.
template <class Start>
long count_bounces_out(Real far, const Start& start) {
    const auto walls = box(far);
    const TriangleTree tree = make_wide_tree(walls);
    Rng random{12, 1};
    const auto any = [&] {
        const Real x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
        return Vec3{x, y, z};
    };
    long out = 0;
    Ray ray{{far, 0, 0}, any()};
    for (int i = 0; i < 1'000'000; ++i) {
        const std::optional<Hit> hit = tree.hit(ray, {0, infinity});
        if (!hit) {
            ++out;
            ray = {{far, 0, 0}, any()};
            continue;
        }
        const Vec3 up = facing_normal(*hit);
        const auto& [a, b, c] = walls[random() % walls.size()].shape;
        Vec3 next = normalize(a + random.uniform() * (b - a) - hit->point);
        // What grazes the wall is no bounce.
        if (!(dot(next, up) > Real(0.001))) next = normalize(up + Real(0.5) * any());
        ray = {leave_surface(start(walls[static_cast<std::size_t>(hit->shape)].shape, *hit), next),
               next};
    }
    return out;
}

}  // namespace

int main(int argc, char** argv) {
    const long millions = argc > 1 ? std::atol(argv[1]) : 10;
    const auto ball =
        triangles_of(triangles::closed_ball(argc > 2 ? std::atoi(argv[2]) : 64), 0, 0);
    const TriangleTree tree = make_wide_tree(ball);
    std::vector<plain::Shape> shapes;
    for (const SceneTriangle& triangle : ball) shapes.push_back({triangle});
    const auto plain_tree = make_wide_tree(shapes);
    std::printf("%zu triangles, %ld million rays, %s\n", ball.size(), millions,
                sizeof(Real) == 4 ? "float" : "double");
    std::printf("watertight: %ld leaks\n", count_leaks(ball, millions, [&](const Ray& ray) {
                    return tree.search(ray, {}).nearest >= 0;
                }));
    std::fflush(stdout);
    const long fewer = std::min(millions, 10L);
    std::printf(
        "plain: %ld leaks of %ld million rays\n",
        count_leaks(ball, fewer,
                    [&](const Ray& ray) { return plain_tree.search(ray, {}).nearest >= 0; }),
        fewer);
    for (const Real far : {Real(0), Real(1000), Real(10'000), Real(50'000)})
        std::printf("a box at %g: of a million bounces, %ld leave it; off the edges, %ld\n",
                    static_cast<double>(far),
                    count_bounces_out(far, [](const Triangle&, const Hit& hit) { return hit; }),
                    count_bounces_out(far, [](const Triangle& wall, const Hit& hit) {
                        return off_edges(wall, hit);
                    }));
}
