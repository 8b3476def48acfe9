#include <rt/primary_ray.hpp>

#include "checkpoint.hpp"
#include "random_inputs.hpp"
#include "vectors.hpp"

using namespace checkpoint;
using rt::Camera;
using rt::Ray;
using rt::Vec2;

namespace {

constexpr Vec2 middle{Real(0.5), Real(0.5)};

// A camera at (7, 8, 9) that looks along +x: u is +z, v is +y, w is -x. It sees 90 degrees from
// side to side.
Camera eastward() {
    Camera camera;
    camera.eye = {7, 8, 9};
    camera.basis = {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};
    camera.viewport = {2, 2};
    camera.width = camera.height = 3;
    return camera;
}

// A camera turned anywhere.
Camera any_camera(rt::Rng& rng) {
    const auto component = [&] { return rng.uniform(-1, 1); };
    const Vec3 up{component(), component(), component()};
    const ExactVec3 back = exact_vector({component(), component(), component()});
    const ExactVec3 right = cross(exact_vector(up), back);
    const auto rounded = [](const ExactVec3& v) {
        return Vec3{real(v.x.high), real(v.y.high), real(v.z.high)};
    };
    Camera camera;
    camera.basis = {rounded(exact_unit(right)), rounded(exact_unit(cross(back, right))),
                    rounded(exact_unit(back))};
    return camera;
}

ExactVec3 exact_direction(const Camera& camera, int column, int row, Vec2 offset) {
    const auto place = [](int i, Real within, int pixels, Real size) {
        return (Exact(i) + Exact(within) - Exact(pixels) / Exact(2)) / Exact(pixels) * Exact(size);
    };
    const Exact x = place(column, offset.x, camera.width, camera.viewport.width);
    const Exact y = -place(row, offset.y, camera.height, camera.viewport.height);
    const auto to_world = [&](auto component_of) {
        return x * Exact(component_of(camera.basis.u)) + y * Exact(component_of(camera.basis.v)) -
               Exact(component_of(camera.basis.w));
    };
    return exact_unit({to_world([](Vec3 v) { return v.x; }), to_world([](Vec3 v) { return v.y; }),
                       to_world([](Vec3 v) { return v.z; })});
}

// Rays of turned cameras whose fields of view are from 0.001 to 179.9 degrees, through the edges
// and the middle of pictures of all shapes.
template <class Check>
void for_rays_of_any_angle(Check check) {
    constexpr double degrees[] = {0.001, 0.01, 1, 20, 90, 140, 179, 179.9};
    constexpr struct {
        int width, height;
    } sizes[] = {{960, 540}, {1, 1}, {1, 10000}, {10000, 1}, {3, 2}, {641, 359}};
    rt::Rng rng{24, 3};
    const auto one_of_three = [&](int last) {
        const auto which = rng() % 3;
        return which == 0 ? 0 : which == 1 ? (last + 1) / 2 : last;
    };
    for (int i = 0; i < 480; ++i) {
        Camera camera = any_camera(rng);
        camera.width = sizes[i % 6].width;
        camera.height = sizes[i % 6].height;
        const double angle = degrees[i / 6 % 8], height = 2 * std::tan(angle * 3.14159265 / 360);
        camera.viewport = {real(height * camera.width / camera.height), real(height)};
        const auto within = [&] { return rng() % 2 == 0 ? Real(0.5) : rng.uniform(); };
        const Vec2 offset{within(), within()};
        check(angle, camera, one_of_three(camera.width - 1), one_of_three(camera.height - 1),
              offset);
    }
}

// A camera turned anywhere, of any size and angle, and one of its rays. The plain formula of 02.1
// may be off by a few roundings of the viewport's size.
void check_any_ray(rt::Rng& rng, Real far, bool plain) {
    const auto upto = [&](int n) { return static_cast<int>(rng() % static_cast<unsigned>(n)); };
    Camera camera = any_camera(rng);
    camera.eye = any_vector(rng, -far, far);
    camera.viewport = {std::abs(any_number(rng, -4, 3)), std::abs(any_number(rng, -4, 3))};
    camera.width = 1 + upto(2000);
    camera.height = 1 + upto(2000);
    const int column = upto(camera.width), row = upto(camera.height);
    const Vec2 offset{rng.uniform(), rng.uniform()};
    const ExactVec3 expected = exact_direction(camera, column, row, offset);
    const Ray ray = rt::primary_ray(camera, column, row, offset);
    INFO(camera.width << 'x' << camera.height << " pixels on a viewport of "
                      << text(camera.viewport.width) << 'x' << text(camera.viewport.height)
                      << ", column " << column << ", row " << row << ", offset (" << text(offset.x)
                      << ", " << text(offset.y) << "), u = " << text(camera.basis.u)
                      << ", v = " << text(camera.basis.v) << ", w = " << text(camera.basis.w));
    {
        HINT(camera.eye, ray.origin,
             "the ray starts at the eye, and its direction does not depend on the eye");
        REQUIRE(text(ray.origin) == text(camera.eye));
    }
    HINT(expected, ray.direction,
         "the direction is x u + y v - w, normalized; pixel_to_viewport gives x and y for this "
         "offset");
    const double size =
        static_cast<double>(std::max(camera.viewport.width, camera.viewport.height));
    REQUIRE(error_in_ulp_of_1(ray.direction, expected) <= 7 + (plain ? 4 * size : 0));
}

}  // namespace

TEST_CASE("02.4 the ray starts at the eye", "[02.4]") {
    const Ray ray = rt::primary_ray(eastward(), 1, 1, middle);
    INFO("the ray starts at the eye: " EXPECTED "(7, 8, 9), " ACTUAL << text(ray.origin));
    CHECK(ray.origin == Vec3{7, 8, 9});
}

TEST_CASE("02.4 the ray through the middle of the picture leads straight ahead", "[02.4]") {
    const Ray ray = rt::primary_ray(eastward(), 1, 1, middle);
    const Vec3 ahead{1, 0, 0};
    HINT(ahead, ray.direction,
         ray.direction == -ahead
             ? "this direction leads behind the camera. The camera looks along -w, so the "
               "third coordinate must be -1"
             : "the direction is x u + y v - w, with the camera's own u, v and w");
    CHECK(ray.direction == ahead);
}

TEST_CASE("02.4 u points right in the picture and v points up", "[02.4]") {
    const Vec3 right = rt::primary_ray(eastward(), 2, 1, middle).direction;
    INFO(
        "a camera that looks along +x with y up has +z to its right; the pixel right of the middle "
        "gives the direction "
        << text(right));
    CHECK(right.z > 0);
    CHECK(right.y == 0);
    const Vec3 above = rt::primary_ray(eastward(), 1, 0, middle).direction;
    INFO("the pixel above the middle gives the direction "
         << text(above)
         << ".\nHint: multiply x by u and y by v; pixel_to_viewport takes the column first");
    CHECK(above.y > 0);
    CHECK(above.z == 0);
}

TEST_CASE("02.4 rays at the picture's corners go through the viewport's corners", "[02.4]") {
    const struct {
        int column, row;
        Vec2 offset;
        Vec3 signs;
    } corners[] = {{0, 0, {0, 0}, {1, 1, -1}},
                   {2, 0, {1, 0}, {1, 1, 1}},
                   {0, 2, {0, 1}, {1, -1, -1}},
                   {2, 2, {1, 1}, {1, -1, 1}}};
    for (const auto& [column, row, offset, signs] : corners) {
        const Vec3 d = rt::primary_ray(eastward(), column, row, offset).direction;
        const Vec3 expected = signs / std::sqrt(Real(3));
        HINT(expected, d, "pass the offset on to pixel_to_viewport; the direction has length 1");
        // The expected direction has two roundings; in yours, everything but normalize is exact.
        const Vec3 off = d - expected;
        CHECK(max_component(off) <= 3 * rt::epsilon);
    }
}

TEST_CASE("02.4 the direction has length 1", "[02.4]") {
    for_rays_of_any_angle([](double, const Camera& camera, int column, int row, Vec2 offset) {
        const Vec3 d = rt::primary_ray(camera, column, row, offset).direction;
        INFO("direction " << text(d) << ".\nHint: call normalize last");
        REQUIRE(length_error_in_ulp(d) <= 2);
    });
}

TEST_CASE("02.4 the ray is correct for any pixel of any camera", "[02.4]") {
    rt::Rng rng{24, 1};
    for (int i = 0; i < 1000; ++i) check_any_ray(rng, 1, true);
}

TEST_CASE("02.4 rays are accurate to 7 epsilon for extreme fields of view and images of one pixel",
          "[02.4][hard]") {
    for_rays_of_any_angle(
        [](double degrees, const Camera& camera, int column, int row, Vec2 offset) {
            const Vec3 d = rt::primary_ray(camera, column, row, offset).direction;
            const ExactVec3 expected = exact_direction(camera, column, row, offset);
            INFO(degrees << " degrees, " << camera.width << 'x' << camera.height
                         << " pixels, column " << column << ", row " << row << ", offset ("
                         << offset.x << ", " << offset.y << ')');
            HINT(expected, d,
                 "the direction is x u + y v - w, normalized; if 02.1 is not within its bound yet, "
                 "fix that first");
            // At most six roundings in each product, which turn the direction by no more than
            // sqrt(3) times as much, and 3.5 in normalize: 14 halves of a unit.
            REQUIRE(error_in_ulp_of_1(d, expected) <= 7);
        });
}

TEST_CASE("02.4 directions do not depend on how far away the eye is", "[02.4][hard]") {
    rt::Rng rng{24, 2};
    for (int i = 0; i < 1000; ++i) check_any_ray(rng, for_this_precision<Real>(30, 200), false);
}
