// What accuracy costs: five ways to scale a vector to length 1.

#include <app/run.hpp>
#include <array>
#include <cmath>
#include <rt/length.hpp>
#include <rt/rng.hpp>
#include <study/pixel_error.hpp>
#include <study/report.hpp>
#include <study/timing.hpp>
#include <study/ulp.hpp>
#include <vector>

namespace vectors_study {
namespace {

using rt::Real, rt::Vec3, study::DoubleDouble;

// The way of most textbooks: one division, then three products.
Vec3 by_reciprocal_root(Vec3 v) {
    return v * (1 / std::sqrt(dot(v, v)));
}

// Three divisions instead: each component is rounded once less.
Vec3 by_root(Vec3 v) {
    return v / std::sqrt(dot(v, v));
}

// Always scales the vector first, even when that is not needed.
Vec3 by_scaled_root(Vec3 v) {
    return by_root(rt::split_scale(v).v);
}

// The standard library's length, which does its own scaling.
Vec3 by_hypot(Vec3 v) {
    return v / std::hypot(v.x, v.y, v.z);
}

// The largest error of a component, in units in the last place. The reference has twice the digits
// of double; its vector is scaled by a power of two, which changes no digit of the direction.
double error_of(Vec3 computed, Vec3 v) {
    const Vec3 s = rt::split_scale(v).v;
    const DoubleDouble x{static_cast<double>(s.x)}, y{static_cast<double>(s.y)},
        z{static_cast<double>(s.z)};
    const DoubleDouble length = sqrt(x * x + y * y + z * z);
    return std::max({study::error_in_ulp(computed.x, x / length),
                     study::error_in_ulp(computed.y, y / length),
                     study::error_in_ulp(computed.z, z / length)});
}

// The error in a picture that shows directions d as colors (d + 1) / 2. A direction
// that is not finite is black.
double error_in_a_pixel(const std::vector<Vec3>& vectors, Vec3 (*normalize)(Vec3)) {
    double sum = 0;
    for (const Vec3 v : vectors) {
        const Vec3 found = normalize(v), s = rt::split_scale(v).v;
        const DoubleDouble x{static_cast<double>(s.x)}, y{static_cast<double>(s.y)},
            z{static_cast<double>(s.z)};
        const DoubleDouble length = sqrt(x * x + y * y + z * z);
        const auto add = [&](Real component, DoubleDouble true_one) {
            const DoubleDouble shown{rt::is_finite(found) ? static_cast<double>(component) : -1};
            const double off = (shown - true_one / length).high / 2;
            sum += off * off;
        };
        add(found.x, x);
        add(found.y, y);
        add(found.z, z);
    }
    return std::sqrt(sum / (3 * static_cast<double>(vectors.size())));
}

void run(study::Report& report) {
    struct Variant {
        const char* name;
        Vec3 (*normalize)(Vec3);
    };
    const std::array<Variant, 5> variants{{{"v * (1 / sqrt)", by_reciprocal_root},
                                           {"v / sqrt", by_root},
                                           {"v / scaled sqrt", by_scaled_root},
                                           {"v / hypot", by_hypot},
                                           {"rt::normalize", rt::normalize}}};
    const int far = std::is_same_v<Real, float> ? 30 : 200;  // powers of ten
    rt::Rng rng{1, 1};
    std::vector<study::Row> in_a_pixel;
    for (int exponent = -far; exponent <= far; exponent += far / 5) {
        const Real size = std::pow(Real(10), static_cast<Real>(exponent));
        std::vector<Vec3> vectors;
        const auto component = [&] { return size * rng.uniform(-1, 1); };
        while (vectors.size() < 4096) vectors.push_back({component(), component(), component()});

        for (const Variant& variant : variants) {
            double worst = 0;
            for (const Vec3 v : vectors) worst = std::max(worst, error_of(variant.normalize(v), v));
            const auto normalize_all = [variant, vectors] {
                Vec3 sum;
                for (const Vec3 v : vectors) sum += variant.normalize(v);
                study::keep(sum);
            };
            report.add({.study = "Normalize",
                        .variant = variant.name,
                        .x = static_cast<double>(size),
                        .x_name = "length of the vector",
                        .error = worst,
                        .error_name = "largest error / ulp",
                        .cost_name = "time / ns"},
                       normalize_all, static_cast<double>(vectors.size()));
        }
        if (exponent != 0 && exponent != far) continue;
        for (const Variant& variant : {variants[1], variants[4]})
            in_a_pixel.push_back(study::pixel_error(
                std::string(variant.name) + (exponent == 0 ? ", length 1" : ", huge"),
                static_cast<double>(size), "length of the vector",
                error_in_a_pixel(vectors, variant.normalize)));
    }
    report.time_in_turns();
    for (const study::Row& row : in_a_pixel) report.add(row);
}

}  // namespace
}  // namespace vectors_study

void (*const app::program_study)(study::Report&) = vectors_study::run;
