#include <checkpoint.hpp>
#include <random_inputs.hpp>
#include <rt/area_split.hpp>
#include <rt/instance.hpp>
#include <rt/instance_shape.hpp>
#include <rt/leave_surface.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/rng.hpp>
#include <statistics.hpp>

using namespace checkpoint;
using rt::Box;
using rt::Hit;
using rt::Instance;
using rt::Interval;
using rt::Mat4;
using rt::Ray;

namespace {

Vec3 in_cube(rt::Rng& rng) {
    const Real x = rng.uniform(-1, 1), y = rng.uniform(-1, 1), z = rng.uniform(-1, 1);
    return {x, y, z};
}

// Turned, stretched by up to 10^stretch, sheared or mirrored, moved; of any size.
Mat4 any_map(rt::Rng& rng, Real stretch, Real size) {
    const Real turn = rng.uniform(0, 6);
    const auto factor = [&] { return size * any_size(rng, -stretch / 2, stretch / 2); };
    const Vec3 factors{factor(), factor(), rng() % 4 ? factor() : -factor()};
    Mat4 map = multiply(rt::rotation_z(turn),
                        multiply(rt::rotation_x(2 * turn),
                                 multiply(rt::scaling(factors), rt::rotation_y(3 * turn))));
    const Vec3 to = 3 * size * in_cube(rng);
    map(0, 3) = to.x;
    map(1, 3) = to.y;
    map(2, 3) = to.z;
    return map;
}

// A ray from outside or inside toward some point of the ellipsoid, whose direction has any length.
Ray ray_at(const Instance& instance, rt::Rng& rng, Real size) {
    const Vec3 aim = transform_point(instance.object_to_world, Real(0.9) * in_cube(rng));
    const Vec3 from = rng() % 4 ? aim + 9 * size * any_direction(rng)
                                : transform_point(instance.object_to_world,
                                                  rng.uniform(0, Real(0.9)) * any_direction(rng));
    return {from, any_size(rng, -2, 2) * (aim - from)};
}

std::string text(const Mat4& m) {
    std::string rows;
    for (int row = 0; row < 3; ++row) {
        rows += "\n  ";
        for (int column = 0; column < 4; ++column) rows += checkpoint::text(m(row, column)) + "  ";
    }
    return rows;
}
std::string text(const Ray& ray) {
    return "a ray from " + checkpoint::text(ray.origin) + " along " +
           checkpoint::text(ray.direction);
}
std::string text(const Box& box) {
    return "the box from " + checkpoint::text(box.low) + " to " + checkpoint::text(box.high);
}
std::string text(const std::optional<Real>& t) {
    return t ? "t = " + checkpoint::text(*t) : "no hit";
}

// Whether |a - b| is at most this many times the rounding of numbers of this size.
bool is_near(Vec3 a, Vec3 b, Real size, Real times = 64) {
    return max_component(a - b) <= times * rt::epsilon * size;
}

// Twice as long along x, half as long along z, around (5, 0, 0).
const Mat4 egg{{{{2, 0, 0, 5}, {0, 1, 0, 0}, {0, 0, Real(0.5), 0}, {0, 0, 0, 1}}}};

// How large the numbers become on the way through a map and back.
Real terms(const Mat4& m, Vec3 v) {
    Real largest = 0;
    for (int row = 0; row < 3; ++row)
        largest = std::max(largest, std::abs(m(row, 0) * v.x) + std::abs(m(row, 1) * v.y) +
                                        std::abs(m(row, 2) * v.z) + std::abs(m(row, 3)));
    return largest;
}

}  // namespace

TEST_CASE("08.5 the ray is transformed to the object's space", "[08.5]") {
    const Instance instance = rt::make_instance(egg, 0);
    const Ray ray = rt::object_ray(instance, {{9, 2, 1}, {-4, 0, 3}});
    INFO("an ellipsoid around (5, 0, 0) with the semi-axes 2, 1 and 0.5 along x, y and z");
    {
        HINT((Vec3{2, 2, 2}), ray.origin,
             "the origin (9, 2, 1) is a point: use transform_point with world_to_object, which "
             "subtracts (5, 0, 0) and then divides by 2, 1 and 0.5");
        CHECK(ray.origin == Vec3{2, 2, 2});
    }
    HINT((Vec3{-2, 0, 6}), ray.direction,
         "the direction (-4, 0, 3) has no position: use transform_vector, and keep the length that "
         "it returns");
    CHECK(ray.direction == Vec3{-2, 0, 6});
}

TEST_CASE("08.5 a ray hits an ellipsoid at the correct t", "[08.5]") {
    const Instance instance = rt::make_instance(egg, 0);
    const auto check = [&](const Ray& ray, std::optional<Real> expected, const char* hint,
                           Interval within = {}) {
        const auto t = rt::hit_instance(instance, ray, within);
        const bool same = t.has_value() == expected.has_value() &&
                          (!t || std::abs(*t - *expected) <= 8 * rt::epsilon);
        INFO(text(ray) << ", and an ellipsoid around (5, 0, 0) with the semi-axes 2, 1 and 0.5 "
                          "along x, y and z: " EXPECTED
                       << text(expected) << ", " ACTUAL << text(t) << ".\nHint: " << hint);
        CHECK(same);
    };
    check({{0, 0, 0}, {1, 0, 0}}, Real(3), "the ellipsoid begins at x = 3");
    check({{0, 0, 0}, {2, 0, 0}}, Real(1.5),
          "a direction twice as long halves t: do not normalize the ray's direction in the "
          "object's space");
    check({{5, 0, 9}, {0, 0, -1}}, Real(8.5), "the ellipsoid ends at z = 0.5");
    check({{5, 0, 0}, {0, 1, 0}}, Real(1), "a ray from inside meets the ellipsoid, too");
    check({{5, 2, 0}, {1, 0, 0}}, {}, "the ellipsoid ends at y = 1, and the ray passes at y = 2");
    check({{0, 0, 0}, {1, 0, 0}}, Real(7), "the near side lies before the interval",
          {4, rt::infinity});
    check({{0, 0, 0}, {1, 0, 0}}, {}, "both sides lie beyond the interval", {0, 2});
    check({{9, 0, 0}, {1, 0, 0}}, Real(-6), "an interval may begin below 0", {-9, 0});
}

TEST_CASE("08.5 point and normal are in world space", "[08.5]") {
    const Instance instance = rt::make_instance(egg, 7);
    // In the object's space the hit is at (0.6, 0.8, 0), which is its normal there.
    const Ray ray{{Real(6.2), 9, 0}, {0, -2, 0}};
    const Hit hit = rt::surface_hit(instance, ray, Real(4.1));
    INFO(text(ray) << ", which meets the ellipsoid around (5, 0, 0) at t = 4.1");
    {
        HINT((Vec3{Real(6.2), Real(0.8), 0}), hit.point,
             "transform the point of the unit sphere to world space: transform_point with "
             "object_to_world");
        CHECK(is_near(hit.point, {Real(6.2), Real(0.8), 0}, 7));
    }
    {
        const Vec3 expected = rt::normalize(Vec3{Real(0.3), Real(0.8), 0});
        HINT(expected, hit.normal,
             "normals are not transformed like points: use transform_normal with world_to_object, "
             "then normalize. (0.6, 0.8, 0) becomes (0.6 / 2, 0.8, 0)");
        CHECK(is_near(hit.normal, expected, 1));
    }
    {
        INFO("t must be the given t of the ray in world space: " EXPECTED "4.1, " ACTUAL
             << checkpoint::text(hit.t));
        CHECK(hit.t == Real(4.1));
    }
    {
        INFO("the ray came from outside: front must be true");
        CHECK(hit.front);
    }
    {
        INFO("point_error must be instance_error(instance, point), with the point in the world");
        CHECK(hit.point_error == rt::instance_error(instance, hit.point));
    }
    INFO("the material must be the instance's: 7");
    CHECK(hit.material == 7);
    const Hit inside = rt::surface_hit(instance, {{5, 0, 0}, {0, 1, 0}}, 1);
    INFO(
        "a ray from the center to (5, 1, 0): it comes from inside, so front must be false, and "
        "the normal points outward");
    CHECK_FALSE(inside.front);
    CHECK(is_near(inside.normal, {0, 1, 0}, 1));
}

TEST_CASE("08.5 a matrix that moves and scales uniformly gives a sphere", "[08.5]") {
    rt::Rng rng{85, 1};
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const rt::Sphere sphere{3 * in_cube(rng), rng.uniform(Real(0.3), 2)};
        const Mat4 map =
            multiply(rt::translation(sphere.center),
                     multiply(rt::rotation_y(rng.uniform(0, 6)),
                              rt::scaling({sphere.radius, sphere.radius, sphere.radius})));
        const Instance instance = rt::make_instance(map, 3);
        const Ray ray = ray_at(instance, rng, sphere.radius);
        const auto t = rt::hit_instance(instance, ray, {}), expected = hit_sphere(sphere, ray, {});
        if (!expected) continue;
        ++hits;
        const Real size = max_component(ray.origin) + max_component(sphere.center) + 9;
        const Real speed = rt::length(ray.direction);
        INFO(text(ray) << " and the sphere around " << text(sphere.center) << " of radius "
                       << text(sphere.radius) << " as an instance");
        const auto fits = [&] {
            return t && std::abs(*t - *expected) * speed <= 3000 * rt::epsilon * size;
        };
        // Where the ray nearly misses, both are nothing but rounding.
        const Hit there = rt::surface_hit(sphere, ray, *expected);
        if (std::abs(dot(ray.direction, there.normal)) < Real(0.1) * speed) continue;
        if (!fits()) REQUIRE(text(t) == text(expected));
        const Hit hit = rt::surface_hit(instance, ray, *t);
        if (!is_near(hit.point, there.point, size, 3000))
            REQUIRE(checkpoint::text(hit.point) == checkpoint::text(there.point));
        if (!is_near(hit.normal, there.normal, size / sphere.radius, 3000))
            REQUIRE(checkpoint::text(hit.normal) == checkpoint::text(there.normal));
        REQUIRE(hit.front == there.front);
    }
    CHECK(hits > 1000);
}

TEST_CASE("08.5 hits lie on the surface and the normal is perpendicular to it", "[08.5][hard]") {
    rt::Rng rng{85, 2};
    int hits = 0;
    for (int i = 0; i < 6000; ++i) {
        const Real size = any_size(rng, -6, 6);
        const int material = 70'000 + i;
        const Instance instance = rt::make_instance(any_map(rng, 2, size), material);
        const Real far = i % 4 ? Real(1) : for_this_precision<Real>(100, 1e6);
        const Ray ray = ray_at(instance, rng, far * size);
        const Interval within = i % 3 ? Interval{} : Interval{-rt::infinity, rt::infinity};
        const auto t = rt::hit_instance(instance, ray, within);
        if (!t) continue;
        ++hits;
        const Hit hit = rt::surface_hit(instance, ray, *t);
        INFO("the unit sphere, mapped by" << text(instance.object_to_world) << "\nand " << text(ray)
                                          << "; " << text(t));
        const Vec3 there = transform_point(instance.world_to_object, hit.point);
        const Real rounding = rt::epsilon * (8 + 8 * terms(instance.world_to_object, hit.point));
        {
            INFO("in the object's space, the point "
                 << text(hit.point) << " is " << text(there) << ", at the distance "
                 << text(rt::length(there)) << " from the origin; " EXPECTED "1");
            REQUIRE(std::abs(rt::length(there) - 1) <= 4 * rounding);
        }
        // The two directions perpendicular to `there`, moved to the world, are tangent to the
        // surface: the normal is perpendicular to them.
        const rt::Basis basis = rt::orthonormal_basis(rt::normalize(there));
        for (const Vec3 across : {basis.u, basis.v}) {
            const Vec3 along = transform_vector(instance.object_to_world, across);
            INFO("the normal " << text(hit.normal) << " and a direction along the surface, "
                               << text(along) << ", must have the dot product 0");
            REQUIRE(std::abs(dot(hit.normal, along)) <=
                    100 * (rounding + rt::epsilon) * rt::length(along));
        }
        const Vec3 middle{instance.object_to_world(0, 3), instance.object_to_world(1, 3),
                          instance.object_to_world(2, 3)};
        INFO("the normal " << text(hit.normal) << " at the point " << text(hit.point)
                           << " must have length 1 and point outward, away from the center "
                           << text(middle));
        REQUIRE(std::abs(rt::length(hit.normal) - 1) <= 8 * rt::epsilon);
        REQUIRE(dot(hit.normal, hit.point - middle) > 0);
        const Real slope = dot(ray.direction, hit.normal) / rt::length(ray.direction);
        INFO("front must be true where the ray runs against the normal");
        if (std::abs(slope) > 100 * rt::epsilon) REQUIRE(hit.front == (slope < 0));
        REQUIRE(hit.t == *t);
        REQUIRE(hit.material == material);
        INFO("point_error must be instance_error of the point in the world");
        REQUIRE(hit.point_error == rt::instance_error(instance, hit.point));
    }
    CHECK(hits > 3000);
}

TEST_CASE("08.5 a ray that leaves the surface does not meet it again", "[08.5][hard]") {
    rt::Rng rng{85, 3};
    long again = 0, all = 0;
    std::string first;
    for (int i = 0; i < 20'000; ++i) {
        const Real size = any_size(rng, -6, 6);
        const Instance instance = rt::make_instance(any_map(rng, 2, size), 0);
        const Ray ray = ray_at(instance, rng, size);
        const auto t = rt::hit_instance(instance, ray, {0, rt::infinity});
        if (!t) continue;
        const Hit hit = rt::surface_hit(instance, ray, *t);
        // Outward, at any angle: an ellipsoid has no hollow, so nothing of it lies ahead.
        Vec3 away = any_direction(rng);
        if (i % 2) away = away + rng.uniform(0, 100) * (away - dot(away, hit.normal) * hit.normal);
        if (dot(away, hit.normal) < 0) away = -away;
        if (dot(away, hit.normal) < Real(1e-3) * rt::length(away)) continue;
        ++all;
        const Ray leaving{rt::leave_surface(hit, away), away};
        if (!rt::hit_instance(instance, leaving, {0, rt::infinity})) continue;
        if (again++ == 0) first = text(instance.object_to_world) + "\n" + text(leaving);
    }
    INFO(again << " of " << all
               << " rays that leave the surface outward meet it again. The first of them: " << first
               << "\nHint: point_error is instance_error(instance, point), with the point in the "
                  "world");
    CHECK(all > 5000);
    CHECK(again == 0);
}

TEST_CASE("08.5 the box extends from the center by the row lengths plus the margin", "[08.5]") {
    const auto check = [](const Mat4& map, Vec3 half, const char* hint) {
        const Instance instance = rt::make_instance(map, 0);
        const Vec3 center{map(0, 3), map(1, 3), map(2, 3)};
        const Real margin = margin_factor(instance) * rt::hit_margin *
                            (max_component(center) + max_component(half));
        const Vec3 grown = half + Vec3{margin, margin, margin};
        const Box expected{center - grown, center + grown}, box = rt::bounds_of(instance);
        const Real size = max_component(center) + max_component(half);
        INFO("the unit sphere, mapped by"
             << text(map) << "\nreaches " << text(half) << " from its center, and with the margin "
             << text(grown) << ": " EXPECTED << text(expected) << ", " ACTUAL << text(box)
             << ".\nHint: " << hint);
        CHECK(is_near(box.low, expected.low, size, 8));
        CHECK(is_near(box.high, expected.high, size, 8));
    };
    check(egg, {2, 1, Real(0.5)},
          "the center is the last column, and the lengths of the rows say how far the ellipsoid "
          "reaches");
    check(
        multiply(rt::translation({1, 2, 3}),
                 multiply(rt::rotation_z(rt::pi / 4), rt::scaling({4, 3, 1}))),
        {Real(std::sqrt(12.5)), Real(std::sqrt(12.5)), 1},
        "the reach along x is the length of the first row, sqrt(8 + 4.5), not of the first column");
    check(multiply(rt::rotation_y(rt::pi / 4), rt::scaling({4, 3, 1})),
          {Real(std::sqrt(8.5)), 3, Real(std::sqrt(8.5))},
          "the reach along z is the length of the third row, sqrt(8 + 0.5)");
    check(rt::translation({-100, 0, 0}), {1, 1, 1},
          "take the absolute values: max_component gives the largest absolute coordinate of the "
          "center, and that of the reach");
}

TEST_CASE("08.5 boxes are tight and contain their ellipsoids", "[08.5][hard]") {
    rt::Rng rng{85, 4};
    for (int i = 0; i < 3000; ++i) {
        const Real size = any_size(rng, -6, 6);
        const Instance instance = rt::make_instance(any_map(rng, 3, size), 0);
        const Mat4& m = instance.object_to_world;
        const Vec3 center{m(0, 3), m(1, 3), m(2, 3)};
        // The farthest point along x is the one whose normal is (1, 0, 0), and so on.
        Vec3 half;
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 row = rt::normalize(Vec3{m(axis, 0), m(axis, 1), m(axis, 2)});
            const Real reach = along(transform_vector(m, row), axis);
            (axis == 0 ? half.x : axis == 1 ? half.y : half.z) = reach;
        }
        const Real margin = margin_factor(instance) * rt::hit_margin *
                            (max_component(center) + max_component(half));
        const Vec3 grown = half + Vec3{margin, margin, margin};
        const Real largest = max_component(center) + max_component(half);
        const Box expected{center - grown, center + grown}, box = rt::bounds_of(instance);
        INFO("the unit sphere, mapped by" << text(m) << "\n" EXPECTED << text(expected)
                                          << ", " ACTUAL << text(box));
        REQUIRE(is_near(box.low, expected.low, largest, 16));
        REQUIRE(is_near(box.high, expected.high, largest, 16));
    }
}

TEST_CASE("08.5 a tree of instances finds the same hits as testing all of them", "[08.5][hard]") {
    rt::Rng rng{85, 5};
    int hits = 0;
    for (const int count : {0, 1, 2, 7, 60}) {
        std::vector<Instance> instances;
        for (int i = 0; i < count; ++i)
            instances.push_back(rt::make_instance(any_map(rng, 2, 1), i));
        const auto tree = rt::make_tree(instances, rt::AreaSplit{});
        for (int i = 0; i < 1500; ++i) {
            const Ray ray{9 * any_direction(rng), any_size(rng, -3, 3) * any_direction(rng)};
            Interval within;
            int nearest = -1;
            for (const Instance& instance : instances)
                if (const auto t = rt::hit_instance(instance, ray, within)) {
                    within.max = *t;
                    nearest = instance.material;
                }
            const auto hit = tree.hit(ray, {});
            const int found = hit ? hit->material : -1;
            hits += found >= 0;
            if (found == nearest && (!hit || hit->t == within.max)) continue;
            INFO(count << " ellipsoids and " << text(ray) << ": the nearest is number " << nearest
                       << " at t = " << text(within.max)
                       << ", but the search in a tree finds number " << found
                       << " (-1 is none).\nHint: the box must contain the whole ellipsoid");
            REQUIRE(found == nearest);
            REQUIRE(hit->t == within.max);
        }
    }
    CHECK(hits > 500);
}
