#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/rng.hpp>

#include "checkpoint.hpp"
#include "random_inputs.hpp"

using namespace checkpoint;

namespace {

// How far a . b is from what it should be, in epsilon.
double dot_error(Vec3 a, Vec3 b, double expected) {
    const Exact dot = Exact(a.x) * Exact(b.x) + Exact(a.y) * Exact(b.y) + Exact(a.z) * Exact(b.z);
    return std::abs((dot - Exact(expected)).high) / static_cast<double>(rt::epsilon);
}

// What the star allows, in epsilon: w itself is a unit vector only within 3.5 epsilon; building u
// and v adds at most 9 roundings. And what is plainly right.
constexpr double accurate = 8, plain = 100;

void check_basis(Vec3 w, double allowed) {
    const rt::Basis basis = rt::orthonormal_basis(w);
    const auto& [u, v, kept] = basis;
    INFO("orthonormal_basis(" << text(w) << ") gives u = " << text(u) << ", v = " << text(v)
                              << ". (The numbers below are in units of epsilon.)");
    {
        const double moved = static_cast<double>(max_component(kept - w) / rt::epsilon);
        INFO(EXPECTED "the third vector to be w itself, " ACTUAL << text(kept));
        REQUIRE(moved <= 4);  // normalized once more, it may move a little
    }
    {
        INFO(
            "Hint: " << (std::isnan(u.x) || std::isnan(v.x)
                             ? "NaN comes from dividing by 0, as when you normalize a zero vector: "
                               "axis x w is zero if the axis is parallel to w. Compare absolute "
                               "values to choose the axis"
                             : "u and v must have length 1; if w.z is near -1, 1 + w.z has lost "
                               "its digits"));
        REQUIRE(dot_error(u, u, 1) <= allowed);
        REQUIRE(dot_error(v, v, 1) <= allowed);
    }
    {
        INFO("Hint: any two of u, v, w must be perpendicular");
        REQUIRE(dot_error(u, v, 0) <= allowed);
        REQUIRE(dot_error(u, w, 0) <= allowed);
        REQUIRE(dot_error(v, w, 0) <= allowed);
    }
    // u x v is w or -w by now; its dot product with w tells which.
    const Vec3 cross{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    INFO("Hint: u x v must be w; if it is -w, swap u and v or negate one of them");
    REQUIRE(cross.x * w.x + cross.y * w.y + cross.z * w.z > 0);
}

}  // namespace

TEST_CASE("01.8 the basis is orthonormal and right-handed", "[01.8]") {
    check_basis({1, 0, 0}, plain);
    check_basis({0, 1, 0}, plain);
    check_basis({0, 0, 1}, plain);
    check_basis({real(-0.48), real(0.6), real(-0.64)}, plain);  // x is the smallest
    check_basis({real(0.6), real(-0.8), 0}, plain);
}

TEST_CASE("01.8 the basis is orthonormal for every axis and its opposite", "[01.8]") {
    for (const Real zero : {real(0.0), real(-0.0)})
        for (const Real one : {real(1.0), real(-1.0)}) {
            check_basis({one, zero, zero}, plain);
            check_basis({zero, one, zero}, plain);
            check_basis({zero, zero, one}, plain);
        }
}

TEST_CASE("01.8 the basis is orthonormal for directions of all kinds", "[01.8]") {
    rt::Rng rng{7, 3};
    const auto component = [&] { return rng.uniform(-1, 1); };
    for (int i = 0; i < 500; ++i)
        check_basis(rt::normalize({component(), component(), component()}), plain);
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0)
                    check_basis(rt::normalize({real(x), real(y), real(z)}), plain);
    // Close to an axis.
    for (const Real off : {real(0.1), real(0.03)})
        for (const Real pole : {Real(1), Real(-1)}) {
            check_basis(rt::normalize({pole, off, off / 2}), plain);
            check_basis(rt::normalize({off, pole, off / 2}), plain);
            check_basis(rt::normalize({off, off / 2, pole}), plain);
        }
}

TEST_CASE("01.8 the basis is orthonormal for 10000 directions and close to the axes",
          "[01.8][hard]") {
    rt::Rng rng{7, 1};
    const auto component = [&] { return rng.uniform(-1, 1); };
    for (int i = 0; i < 10000; ++i)
        check_basis(rt::normalize({component(), component(), component()}), accurate);
    for (int i = 0; i < 2000; ++i) {  // a little off an axis
        const Real aside = std::pow(Real(10), rng.uniform(-4, -1)), pole = i % 2 == 0 ? 1 : -1;
        const Real x = aside * component(), y = aside * component();
        check_basis(rt::normalize(i % 6 < 2   ? Vec3{pole, x, y}
                                  : i % 6 < 4 ? Vec3{x, pole, y}
                                              : Vec3{x, y, pole}),
                    accurate);
    }
    for (Real tiny = 1; tiny > 0; tiny /= 4)
        for (const Real pole : {real(1.0), real(-1.0)}) {
            check_basis(rt::normalize({tiny * component(), tiny * component(), pole}), accurate);
            check_basis(rt::normalize({tiny * component(), pole, tiny * component()}), accurate);
            check_basis(rt::normalize({pole, tiny * component(), tiny * component()}), accurate);
        }
}

TEST_CASE("01.8 the basis is orthonormal for whole-number directions and their neighbors",
          "[01.8][hard]") {
    rt::Rng rng{7, 2};
    for (int x = -3; x <= 3; ++x)
        for (int y = -3; y <= 3; ++y)
            for (int z = -3; z <= 3; ++z) {
                if (x == 0 && y == 0 && z == 0) continue;
                const Vec3 w{real(x), real(y), real(z)};
                check_basis(rt::normalize(w), accurate);
                const Real little = std::pow(Real(10), rng.uniform(-15, -1));
                check_basis(rt::normalize(w + any_vector(rng, -1, 0) * little), accurate);
            }
}
