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

// w itself is a unit vector only within 3.5 epsilon; building u and v adds at most 9 roundings.
void check_basis(Vec3 w) {
    const rt::Basis basis = rt::orthonormal_basis(w);
    const auto& [u, v, kept] = basis;
    const double allowed = 8;
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
    check_basis({1, 0, 0});
    check_basis({0, 1, 0});
    check_basis({0, 0, 1});
    check_basis({real(-0.48), real(0.6), real(-0.64)});  // x is the smallest
    check_basis({real(0.6), real(-0.8), 0});
}

TEST_CASE("01.8 the basis is orthonormal for every axis and its opposite", "[01.8][hard]") {
    for (const Real zero : {real(0.0), real(-0.0)})
        for (const Real one : {real(1.0), real(-1.0)}) {
            check_basis({one, zero, zero});
            check_basis({zero, one, zero});
            check_basis({zero, zero, one});
        }
}

TEST_CASE("01.8 the basis is orthonormal for 10000 directions and close to the axes",
          "[01.8][hard]") {
    rt::Rng rng{7, 1};
    const auto component = [&] { return rng.uniform(-1, 1); };
    for (int i = 0; i < 10000; ++i)
        check_basis(rt::normalize({component(), component(), component()}));
    for (int i = 0; i < 2000; ++i) {  // a little off an axis
        const Real aside = std::pow(Real(10), rng.uniform(-4, -1)), pole = i % 2 == 0 ? 1 : -1;
        const Real x = aside * component(), y = aside * component();
        check_basis(rt::normalize(i % 6 < 2   ? Vec3{pole, x, y}
                                  : i % 6 < 4 ? Vec3{x, pole, y}
                                              : Vec3{x, y, pole}));
    }
    for (Real tiny = 1; tiny > 0; tiny /= 4)
        for (const Real pole : {real(1.0), real(-1.0)}) {
            check_basis(rt::normalize({tiny * component(), tiny * component(), pole}));
            check_basis(rt::normalize({tiny * component(), pole, tiny * component()}));
            check_basis(rt::normalize({pole, tiny * component(), tiny * component()}));
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
                check_basis(rt::normalize(w));
                const Real little = std::pow(Real(10), rng.uniform(-15, -1));
                check_basis(rt::normalize(w + any_vector(rng, -1, 0) * little));
            }
}
