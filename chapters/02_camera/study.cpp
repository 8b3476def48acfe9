// What accuracy costs in this chapter: ways to map a pixel, to make its ray, and to find the basis.

#include <app/run.hpp>
#include <array>
#include <cmath>
#include <rt/compiler.hpp>
#include <rt/make_camera.hpp>
#include <rt/primary_ray.hpp>
#include <rt/rng.hpp>
#include <study/double_double.hpp>
#include <study/pixel_error.hpp>
#include <study/report.hpp>
#include <study/timing.hpp>
#include <vector>

#include "dome.hpp"

namespace camera_study {
namespace {

using rt::Camera;
using rt::Real;
using rt::Vec2;
using rt::Vec3;
using study::DoubleDouble;

// The reference: vectors with twice the digits of double.
struct Exact3 {
    DoubleDouble x, y, z;

    Exact3(DoubleDouble a, DoubleDouble b, DoubleDouble c) : x{a}, y{b}, z{c} {}
    Exact3(Vec3 v) : x{v.x}, y{v.y}, z{v.z} {}

    friend Exact3 operator+(Exact3 a, Exact3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Exact3 operator*(DoubleDouble s, Exact3 v) { return {s * v.x, s * v.y, s * v.z}; }
};
DoubleDouble length(Exact3 v) {
    return sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}
Exact3 cross(Exact3 a, Exact3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// The sine of the angle between two vectors. The angles measured here are so small that the sine is
// as good as the angle.
double angle(Exact3 a, Exact3 b) {
    return (length(cross(a, b)) / (length(a) * length(b))).high;
}

// ---- Pixel mappings

Vec2 subtract_late(const Camera& c, int column, int row, Vec2 offset) {
    const Real right = (static_cast<Real>(column) + offset.x) / static_cast<Real>(c.width);
    const Real down = (static_cast<Real>(row) + offset.y) / static_cast<Real>(c.height);
    return {(right - Real(0.5)) * c.viewport.width, (Real(0.5) - down) * c.viewport.height};
}
Vec2 width_minus_one(const Camera& c, int column, int row, Vec2 offset) {
    const Real right = (static_cast<Real>(column) + offset.x) / static_cast<Real>(c.width - 1);
    const Real down = (static_cast<Real>(row) + offset.y) / static_cast<Real>(c.height - 1);
    return {(right - Real(0.5)) * c.viewport.width, (Real(0.5) - down) * c.viewport.height};
}
// Without the half pixel that leads to a pixel's middle: this looks symmetric, but is half a pixel
// off at both edges.
Vec2 posts_of_a_fence(const Camera& c, int column, int row, Vec2 offset) {
    return width_minus_one(c, column, row, {offset.x - Real(0.5), offset.y - Real(0.5)});
}

Exact3 exact_viewport_point(const Camera& c, int column, int row, Vec2 offset) {
    const DoubleDouble width = c.width, height = c.height;
    const DoubleDouble x = DoubleDouble(column) + DoubleDouble(offset.x) - width / 2;
    const DoubleDouble y = height / 2 - DoubleDouble(row) - DoubleDouble(offset.y);
    return {x / width * DoubleDouble(c.viewport.width),
            y / height * DoubleDouble(c.viewport.height), -1};
}

// Work to be timed: 960 calls. Each result is used before the next is computed, as in a ray tracer:
// otherwise the compiler would compute several at once.
constexpr int calls = 960;
template <class T, class F>
study::Work call_many(F make) {
    return [make, results = std::vector<T>(calls)]() mutable {
        for (int i = 0; i < calls; ++i) {
            T& result = results[static_cast<std::size_t>(i)];
            result = make(i);
            study::keep(result);
        }
    };
}

template <auto map>  // a template argument, so that the compiler can inline it
void measure_mapping(study::Report& report, const char* variant) {
    Camera camera;
    camera.viewport = {Real(1.7), Real(1.7)};
    camera.width = camera.height = 960;
    const Vec2 middle{Real(0.5), Real(0.5)};
    const auto map_many =
        call_many<Vec2>([=](int i) { return map(camera, i, 7 * i % 540, middle); });
    for (const int width : {2, 3, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10'000}) {
        camera.width = camera.height = width;
        double worst = 0;
        for (int column = 0; column < width; ++column) {
            const DoubleDouble exact = exact_viewport_point(camera, column, column, middle).x;
            const Vec2 p = map(camera, column, column, middle);
            const double off = (exact - DoubleDouble(p.x)).high;
            worst =
                std::max(worst, std::abs(off) / static_cast<double>(camera.viewport.width) * width);
        }
        report.add({.study = "pixel mapping",
                    .variant = variant,
                    .x = static_cast<double>(width),
                    .x_name = "width / pixels",
                    .error = worst,
                    .error_name = "largest error / pixels",
                    .cost_name = "time per pixel / ns"},
                   map_many, calls);
    }
}

// ---- Rays

Vec3 direction(const Camera& camera, Vec2 p) {
    return camera.basis.to_world({p.x, p.y, -1});
}

// A small picture of the dome.
template <auto map>
std::vector<rt::Color> dome_picture() {
    const Vec3 eye{0, Real(1.7), 0};
    const Camera camera =
        rt::make_camera({eye, eye + dome::toward(180, 7), {0, 1, 0}, rt::radians(50)}, 96, 54);
    const auto ray = [&](int x, int y) {
        return rt::Ray{eye,
                       normalize(direction(camera, map(camera, x, y, {Real(0.5), Real(0.5)})))};
    };
    std::vector<rt::Color> pixels;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            pixels.push_back(dome::look({ray(x, y), ray(x + 1, y), ray(x, y + 1)}));
    return pixels;
}
template <auto map>
void measure_pixels(study::Report& report, const char* variant) {
    report.add(study::pixel_error(
        variant, 96, "width / pixels",
        study::root_mean_square_error(dome_picture<map>(), dome_picture<rt::pixel_to_viewport>())));
}

// What it takes to make rays by steps: the viewport's corner, and the steps from pixel to pixel.
struct Steps {
    Vec3 corner, to_right, down;

    explicit Steps(const Camera& c)
        : corner{c.basis.to_world({-c.viewport.width / 2, c.viewport.height / 2, -1})},
          to_right{c.viewport.width / static_cast<Real>(c.width) * c.basis.u},
          down{-c.viewport.height / static_cast<Real>(c.height) * c.basis.v} {}

    Vec3 direction(int column, int row, Vec2 offset) const {
        return corner + (static_cast<Real>(column) + offset.x) * to_right +
               (static_cast<Real>(row) + offset.y) * down;
    }
};

// make(camera) returns the function to measure, which turns column, row and offset into a
// direction.
template <class Make>
void measure_rays(study::Report& in_pixels, study::Report& in_ulp, const char* variant, Make make) {
    const auto camera_of = [](double fov_deg) {
        const Real fov = static_cast<Real>(fov_deg * std::numbers::pi / 180);
        return rt::make_camera({{3, 2, 5}, {-1, Real(0.5), -2}, {0, 1, 0}, fov}, 960, 540);
    };
    const Vec2 middle{Real(0.5), Real(0.5)};
    const Camera timed = camera_of(50);
    const auto ray_of_timed = make(timed);
    const auto make_many =
        call_many<Vec3>([=](int i) { return ray_of_timed(i, 7 * i % 540, middle); });
    for (const double fov_deg :
         {0.001, 0.01, 0.1, 1.0, 10.0, 50.0, 90.0, 140.0, 170.0, 179.0, 179.9}) {
        const Camera camera = camera_of(fov_deg);
        const auto ray = make(camera);
        const auto exact = [&](int column, int row) {
            const Exact3 p = exact_viewport_point(camera, column, row, middle);
            return p.x * Exact3(camera.basis.u) + p.y * Exact3(camera.basis.v) +
                   p.z * Exact3(camera.basis.w);
        };
        double pixels = 0, ulp = 0;
        for (int row = 0; row < camera.height; row += 11)
            for (int column = 0; column < camera.width; column += 13) {
                const Exact3 e = exact(column, row);
                const double error = angle(ray(column, row, middle), e);
                const double pixel =
                    std::min(angle(exact(column + 1, row), e), angle(exact(column, row + 1), e));
                pixels = std::max(pixels, error / pixel);
                ulp = std::max(ulp, error / static_cast<double>(rt::epsilon));
            }
        const auto add = [&](study::Report& report, const char* study, double error,
                             const char* error_name) {
            report.add({.study = study,
                        .variant = variant,
                        .x = fov_deg,
                        .x_name = "field of view / degrees",
                        .error = error,
                        .error_name = error_name,
                        .cost_name = "time per ray / ns"},
                       make_many, calls);
        };
        add(in_pixels, "ray direction", pixels, "largest error / pixels");
        add(in_ulp, "ray rounding", ulp, "largest error / ulp of 1");
    }
}

// ---- The basis

rt::Basis normalize_first(Vec3 from, Vec3 at, Vec3 up) {
    const Vec3 w = rt::normalize(from - at);
    const Vec3 right = rt::cross(rt::normalize(up), w);
    if (right == Vec3{}) return rt::orthonormal_basis(w);
    const Vec3 u = rt::normalize(right);
    return {u, rt::cross(w, u), w};
}

template <auto look_at>
void measure_look_at(study::Report& report, const char* variant) {
    rt::Rng rng{1, 2};
    const auto random = [&] {
        return Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    };
    // The compiler must not know these values in advance.
    Vec3 at{-1, Real(0.5), -2}, upwards{0, 1, 0};
    RT_KEEP(at);
    RT_KEEP(upwards);
    const auto make_many = call_many<rt::Basis>([=](int i) {
        return look_at({3, 2, static_cast<Real>(i)}, at, upwards);
    });
    const int decades = std::numeric_limits<Real>::digits10 + 1;
    for (int decade = 0; decade < decades; ++decade) {
        const Real small = std::pow(Real(10), static_cast<Real>(-decade));
        double worst = 0;
        for (int i = 0; i < 400; ++i) {
            const Vec3 up = rt::normalize(random()),
                       from = 3 * up + 3 * small * rt::cross(up, random());
            const Exact3 right = cross(Exact3(up), Exact3(from));
            if (!(0 < length(right))) continue;
            worst = std::max(worst, angle(look_at(from, {0, 0, 0}, up).u, right));
        }
        report.add({.study = "look-at",
                    .variant = variant,
                    .x = static_cast<double>(small),
                    .x_name = "angle between view and up / radians",
                    .error = worst / static_cast<double>(rt::epsilon),
                    .error_name = "largest error of u / ulp of 1",
                    .cost_name = "time per basis / ns"},
                   make_many, calls);
    }
}

void run(study::Report& report) {
    measure_mapping<rt::pixel_to_viewport>(report, "as written");
    measure_mapping<subtract_late>(report, "1/2 subtracted late");
    measure_mapping<width_minus_one>(report, "(i + 1/2) / (width - 1)");
    measure_mapping<posts_of_a_fence>(report, "i / (width - 1)");
    report.time_in_turns();

    study::Report in_ulp{"02_camera"};
    measure_rays(report, in_ulp, "as written", [](const Camera& c) {
        return [=](int x, int y, Vec2 o) { return rt::primary_ray(c, x, y, o).direction; };
    });
    measure_rays(report, in_ulp, "not normalized", [](const Camera& c) {
        return
            [=](int x, int y, Vec2 o) { return direction(c, rt::pixel_to_viewport(c, x, y, o)); };
    });
    measure_rays(report, in_ulp, "times 1 / sqrt", [](const Camera& c) {
        return [=](int x, int y, Vec2 o) {
            const Vec3 d = direction(c, rt::pixel_to_viewport(c, x, y, o));
            return d * (1 / std::sqrt(dot(d, d)));
        };
    });
    measure_rays(report, in_ulp, "1/2 subtracted late", [](const Camera& c) {
        return [=](int x, int y, Vec2 o) {
            return normalize(direction(c, subtract_late(c, x, y, o)));
        };
    });
    measure_rays(report, in_ulp, "steps from the corner", [](const Camera& c) {
        return [steps = Steps(c)](int x, int y, Vec2 o) {
            return normalize(steps.direction(x, y, o));
        };
    });

    report.time_in_turns();
    in_ulp.time_in_turns();
    for (const study::Row& row : in_ulp.rows()) report.add(row);

    measure_look_at<rt::look_at>(report, "as written");
    measure_look_at<normalize_first>(report, "normalized first");
    report.time_in_turns();

    measure_pixels<subtract_late>(report, "1/2 subtracted late");
    measure_pixels<width_minus_one>(report, "(i + 1/2) / (width - 1)");
    measure_pixels<posts_of_a_fence>(report, "i / (width - 1)");
}

}  // namespace
}  // namespace camera_study

void (*const app::program_study)(study::Report&) = camera_study::run;
