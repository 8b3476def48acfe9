#include <rt/look_at.hpp>
#include <stdexcept>

#include "checkpoint.hpp"
#include "exact_views.hpp"
#include "vectors.hpp"

using namespace checkpoint;
using rt::Basis;

namespace {

// How far the basis is from three perpendicular unit vectors with u x v = w, in units in the last
// place of 1.
double flaw_in_ulp(const Basis& b) {
    if (!is_finite(b.u) || !is_finite(b.v) || !is_finite(b.w))
        return std::numeric_limits<double>::infinity();
    const Vec3 uv{b.u.y * b.v.z - b.u.z * b.v.y, b.u.z * b.v.x - b.u.x * b.v.z,
                  b.u.x * b.v.y - b.u.y * b.v.x};
    return std::max(
        {length_error_in_ulp(b.u), length_error_in_ulp(b.v), length_error_in_ulp(b.w),
         std::abs(dot_in_double(b.u, b.v)) / static_cast<double>(rt::epsilon),
         std::abs(dot_in_double(b.v, b.w)) / static_cast<double>(rt::epsilon),
         std::abs(dot_in_double(b.w, b.u)) / static_cast<double>(rt::epsilon),
         static_cast<double>(max_component(uv - b.w)) / static_cast<double>(rt::epsilon)});
}

// w carries fewer than 4 roundings and u fewer than 8, half a unit each at most; a product of two
// vectors adds up what both have, and v is one. orthonormal_basis keeps to 8 units.
constexpr double allowed_flaw = 16;

std::string text(const Basis& b) {
    return "u = " + checkpoint::text(b.u) + ", v = " + checkpoint::text(b.v) +
           ", w = " + checkpoint::text(b.w);
}

const char* suggestion(const Basis& b) {
    for (const Vec3 e : {b.u, b.v, b.w})
        if (!is_finite(e))
            return "0 / 0: where the cross product of up and w is zero, call orthonormal_basis(w)";
    for (const Vec3 e : {b.u, b.v, b.w})
        if (length_error_in_ulp(e) > 16)
            return "a vector's length is not 1: cross products need normalize unless both vectors "
                   "have "
                   "length 1 and are perpendicular";
    if (std::abs(dot_in_double(b.v, b.w)) > 16 * static_cast<double>(rt::epsilon))
        return "v is not perpendicular to w: up itself is not v, cross(w, u) is";
    return "u = up x w, v = w x u: the other order points the other way (right hand); where up x w "
           "is "
           "zero, orthonormal_basis(w)";
}

}  // namespace

TEST_CASE("02.3 w points from the target back to the eye", "[02.3]") {
    const Basis b = rt::look_at({1, 2, 10}, {1, 2, 4}, {0, 1, 0});
    INFO("from (1, 2, 10) at (1, 2, 4): expected w = (0, 0, 1), yours gives "
         << checkpoint::text(b.w)
         << ".\nHint: the camera looks along -w, so w = normalize(from - at)");
    CHECK(b.w == Vec3{0, 0, 1});
}

TEST_CASE("02.3 u points right and v up in the picture", "[02.3]") {
    const struct {
        const char* name;
        Vec3 at, u, v;
    } views[] = {{"along -z", {0, 0, -5}, {1, 0, 0}, {0, 1, 0}},
                 {"along +x", {5, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                 {"along +z", {0, 0, 5}, {-1, 0, 0}, {0, 1, 0}},
                 {"along -x", {-5, 0, 0}, {0, 0, -1}, {0, 1, 0}}};
    for (const auto& [name, at, u, v] : views) {
        const Basis b = rt::look_at({0, 0, 0}, at, {0, 1, 0});
        INFO("looking " << name << " with y up: expected u = " << checkpoint::text(u)
                        << ", v = " << checkpoint::text(v) << ", yours gives " << text(b)
                        << ".\nHint: " << suggestion(b));
        CHECK(b.u == u);
        CHECK(b.v == v);
    }
}

TEST_CASE("02.3 up may be slanted and of any length", "[02.3]") {
    for (const Vec3 up : {Vec3{0, 3, 4}, Vec3{0, Real(0.125), -2}, Vec3{0, 1, 100}}) {
        const Basis b = rt::look_at({0, 0, 0}, {0, 0, -2}, up);
        INFO("looking along -z with up " << checkpoint::text(up)
                                         << ": expected u = (1, 0, 0), v = (0, 1, 0), yours gives "
                                         << text(b) << ".\nHint: " << suggestion(b));
        CHECK(b.u == Vec3{1, 0, 0});
        CHECK(b.v == Vec3{0, 1, 0});
    }
}

TEST_CASE("02.3 the vectors are perpendicular with length 1 and right-handed", "[02.3]") {
    for (const auto& row : exact::views()) {
        if (row.nearly_parallel) continue;
        const Basis b = rt::look_at(vec3(row.from), vec3(row.at), vec3(row.up));
        INFO("look_at(" << checkpoint::text(vec3(row.from)) << ", "
                        << checkpoint::text(vec3(row.at)) << ", " << checkpoint::text(vec3(row.up))
                        << ") gives " << text(b) << ".\nHint: " << suggestion(b));
        REQUIRE(flaw_in_ulp(b) <= allowed_flaw);
    }
}

TEST_CASE("02.3 coordinates of any size and a camera a million away", "[02.3][hard]") {
    for (const auto& row : exact::views()) {
        if (row.nearly_parallel) continue;
        const Basis b = rt::look_at(vec3(row.from), vec3(row.at), vec3(row.up));
        INFO("look_at(" << checkpoint::text(vec3(row.from)) << ", "
                        << checkpoint::text(vec3(row.at)) << ", " << checkpoint::text(vec3(row.up))
                        << ")");
        {
            // normalize may be off by 3.5; the difference rounds once, in the component and in
            // the length.
            HINT(row.w, b.w, "w = normalize(from - at), with a normalize that scales");
            REQUIRE(error_in_ulp(b.w, row.w) <= 6);
        }
        {
            // Normalized first, up has 3.5 roundings and w 5.5. A cross product that is at least
            // 1/2 long doubles that; with its own and its normalize these are 24 halves.
            HINT(row.u, b.u, "scale before the cross product: its products must not overflow");
            REQUIRE(error_in_ulp_of_1(b.u, row.u) <= 12);
        }
        HINT(row.v, b.v, "v = cross(w, u)");
        REQUIRE(error_in_ulp_of_1(b.v, row.v) <= 16);
    }
}

TEST_CASE("02.3 a view parallel to up still has a basis", "[02.3][hard]") {
    const Vec3 ups[] = {{0, 1, 0}, {0, 0, -2}, {1, 2, 3}, {Real(0.1), Real(-0.7), Real(0.3)}};
    for (const Vec3 up : ups)
        for (const Real distance : {Real(1), Real(-1), Real(3), Real(64)}) {
            const Vec3 from = distance * up;
            const Basis b = rt::look_at(from, {0, 0, 0}, up);
            INFO("look_at(" << checkpoint::text(from) << ", (0, 0, 0), " << checkpoint::text(up)
                            << ") gives " << text(b) << ".\nHint: " << suggestion(b));
            CHECK(flaw_in_ulp(b) <= allowed_flaw);
            CHECK(dot_in_double(b.w, from) > 0);
        }
}

TEST_CASE("02.3 a view nearly parallel to up keeps its digits", "[02.3][hard]") {
    for (const auto& row : exact::views()) {
        if (!row.nearly_parallel) continue;
        const Basis b = rt::look_at(vec3(row.from), vec3(row.at), vec3(row.up));
        INFO("look_at(" << checkpoint::text(vec3(row.from)) << ", (0, 0, 0), "
                        << checkpoint::text(vec3(row.up)) << ")");
        {
            // The cross product's components are within 2 roundings, which count in the component
            // and in the length, and normalize adds 3.5.
            HINT(row.u, b.u,
                 "the view and up differ in their last digits only: take the cross product "
                 "of up and from - at as they came, before normalize rounds them, and call them "
                 "parallel only where it is zero");
            REQUIRE(error_in_ulp(b.u, row.u) <= 8);
        }
        HINT(row.v, b.v, "v = cross(w, u)");
        REQUIRE(error_in_ulp_of_1(b.v, row.v) <= 8);
        INFO("yours gives " << text(b) << ".\nHint: " << suggestion(b));
        REQUIRE(flaw_in_ulp(b) <= allowed_flaw);
    }
}

TEST_CASE("02.3 nothing to look at and no up are refused", "[02.3][hard]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    INFO(
        "look_at must throw std::domain_error.\nHint: normalize does that for from - at; ask about "
        "up "
        "before you cross it with anything: up == Vec3{} or not is_finite(up)");
    CHECK_THROWS_AS(rt::look_at({1, 2, 3}, {1, 2, 3}, {0, 1, 0}), std::domain_error);
    CHECK_THROWS_AS(rt::look_at({1, 2, 3}, {0, 0, 0}, {0, 0, 0}), std::domain_error);
    CHECK_THROWS_AS(rt::look_at({nan, 2, 3}, {0, 0, 0}, {0, 1, 0}), std::domain_error);
    CHECK_THROWS_AS(rt::look_at({1, 2, 3}, {0, rt::infinity, 0}, {0, 1, 0}), std::domain_error);
    CHECK_THROWS_AS(rt::look_at({1, 2, 3}, {0, 0, 0}, {0, nan, 0}), std::domain_error);
}
