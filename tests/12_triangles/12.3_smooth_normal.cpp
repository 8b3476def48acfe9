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

namespace {

// A triangle with a normal at each corner, and the weights of a point in it.
struct Lifted {
    Triangle triangle;
    std::array<Vec3, 3> normals;
    Real u = 0, v = 0;

    Vec3 lift() const { return rt::lift(triangle, normals, u, v); }
    Real size() const {
        return std::max(rt::max_component(triangle.b - triangle.a),
                        rt::max_component(triangle.c - triangle.a));
    }
    std::string say() const {
        return text(triangle) + " with the normals " + text(normals[0]) + ", " + text(normals[1]) +
               ", " + text(normals[2]) + ", at u = " + text(u) + " and v = " + text(v);
    }
};

// Normals that lean at most this far to the side.
Lifted any_lifted(rt::Rng& rng, Real side) {
    Lifted made{plain_triangle(rng), {}, rng.uniform(), rng.uniform()};
    if (made.u + made.v > 1) made.u = 1 - made.u, made.v = 1 - made.v;
    const ExactVec3 exact = exact_unit(exact_normal(made.triangle));
    const Vec3 flat{static_cast<Real>(exact.x.high), static_cast<Real>(exact.y.high),
                    static_cast<Real>(exact.z.high)};
    for (Vec3& normal : made.normals) normal = leaning(rng, flat, side);
    return made;
}

void check_lift(const Lifted& at, Vec3 expected, const char* hint) {
    const Vec3 actual = at.lift();
    const bool right = rt::max_component(actual - expected) <= 16 * rt::epsilon * at.size();
    if (!right) {
        INFO(at.say());
        HINT(expected, actual, hint);
        REQUIRE(right);
    }
    REQUIRE(right);
}

// The triangle from (-1, 0, 0) to (1, 0, 0) and up to (0, 1, 0).
const Triangle in_plane{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}};

}  // namespace

TEST_CASE("12.3 a triangle whose normals are its own is not lifted", "[12.3]") {
    rt::Rng rng{123, 8};
    for (int i = 0; i < 2000; ++i)
        check_lift(any_lifted(rng, 0), Vec3{},
                   "the triangle is flat, and so is the surface that it stands for");
    check_lift({in_plane, {up, up, up}, real(0.25), real(0.5)}, Vec3{},
               "the triangle is flat, and so is the surface that it stands for");
}

TEST_CASE("12.3 between two corners the lift agrees with the example", "[12.3][hard]") {
    const std::array<Vec3, 3> normals{
        Vec3{real(-0.6), 0, real(0.8)}, {real(0.6), 0, real(0.8)}, {0, 0, 1}};
    check_lift({in_plane, normals, real(0.5), 0}, {0, 0, real(0.48)},
               "P - a is (1, 0, 0), and its dot product with a's normal is -0.6, so the way up to "
               "this plane is 0.6 times the normal. Mix the ways with the weights of the corners");
    check_lift({in_plane, normals, real(0.25), 0}, {0, 0, real(0.36)},
               "each way counts with the weight of its corner: 1 - u - v, u and v");
    check_lift({in_plane, normals, real(0.25), real(0.5)}, {0, 0, real(0.24)},
               "each way counts with the weight of its corner: 1 - u - v, u and v");
}

TEST_CASE("12.3 at a corner nothing is lifted", "[12.3][hard]") {
    rt::Rng rng{123, 9};
    for (int i = 0; i < 3000; ++i) {
        Lifted at = any_lifted(rng, real(0.6));
        at.u = i % 3 == 1 ? Real(1) : Real(0);
        at.v = i % 3 == 2 ? Real(1) : Real(0);
        check_lift(at, Vec3{}, "the corner lies in its own plane, and the others have no weight");
    }
}

TEST_CASE("12.3 a plane below the point lifts nothing", "[12.3][hard]") {
    // A hollow: the normals lean inward.
    const std::array<Vec3, 3> inward{
        Vec3{real(0.6), 0, real(0.8)}, {real(-0.6), 0, real(0.8)}, {0, 0, 1}};
    check_lift({in_plane, inward, real(0.25), real(0.25)}, Vec3{},
               "a point that is above a plane does not go down to it");
    check_lift({in_plane, {inward[0], {real(0.6), 0, real(0.8)}, up}, real(0.5), 0},
               {real(0.18), 0, real(0.24)}, "only the planes that are above the point lift it");
}

TEST_CASE("12.3 the lift is the mean of the ways to three planes anywhere", "[12.3][hard]") {
    rt::Rng rng{123, 10};
    for (int i = 0; i < 50'000; ++i) {
        Lifted at = any_lifted(rng, any_size(rng, -3, 0) * real(0.9));
        // Of any size, and far from the origin. The corners are then rounded, so the exact lift is
        // that of the rounded triangle.
        const Real size = any_size(rng, -9, 9);
        at.triangle = placed(at.triangle, size, size * any_size(rng, -2, 3) * in_cube(rng));
        const std::array<Vec3, 3> corners{at.triangle.a, at.triangle.b, at.triangle.c};
        const auto u = static_cast<double>(at.u), v = static_cast<double>(at.v);
        const std::array<double, 3> weights{1 - u - v, u, v};
        const ExactVec3 a = exact_vector(corners[0]);
        const ExactVec3 point = a + Exact(u) * (exact_vector(corners[1]) - a) +
                                Exact(v) * (exact_vector(corners[2]) - a);
        double x = 0, y = 0, z = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const ExactVec3 normal = exact_vector(at.normals[k]);
            const double below = -dot(point - exact_vector(corners[k]), normal).high;
            if (!(below > 0)) continue;
            x += weights[k] * below * normal.x.high;
            y += weights[k] * below * normal.y.high;
            z += weights[k] * below * normal.z.high;
        }
        check_lift(at, {static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)},
                   "measure the point from each corner, with the edges: far from the origin, the "
                   "corners themselves have fewer digits");
    }
}

TEST_CASE("12.3 a triangle in a ball is lifted out of the ball", "[12.3][hard]") {
    rt::Rng rng{123, 11};
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 middle = any_direction(rng);
        const Real side = real(0.7) * any_size(rng, for_this_precision(-1, -3), 0);
        std::array<Vec3, 3> corners;
        for (Vec3& corner : corners) corner = leaning(rng, middle, side);
        Lifted at{{corners[0], corners[1], corners[2]}, corners, rng.uniform(), rng.uniform()};
        if (at.u + at.v > 1) at.u = 1 - at.u, at.v = 1 - at.v;
        const Vec3 raised = point_of(at.triangle, at.u, at.v) + at.lift();
        const bool right = length_of(raised) >= 1 - 8 * rt::epsilon;
        if (right) continue;
        INFO(at.say() << ": the distance of the raised point from the ball's middle is "
                      << text(length_of(raised)) << "; " EXPECTED "1 or more");
        INFO("Hint: the ball lies below all three planes, and the raised point above it");
        REQUIRE(right);
    }
    SUCCEED();
}
