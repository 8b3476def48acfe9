#include <checkpoint.hpp>
#include <rt/lens_ray.hpp>
#include <rt/make_camera.hpp>
#include <rt/primary_ray.hpp>

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
// normalize. The largest that an orderly computation may come to is a few times less.
constexpr Real direction_error = rt::rounding_bound(40);

void check_close(Vec3 computed, Vec3 expected, Real allowed, const char* hint) {
    if (max_component(computed - expected) <= allowed) return;
    INFO("they differ by " << text(max_component(computed - expected)) << ", allowed are "
                           << text(allowed));
    HINT(expected, computed, hint);
    CHECK(false);
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

TEST_CASE("08.2 the ray from the middle of the lens is the pinhole's", "[08.2]") {
    const Lens lens{Real(0.5), 4};
    for (const int column : {0, 31, 80, 159})
        for (const int row : {0, 45, 89}) {
            const Ray expected = rt::primary_ray(usual, column, row, middle);
            for (const Real turn : {Real(0), Real(0.3)}) {
                const Ray ray = rt::lens_ray(usual, lens, column, row, middle, {0, turn});
                check_close(ray.origin, expected.origin, 4 * rt::epsilon,
                            "place.x = 0 is the middle of the lens: the eye");
                check_close(ray.direction, expected.direction, direction_error,
                            "from the middle of the lens it goes on as from a pinhole");
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
                                                         << ", and must have 1: normalize it");
                        REQUIRE(std::abs(rt::length(ray.direction) - 1) <= direction_error);
                    }
                    const Vec3 off = ray.origin - usual.eye;
                    {
                        INFO(
                            "the ray starts at the eye, as if there were no lens.\nHint: the "
                            "origin moves along u and v, to the place on the lens");
                        REQUIRE(off != Vec3{});
                    }
                    INFO("seen by the camera, to the right and up, the ray starts at "
                         << in_camera(off) << " and goes along "
                         << in_camera(ray.direction / -rt::dot(ray.direction, usual.basis.w))
                         << " for each 1 ahead; the pinhole's goes along "
                         << in_camera(pinhole / -rt::dot(pinhole, usual.basis.w)));
                    check_close(in_focus(usual, lens, ray), expected,
                                rt::rounding_bound(80) * scale,
                                "the point in focus is where the pinhole's ray meets the plane at "
                                "focus_distance along the direction of view; what starts to the "
                                "right must turn left: p - x / f");
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
        INFO("the origin is off the eye by " << text(off));
        {
            const Real tilt = std::abs(rt::dot(off, usual.basis.w));
            INFO("and " << text(tilt) << " before or behind the lens: use the camera's u and v");
            CHECK(tilt <= rt::rounding_bound(30) * 4);
        }
        INFO("The aperture is the diameter: no place is farther from the eye than half of it");
        CHECK(rt::length(off) <= lens.aperture / 2 + rt::rounding_bound(30) * 4);
    });
    {
        INFO("the farthest of 256 places is " << text(farthest) << " off, of at most 0.4");
        CHECK(farthest > Real(0.39));
    }
    INFO("the mean of the places is off the eye by "
         << text(rt::length(sum / 256))
         << ".\nHint: they lie all the way around the eye: a full turn is 2 pi");
    CHECK(rt::length(sum / 256) <= rt::rounding_bound(300) * 4);
}

TEST_CASE("08.2 the places are spread evenly over the lens", "[08.2]") {
    // Of rings of equal width the areas are 1, 3, 5 and 7 sixteenths.
    const Lens lens{2, 3};
    long rings[4] = {}, quarters[4] = {};
    for_each_place(64, [&](Vec2 place) {
        const Vec3 off = rt::lens_ray(usual, lens, 80, 45, middle, place).origin - usual.eye;
        const Real u = rt::dot(off, usual.basis.u), v = rt::dot(off, usual.basis.v);
        const Real radius = std::sqrt(u * u + v * v);
        ++rings[std::min(3, static_cast<int>(4 * radius))];
        ++quarters[(u < 0 ? 1 : 0) + (v < 0 ? 2 : 0)];
    });
    // A ring's edge may go through a row of 64 places.
    for (int i = 0; i < 4; ++i) {
        INFO("ring " << i << " of 4 got " << rings[i] << " of 4096 places, its area's share are "
                     << 256 * (2 * i + 1)
                     << ".\nHint: the radius is the root of the share of the area within it");
        CHECK(std::abs(rings[i] - 256 * (2 * i + 1)) <= 64);
    }
    for (int i = 0; i < 4; ++i) {
        INFO("quarter " << i << " of the lens got " << quarters[i]
                        << " places of 1024.\nHint: a full turn is 2 pi");
        CHECK(quarters[i] == 1024);
    }
}

TEST_CASE("08.2 far from the origin no digits are lost", "[08.2][hard]") {
    // A pixel's place in the world has few digits left here, its direction has them all.
    const Real far = for_this_precision(Real(3e4), Real(3e12));
    const Lens lens{Real(0.01), 1};
    const Camera near = camera_at({0, 0, 0}, {0, 0, -1});
    Camera moved = near;
    moved.eye = {far, -far, far};
    for_each_place(5, [&](Vec2 place) {
        const Vec3 expected = rt::lens_ray(near, lens, 150, 4, middle, place).direction;
        const Vec3 direction = rt::lens_ray(moved, lens, 150, 4, middle, place).direction;
        check_close(direction, expected, direction_error,
                    "the direction does not depend on where the eye is: do not go from a point in "
                    "the world to another, but from a place on the lens to a place in the plane of "
                    "focus, both seen from the eye");
    });
}

TEST_CASE("08.2 at any scale the directions are the same", "[08.2][hard]") {
    const Lens lens{Real(0.5), 4};
    for (const Real scale : {Real(1e-9), Real(1e9)}) {
        const Camera scaled = camera_at({1, 2, 3}, {Real(-0.6), Real(-0.2), -1}, scale);
        const Lens scaled_lens{scale * lens.aperture, scale * lens.focus_distance};
        for_each_place(5, [&](Vec2 place) {
            const Ray expected = rt::lens_ray(usual, lens, 10, 80, middle, place);
            const Ray ray = rt::lens_ray(scaled, scaled_lens, 10, 80, middle, place);
            INFO("everything times " << text(scale));
            check_close(ray.direction, expected.direction, 4 * direction_error,
                        "nothing but ratios of lengths may count");
            check_close(ray.origin / scale, expected.origin, rt::rounding_bound(60) * 4,
                        "the origin scales with the scene");
        });
    }
}

TEST_CASE("08.2 a lens in focus at the far end of all numbers is a pinhole for stars",
          "[08.2][hard]") {
    // The lens is nothing against the distance: all rays of a pixel are parallel.
    const Lens lens{Real(0.5), std::numeric_limits<Real>::max() / 8};
    const Vec3 expected = rt::primary_ray(usual, 12, 70, middle).direction;
    for_each_place(5, [&](Vec2 place) {
        check_close(rt::lens_ray(usual, lens, 12, 70, middle, place).direction, expected,
                    direction_error,
                    "all rays are parallel; an infinite or undefined direction means that a "
                    "product overflowed");
    });
}
