#include <checkpoint.hpp>
#include <rt/lens_ray.hpp>
#include <rt/make_camera.hpp>
#include <rt/primary_ray.hpp>
#include <rt/rng.hpp>
#include <statistics.hpp>

#include "places.hpp"

using namespace checkpoint;
using rt::Camera;
using rt::Lens;
using rt::Ray;
using rt::Vec2;

namespace {

Camera camera_at(Vec3 from, Vec3 along, Real scale = 1) {
    rt::View view;
    view.from = scale * from;
    view.at = scale * (from + along);
    view.vertical_fov = rt::radians(40);
    return rt::make_camera(view, 160, 90);
}

const Vec2 middle{Real(0.5), Real(0.5)};

// Rounding of a direction of length 1: the point on the viewport, three products and their sums,
// normalize. The largest rounding of any orderly computation is a few times smaller.
constexpr Real direction_error = rt::rounding_bound(40);

void check_close(Vec3 computed, Vec3 expected, Real allowed, const char* hint) {
    const bool is_close = max_component(computed - expected) <= allowed;
    HINT(expected, computed, hint);
    CHECK(is_close);
}

// Any camera, lens and pixel. The lens is small or large compared with the distance of focus.
struct Case {
    Camera camera;
    Lens lens;
    int column, row;
    Vec2 offset;
};
Case any_case(rt::Rng& rng, Real size, Real smallest, Real largest) {
    rt::View view;
    if (rng() % 2) view.from = 3 * size * any_direction(rng);
    view.at = view.from + size * any_size(rng, -1, 1) * any_direction(rng);
    view.up = any_direction(rng);
    view.vertical_fov = rng.uniform(Real(0.1), Real(2.5));
    const int width = 1 + static_cast<int>(rng() % 300), height = 1 + static_cast<int>(rng() % 300);
    const Real focus = size * any_size(rng, -2, 2);
    return {rt::make_camera(view, width, height),
            {focus * any_size(rng, smallest, largest), focus},
            static_cast<int>(rng() % static_cast<unsigned>(width)),
            static_cast<int>(rng() % static_cast<unsigned>(height)),
            {rng.uniform(), rng.uniform()}};
}
Ray ray_of(const Case& any, Vec2 place) {
    return rt::lens_ray(any.camera, any.lens, any.column, any.row, any.offset, place);
}
std::string text_of(const Case& any) {
    return "aperture " + text(any.lens.aperture) + ", focus_distance " +
           text(any.lens.focus_distance) + ", the eye at " + text(any.camera.eye) + ", pixel " +
           std::to_string(any.column) + ", " + std::to_string(any.row) + " of " +
           std::to_string(any.camera.width) + " x " + std::to_string(any.camera.height) +
           ", offset " + text(any.offset.x) + ", " + text(any.offset.y);
}

// Where on the lens a ray starts: to the right and up, in radii of the lens.
Vec2 on_lens(const Case& any, Vec2 place) {
    const Vec3 off = ray_of(any, place).origin - any.camera.eye;
    const Real radius = any.lens.aperture / 2;
    return {rt::dot(off, any.camera.basis.u) / radius, rt::dot(off, any.camera.basis.v) / radius};
}

// The sample points on the lens. Each is as far from the middle as its share of the area says, and
// turned, to one side or the other, by its share of a turn from where place.y = 0 is.
void check_places(const Case& any, rt::Rng& rng) {
    const Real rounding = rt::rounding_bound(60) +
                          8 * rt::epsilon * max_component(any.camera.eye) / any.lens.aperture;
    if (rounding > Real(0.01)) return;
    const auto turned_by = [&](Real x, Real turn, int side) {
        const Vec2 from = on_lens(any, {x, 0});
        const Real angle = static_cast<Real>(side) * 2 * rt::pi * turn;
        const Real c = std::cos(angle), s = std::sin(angle);
        return Vec2{c * from.x - s * from.y, s * from.x + c * from.y};
    };
    const auto apart = [](Vec2 a, Vec2 b) {
        return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
    };
    const Vec2 probe = on_lens(any, {Real(0.9), Real(0.125)});
    const int side = apart(probe, turned_by(Real(0.9), Real(0.125), 1)) <
                             apart(probe, turned_by(Real(0.9), Real(0.125), -1))
                         ? 1
                         : -1;
    for (int i = 0; i < 12; ++i) {
        const Real last = 1 - rt::epsilon / 2;
        const Real x = i == 0 ? last : i % 3 == 1 ? any_size(rng, -9, 0) * last : rng.uniform();
        const Real y = i == 1 ? last : rng.uniform();
        const Vec2 at = on_lens(any, {x, y}), expected = turned_by(x, y, side);
        const Real away = std::sqrt(at.x * at.x + at.y * at.y);
        INFO(text_of(any) << ", place " << text(x) << ", " << text(y));
        {
            INFO(
                "the distance of the ray's origin from the eye, in halves of the "
                "aperture: " EXPECTED
                << text(std::sqrt(x)) << ", " ACTUAL << text(away)
                << ".\nHint: the radius is the square root of place.x, because place.x is the "
                   "fraction of the lens's area within this radius");
            const bool is_close = std::abs(away - std::sqrt(x)) <= rounding;
            REQUIRE(is_close);
        }
        const auto pair = [](Vec2 v) { return '(' + text(v.x) + ", " + text(v.y) + ')'; };
        INFO(
            "the ray's origin relative to the eye, along u and v, in halves of the aperture (your "
            "code gives "
            << pair(on_lens(any, {x, 0})) << " for place.y = 0): " EXPECTED << pair(expected)
            << ", " ACTUAL << pair(at)
            << ".\nHint: place.y is the fraction of a turn, and a full turn is 2 pi");
        const bool is_close = apart(at, expected) <= rounding;
        REQUIRE(is_close);
    }
}

// The direction, from where the ray starts to the point in focus.
void check_direction(const Case& any, Vec2 place) {
    const Ray ray = ray_of(any, place);
    const Vec2 p = rt::pixel_to_viewport(any.camera, any.column, any.row, any.offset);
    const Vec2 at = on_lens(any, place);
    const Real share = any.lens.aperture / 2 / any.lens.focus_distance;
    const Vec3 expected =
        rt::normalize(any.camera.basis.to_world({p.x - share * at.x, p.y - share * at.y, -1}));
    INFO(text_of(any) << ", place " << text(place.x) << ", " << text(place.y));
    // If the lens is large compared with the distance, the rounding of the eye's
    // position counts more.
    const Real eye = max_component(any.camera.eye) / any.lens.focus_distance;
    check_close(ray.direction, expected, direction_error + 8 * rt::epsilon * eye,
                "the ray from (x, y) on the lens has the direction (p.x - x / f, p.y - y / f, -1), "
                "turned by the camera's basis and normalized; p is the point of the viewport at "
                "this offset in the pixel");
}

// The point of a ray in the plane of focus.
Vec3 in_focus(const Camera& camera, const Lens& lens, const Ray& ray) {
    const Vec3 ahead = -camera.basis.w;
    const Real away = lens.focus_distance - rt::dot(ray.origin - camera.eye, ahead);
    return ray.origin + away / rt::dot(ray.direction, ahead) * ray.direction;
}

const Camera usual = camera_at({1, 2, 3}, {Real(-0.6), Real(-0.2), -1});

// How far a vector leads to the camera's right and up.
std::string in_camera(Vec3 v) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "(%.4g, %.4g)",
                  static_cast<double>(rt::dot(v, usual.basis.u)),
                  static_cast<double>(rt::dot(v, usual.basis.v)));
    return buffer;
}

}  // namespace

TEST_CASE("08.2 the ray from the lens's center is the pinhole camera's ray", "[08.2]") {
    const Lens lens{Real(0.5), 4};
    for (const int column : {0, 31, 80, 159})
        for (const int row : {0, 45, 89}) {
            const Ray expected = rt::primary_ray(usual, column, row, middle);
            for (const Real turn : {Real(0), Real(0.3)}) {
                const Ray ray = rt::lens_ray(usual, lens, column, row, middle, {0, turn});
                check_close(ray.origin, expected.origin, 4 * rt::epsilon,
                            "place.x = 0 is the center of the lens, where the eye is");
                check_close(ray.direction, expected.direction, direction_error,
                            "the ray from the center of the lens has the same direction as through "
                            "a pinhole");
            }
        }
}

TEST_CASE("08.2 all rays of a pixel meet in the plane of focus", "[08.2]") {
    for (const Real focus : {Real(0.7), Real(4), Real(25)}) {
        const Lens lens{Real(0.6), focus};
        for (const int column : {0, 97, 159})
            for (const int row : {3, 77}) {
                const Ray from_eye = rt::primary_ray(usual, column, row, middle);
                const Vec3 pinhole = from_eye.direction, expected = in_focus(usual, lens, from_eye);
                const Real scale = max_component(expected) + max_component(usual.eye) + focus;
                for_each_place(6, [&](Vec2 place) {
                    const Ray ray = rt::lens_ray(usual, lens, column, row, middle, place);
                    INFO("focus_distance " << text(focus) << ", pixel " << column << ", " << row
                                           << ", place " << text(place.x) << ", " << text(place.y));
                    {
                        INFO("the direction has length " << text(rt::length(ray.direction))
                                                         << "; " EXPECTED "1: normalize it");
                        if (!(std::abs(rt::length(ray.direction) - 1) <= direction_error))
                            REQUIRE(text(rt::length(ray.direction)) == "1");
                    }
                    const Vec3 off = ray.origin - usual.eye;
                    {
                        INFO(
                            "the ray starts at the eye, as if there were no lens.\nHint: the "
                            "origin moves along u and v, to the sample point on the lens");
                        if (off == Vec3{}) REQUIRE(text(ray.origin) != text(usual.eye));
                    }
                    INFO("to the right and up, as the camera sees it, the ray starts at "
                         << in_camera(off) << " and moves by "
                         << in_camera(ray.direction / -rt::dot(ray.direction, usual.basis.w))
                         << " for each unit ahead; the ray through a pinhole moves by "
                         << in_camera(pinhole / -rt::dot(pinhole, usual.basis.w)));
                    check_close(in_focus(usual, lens, ray), expected,
                                rt::rounding_bound(80) * scale,
                                "the point in focus is where the ray through a pinhole meets the "
                                "plane at focus_distance along the direction of view; a ray that "
                                "starts to the right of the eye must turn left: p - x / f");
                });
            }
    }
}

TEST_CASE("08.2 the lens is a disk that faces the direction of view", "[08.2]") {
    const Lens lens{Real(0.8), 3};
    Vec3 sum;
    Real farthest = 0;
    for_each_place(16, [&](Vec2 place) {
        const Vec3 off = rt::lens_ray(usual, lens, 20, 70, middle, place).origin - usual.eye;
        sum += off;
        farthest = std::max(farthest, rt::length(off));
        INFO("the vector from the eye to the ray's origin is " << text(off));
        {
            const Real tilt = std::abs(rt::dot(off, usual.basis.w));
            INFO("the origin lies "
                 << text(tilt) << " in front of the lens or behind it: move it along u and v only");
            if (tilt > rt::rounding_bound(30) * 4) CHECK(text(tilt) == "0");
        }
        INFO(
            "Hint: the aperture is the diameter: no sample point is farther from the eye than half "
            "of it");
        CHECK(rt::length(off) < lens.aperture * Real(0.501));
    });
    {
        INFO("the farthest of 256 sample points should be almost 0.4 away from the eye");
        CHECK(farthest > Real(0.39));
    }
    INFO("the distance from the eye to the mean of the sample points is "
         << text(rt::length(sum / 256))
         << ".\nHint: the sample points lie all the way around the eye: a full turn is 2 pi");
    CHECK(rt::length(sum / 256) < Real(0.001));
}

TEST_CASE("08.2 the sample points are spread evenly over the lens", "[08.2]") {
    rt::Rng rng{82, 1};
    check_places({usual, {2, 3}, 80, 45, middle}, rng);
    for (int i = 0; i < 40; ++i) check_places(any_case(rng, 1, -2, 0), rng);
}

TEST_CASE("08.2 each offset in a pixel has its own rays", "[08.2]") {
    rt::Rng rng{82, 2};
    for (int i = 0; i < 400; ++i) {
        const Case any = any_case(rng, 1, -2, 0);
        const Ray ray = ray_of(any, {0, rng.uniform()});
        const Ray pinhole = rt::primary_ray(any.camera, any.column, any.row, any.offset);
        {
            INFO(text_of(any));
            check_close(ray.direction, pinhole.direction, direction_error,
                        "from the center of the lens, place.x = 0, the direction is that of "
                        "primary_ray for this pixel and offset");
        }
        check_direction(any, {rng.uniform(), rng.uniform()});
    }
}

TEST_CASE("08.2 rays are accurate for lenses of all sizes and focus distances", "[08.2][hard]") {
    rt::Rng rng{82, 3};
    const Real smallest = for_this_precision(Real(-4), Real(-11));
    // The square of an aperture must not underflow.
    const Real most = for_this_precision(Real(9), Real(15));
    for (int i = 0; i < 400; ++i) {
        const Case any = any_case(rng, any_size(rng, -most, most), smallest, 1);
        check_direction(any, {rng.uniform(), rng.uniform()});
        check_direction(any, {any_size(rng, smallest, -1), rng.uniform()});
        check_places(any, rng);
    }
    const Vec2 offset{Real(0.125), Real(0.875)};
    const Ray ray = ray_of({usual, {0, 4}, 20, 70, offset}, {Real(0.7), Real(0.2)});
    INFO("aperture 0");
    check_close(ray.origin, usual.eye, 0,
                "a lens of aperture 0 is a pinhole: the ray starts at the eye");
    check_close(ray.direction, rt::primary_ray(usual, 20, 70, offset).direction, direction_error,
                "a lens of aperture 0 is a pinhole: the direction is that of primary_ray");
}

TEST_CASE("08.2 directions are accurate far from the scene's origin", "[08.2][hard]") {
    // A pixel's position in the world has few digits left here, but its direction has them all.
    const Real far = for_this_precision(Real(3e4), Real(3e12));
    const Lens lens{Real(0.01), 1};
    const Camera near = camera_at({0, 0, 0}, {0, 0, -1});
    Camera moved = near;
    moved.eye = {far, -far, far};
    for_each_place(5, [&](Vec2 place) {
        const Vec3 expected = rt::lens_ray(near, lens, 150, 4, middle, place).direction;
        const Vec3 direction = rt::lens_ray(moved, lens, 150, 4, middle, place).direction;
        check_close(direction, expected, direction_error,
                    "the direction does not depend on where the eye is: do not subtract points of "
                    "the world, but a point on the lens from a point in the plane of focus, both "
                    "relative to the eye");
    });
}

TEST_CASE("08.2 the directions are the same at any scale", "[08.2][hard]") {
    const Lens lens{Real(0.5), 4};
    for (const Real scale : {Real(1e-9), Real(1e9)}) {
        const Camera scaled = camera_at({1, 2, 3}, {Real(-0.6), Real(-0.2), -1}, scale);
        const Lens scaled_lens{scale * lens.aperture, scale * lens.focus_distance};
        for_each_place(5, [&](Vec2 place) {
            const Ray expected = rt::lens_ray(usual, lens, 10, 80, middle, place);
            const Ray ray = rt::lens_ray(scaled, scaled_lens, 10, 80, middle, place);
            INFO("all lengths are multiplied by " << text(scale));
            check_close(ray.direction, expected.direction, 4 * direction_error,
                        "only ratios of lengths may count");
            check_close(ray.origin / scale, expected.origin, rt::rounding_bound(60) * 4,
                        "the origin scales with the scene");
        });
    }
}

TEST_CASE("08.2 all rays are parallel at the largest focus distances", "[08.2][hard]") {
    // Compared with the distance, the lens is nothing: all rays of a pixel are parallel.
    const Lens lens{Real(0.5), std::numeric_limits<Real>::max() / 8};
    const Vec3 expected = rt::primary_ray(usual, 12, 70, middle).direction;
    for_each_place(5, [&](Vec2 place) {
        check_close(rt::lens_ray(usual, lens, 12, 70, middle, place).direction, expected,
                    direction_error,
                    "all rays are parallel; an infinite or undefined direction means that a "
                    "product overflowed");
    });
}
