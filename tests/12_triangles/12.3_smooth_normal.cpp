#include <rt/reflect.hpp>
#include <rt/smooth_normal.hpp>

#include "shapes.hpp"

using namespace checkpoint;
using rt::bent_normal;
using rt::keep_side;
using rt::smooth_normal;

namespace {

const Vec3 up{0, 0, 1};
const double rounding = 64 * static_cast<double>(rt::epsilon);

void check_near(Vec3 actual, Vec3 expected, const char* hint) {
    const bool right = rt::max_component(actual - expected) <= 16 * rt::epsilon;
    if (!right) {
        HINT(expected, actual, hint);
        REQUIRE(right);
    }
    REQUIRE(right);
}

Real length_of(Vec3 v) {
    return static_cast<Real>(exact_length(exact_vector(v)).high);
}
double exact_dot(Vec3 a, Vec3 b) {
    return dot(exact_vector(a), exact_vector(b)).high;
}

// A direction whose height over a surface with this normal is about `height`.
Vec3 at_height(rt::Rng& rng, Vec3 normal, Real height) {
    for (;;) {
        const Vec3 any = any_direction(rng);
        const Vec3 along = any - static_cast<Real>(exact_dot(any, normal)) * normal;
        if (length_of(along) < real(0.5)) continue;
        const Vec3 sum = along / length_of(along) + height * normal;
        return sum / length_of(sum);
    }
}

// A height so small that only rounding errors are smaller; above the surface or below it.
Real small_height(rt::Rng& rng) {
    return (rng() & 1 ? 1 : -1) * any_size(rng, for_this_precision(-4, -12), -1);
}

// Light that a mirror with the normal `smooth` sends almost along the triangle.
Vec3 mirrored_low(rt::Rng& rng, Vec3 flat, Vec3 smooth) {
    return rt::reflect(at_height(rng, flat, small_height(rng)), smooth);
}

// A direction near a normal: at most this far to the side, before it gets the length 1.
Vec3 leaning(rt::Rng& rng, Vec3 normal, Real side) {
    const Vec3 sum = normal + side * any_direction(rng);
    return sum / length_of(sum);
}

}  // namespace

TEST_CASE("12.3 at a corner the normal is that of the corner", "[12.3]") {
    const std::array<Vec3, 3> normals{
        Vec3{real(0.6), 0, real(0.8)}, {real(-0.6), 0, real(0.8)}, {0, real(0.6), real(0.8)}};
    const char* const hint = "the weights of a, b and c are 1 - u - v, u and v";
    check_near(smooth_normal(normals, 0, 0, up), normals[0], hint);
    check_near(smooth_normal(normals, 1, 0, up), normals[1], hint);
    check_near(smooth_normal(normals, 0, 1, up), normals[2], hint);
}

TEST_CASE("12.3 halfway between two corners the normal is their normalized mean", "[12.3]") {
    const std::array<Vec3, 3> normals{
        Vec3{real(0.6), 0, real(0.8)}, {real(-0.6), 0, real(0.8)}, {0, real(0.6), real(0.8)}};
    check_near(smooth_normal(normals, real(0.5), 0, up), up,
               "the sum is shorter than 1: normalize it");
    check_near(smooth_normal({Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, real(0.25), real(0.25),
                             Vec3{1, 1, 1} / std::sqrt(Real(3))),
               Vec3{2, 1, 1} / std::sqrt(Real(6)), "a has the weight 1 - u - v");
}

TEST_CASE("12.3 the normal is the normalized mean anywhere in the triangle", "[12.3]") {
    rt::Rng rng{123, 7};
    for (int i = 0; i < 5000; ++i) {
        const Vec3 flat = any_direction(rng);
        // Nearly the same normals, or clearly different ones.
        const Real side = any_size(rng, -3, 0) / 2;
        const std::array<Vec3, 3> normals{leaning(rng, flat, side), leaning(rng, flat, side),
                                          leaning(rng, flat, side)};
        Real u = rng.uniform(), v = rng.uniform();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const Vec3 sum = (1 - u - v) * normals[0] + u * normals[1] + v * normals[2];
        check_near(smooth_normal(normals, u, v, flat), sum / length_of(sum),
                   "weigh the normals by 1 - u - v, u and v, and scale the sum to length 1, even "
                   "if it is nearly that long");
    }
}

TEST_CASE("12.3 a direction on the correct side stays unchanged", "[12.3]") {
    rt::Rng rng{123, 1};
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 flat = any_direction(rng), smooth = leaning(rng, flat, real(0.5));
        // Any direction, or one that all but runs along the triangle or the smooth surface.
        const Vec3 direction = i < 10'000
                                   ? any_direction(rng)
                                   : at_height(rng, i % 2 == 0 ? flat : smooth, small_height(rng));
        const double above_smooth = exact_dot(direction, smooth),
                     above_flat = exact_dot(direction, flat);
        if (above_smooth * above_flat < 0 ||
            std::min(std::abs(above_smooth), std::abs(above_flat)) < rounding)
            continue;
        const Vec3 kept = keep_side(direction, smooth, flat);
        if (kept == direction) continue;
        HINT(direction, kept,
             "the direction is on the same side of the triangle as of the smooth surface: return "
             "it unchanged");
        REQUIRE(kept == direction);
    }
    SUCCEED();
}

TEST_CASE("12.3 a direction on the wrong side is mirrored at the triangle", "[12.3]") {
    rt::Rng rng{123, 2};
    int mirrored = 0;
    for (int i = 0; i < 40'000; ++i) {
        const Vec3 flat = any_direction(rng), smooth = leaning(rng, flat, real(0.7));
        const Vec3 direction = i < 20'000
                                   ? any_direction(rng)
                                   : at_height(rng, i % 2 == 0 ? flat : smooth, small_height(rng));
        const double above_smooth = exact_dot(direction, smooth),
                     above_flat = exact_dot(direction, flat);
        if (above_smooth * above_flat > 0 ||
            std::min(std::abs(above_smooth), std::abs(above_flat)) < rounding)
            continue;
        ++mirrored;
        check_near(keep_side(direction, smooth, flat),
                   direction - 2 * static_cast<Real>(above_flat) * flat,
                   above_smooth > 0
                       ? "the material reflects this light, but the direction leads through the "
                         "triangle: mirror it at the triangle, with the flat normal"
                       : "the material lets this light through: its direction must lead below the "
                         "triangle");
    }
    CHECK(mirrored > 1000);
}

TEST_CASE("12.3 a normal that mirrors light upward is not bent", "[12.3]") {
    rt::Rng rng{123, 3};
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 flat = any_direction(rng), smooth = leaning(rng, flat, real(0.4));
        const Vec3 incoming = i < 10'000 ? any_direction(rng) : mirrored_low(rng, flat, smooth);
        const Real side = exact_dot(incoming, flat) < 0 ? Real(1) : Real(-1);
        const double height = exact_dot(rt::reflect(incoming, smooth), side * flat);
        if (height < rounding) continue;
        const Vec3 bent = bent_normal(smooth, flat, incoming);
        if (bent == smooth) continue;
        INFO("smooth " << text(smooth) << ", flat " << text(flat) << ", incoming "
                       << text(incoming));
        HINT(smooth, bent,
             "the mirror direction is on the side that the light came from: return the normal "
             "unchanged");
        REQUIRE(bent == smooth);
    }
    SUCCEED();
}

TEST_CASE("12.3 light from below is treated like light from above", "[12.3]") {
    const Vec3 smooth{real(0.6), 0, real(0.8)};
    // From inside of a closed surface, as through glass.
    const Vec3 incoming{0, real(0.6), real(0.8)};
    check_near(bent_normal(smooth, up, incoming), smooth,
               "the light came from below, and the mirror direction is below: return the normal "
               "unchanged");
    const Vec3 grazing{real(-0.8), 0, real(-0.6)};
    check_near(
        keep_side(grazing, smooth, up), grazing,
        "the direction is below the smooth surface and below the triangle: return it unchanged");
}

TEST_CASE("12.3 normals that point into the surface are turned around", "[12.3][hard]") {
    rt::Rng rng{123, 4};
    for (int i = 0; i < 5000; ++i) {
        const Vec3 flat = any_direction(rng);
        std::array<Vec3, 3> normals;
        for (Vec3& normal : normals) normal = leaning(rng, flat, real(0.5));
        const Vec3 expected = smooth_normal(normals, real(0.2), real(0.5), flat);
        for (Vec3& normal : normals) normal = -normal;
        const Vec3 actual = smooth_normal(normals, real(0.2), real(0.5), flat);
        if (actual == expected && exact_dot(actual, flat) > 0) continue;
        HINT(expected, actual,
             "the result must be on the side of flat, whichever way the file's normals point");
        REQUIRE(actual == expected);
        REQUIRE(exact_dot(actual, flat) > 0);
    }
    // If only one of them points inward, the others may still decide.
    const Vec3 leans{real(0.6), 0, real(0.8)};
    check_near(smooth_normal({-up, leans, leans}, real(0.25), real(0.5), up),
               Vec3{real(0.45), 0, real(0.35)} / std::sqrt(real(0.325)),
               "turn the result around, not each normal");
    check_near(smooth_normal({up, -leans, -leans}, real(0.25), real(0.5), up),
               Vec3{real(0.45), 0, real(0.35)} / std::sqrt(real(0.325)),
               "turn the result around if the result is not on the side of flat; the first normal "
               "does not say so");
}

TEST_CASE("12.3 where normals cancel the flat normal is returned", "[12.3][hard]") {
    const Vec3 right{1, 0, 0};
    for (const Vec3 flat : {up, -up, Vec3{real(0.6), real(0.8), 0}})
        check_near(smooth_normal({right, -right, right}, real(0.5), 0, flat), flat,
                   "the sum has length 0 and so no direction: return the flat normal");
    check_near(smooth_normal({Vec3{}, Vec3{}, Vec3{}}, real(0.5), 0, up), up,
               "the sum has length 0 and so no direction: return the flat normal");
    // So little that its square does not count.
    const Real little = std::sqrt(rt::epsilon) / 2;
    check_near(
        smooth_normal({right, {-1, 0, little}, right}, real(0.5), 0, {real(0.6), 0, real(0.8)}), up,
        "the normals nearly cancel, but their sum still has a direction");
}

TEST_CASE("12.3 no direction runs along the triangle itself", "[12.3][hard]") {
    rt::Rng rng{123, 5};
    for (int i = 0; i < 50'000; ++i) {
        const Vec3 flat = any_direction(rng), smooth = leaning(rng, flat, real(0.5));
        // In the triangle's plane, as well as numbers can say.
        const Vec3 any = any_direction(rng);
        Vec3 direction = any - static_cast<Real>(exact_dot(any, flat)) * flat;
        if (length_of(direction) < real(0.5)) continue;
        direction = direction / length_of(direction);
        const Vec3 kept = keep_side(direction, smooth, flat);
        const Real above_flat = kept.x * flat.x + kept.y * flat.y + kept.z * flat.z;
        const Real above_smooth =
            direction.x * smooth.x + direction.y * smooth.y + direction.z * smooth.z;
        const bool right = (above_smooth < 0 ? above_flat < 0 : above_flat > 0) &&
                           rt::max_component(kept - direction) <= 64 * rt::epsilon;
        if (!right) {
            INFO("smooth " << text(smooth) << ", flat " << text(flat) << ", the direction "
                           << text(direction) << " became " << text(kept));
            INFO("the result's dot product with flat is "
                 << text(above_flat) << ", and that of the given direction with smooth is "
                 << text(above_smooth) << ".\nHint: use above_horizon of 05.2");
            REQUIRE(right);
        }
    }
    SUCCEED();
}

TEST_CASE("12.3 a bent normal mirrors light along the triangle", "[12.3][hard]") {
    rt::Rng rng{123, 6};
    int bends = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Vec3 flat = any_direction(rng), smooth = leaning(rng, flat, real(0.9));
        const Vec3 incoming = i < 50'000 ? any_direction(rng) : mirrored_low(rng, flat, smooth);
        const Real side = exact_dot(incoming, flat) < 0 ? Real(1) : Real(-1);
        const double height = exact_dot(rt::reflect(incoming, smooth), side * flat);
        if (height > -rounding || std::abs(exact_dot(incoming, flat)) < 1e-3) continue;
        ++bends;
        const Vec3 bent = bent_normal(smooth, flat, incoming);
        const Vec3 mirrored = rt::reflect(incoming, bent);
        const double now = exact_dot(mirrored, side * flat);
        // Removing the part along flat leaves a few roundings of it. They count more the shorter
        // what is left is, and in the bent normal the nearer that is to `incoming`.
        const Vec3 before = rt::reflect(incoming, smooth);
        const Vec3 sunk = before - static_cast<Real>(height) * side * flat;  // along the triangle
        const Real length = length_of(sunk), turn = length_of(sunk / length - incoming);
        const auto near = static_cast<double>(16 * (1 + 1 / length) * (1 + 1 / turn) * rt::epsilon);
        const bool right = std::abs(now) <= near && exact_dot(bent, flat) > 0 &&
                           std::abs(length_of(bent) - 1) <= 8 * rt::epsilon;
        if (!right) {
            INFO("smooth " << text(smooth) << ", flat " << text(flat) << ", incoming "
                           << text(incoming) << "\nyour normal " << text(bent)
                           << " mirrors it along " << text(mirrored));
            INFO("whose height over the triangle is "
                 << now << "; " EXPECTED "0. With the smooth normal, the height was " << height);
            INFO(
                "Hint: take the mirror direction, remove its part along flat, and find the normal "
                "halfway between that and -incoming");
            REQUIRE(right);
        }
        const double ahead = exact_dot(mirrored, sunk) / static_cast<double>(length);
        // If the light falls on the front of the smooth surface, too, it goes on in the direction
        // that it had, as far as the triangle allows.
        if (exact_dot(incoming, side * smooth) > 0 || ahead > 0) continue;
        INFO("smooth " << text(smooth) << ", flat " << text(flat) << ", incoming " << text(incoming)
                       << "\nthe smooth normal mirrors it along " << text(before)
                       << ", your normal " << text(bent) << " along " << text(mirrored));
        INFO("Hint: the light must not turn back: only the part along flat is removed");
        REQUIRE(ahead > 0);
    }
    CHECK(bends > 1000);
}

TEST_CASE("12.3 light along the triangle still gives a normal", "[12.3][hard]") {
    const Vec3 smooth{real(0.6), 0, real(0.8)};
    for (const Vec3 incoming : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0},
                                Vec3{real(0.8), real(0.6), 0}, Vec3{real(0.6), real(-0.8), 0}}) {
        const Vec3 bent = bent_normal(smooth, up, incoming);
        INFO("incoming " << text(incoming) << ", your normal " << text(bent));
        CHECK(std::abs(length_of(bent) - 1) <= 8 * rt::epsilon);
        CHECK(bent.z > 0);
    }
    check_near(bent_normal(smooth, up, {1, 0, 0}), up, "light that runs along the triangle");
    // A file may say that the surface stands upright on its triangle.
    const Vec3 bent = bent_normal({1, 0, 0}, up, {0, 0, -1});
    INFO("smooth (1, 0, 0), flat (0, 0, 1), incoming (0, 0, -1), your normal " << text(bent));
    INFO("Hint: the mirror direction is straight down, so it has no part along the triangle");
    CHECK(std::abs(length_of(bent) - 1) <= 8 * rt::epsilon);
    CHECK(bent.z > 0);
}
