#include <rt/look_at.hpp>
#include <rt/todo.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "checkpoint.hpp"
#include "random_inputs.hpp"
#include "refusal.hpp"
#include "vectors.hpp"

using namespace checkpoint;
using rt::Basis;

namespace {

std::string text(const Basis& b);
const char* suggestion(const Basis& b);

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

// w carries fewer than 4 roundings and u fewer than 8, half a unit each at most; a product of
// two vectors adds up the errors of both, and v is such a product. orthonormal_basis stays
// within 8 units.
constexpr double allowed_flaw = 16;

struct ExactBasis {
    ExactVec3 u, v, w;
};

// The basis of a view along `back`, which is exact, with any up that is not parallel.
ExactBasis exact_basis(const ExactVec3& back, Vec3 up) {
    const ExactVec3 right = cross(exact_vector(up), back);
    return {exact_unit(right), exact_unit(cross(back, right)), exact_unit(back)};
}

Vec3 scaled(Vec3 v, int exponent) {
    return {std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)};
}

// The sine of the angle between a view along `back` and up.
double sine_of(const ExactVec3& back, Vec3 up) {
    return exact_length(cross(exact_vector(up), back)).high / exact_length(back).high /
           exact_length(exact_vector(up)).high;
}

struct View {
    Vec3 from, at, up;
    ExactBasis exact;
};

// Cameras near and far, tiny and huge, with up of any length: the angle between the view and up is
// at least 30 degrees.
std::vector<View> views_well_apart() {
    const int huge = for_this_precision(96, 661), sizes[] = {0, -huge - 3, huge};
    rt::Rng rng{23, 6};
    const auto any = [&] {
        return Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    };
    std::vector<View> views;
    for (unsigned i = 0; views.size() < 100; ++i) {
        // The target is a unit away, and the camera at times a million units away from the origin.
        const Vec3 from = any() * (i % 4 == 3 ? Real(1e6) : Real(1)), at = from + any(), up = any();
        const ExactVec3 back = exact_vector(from) - exact_vector(at);
        if (!(sine_of(back, up) > 0.5)) continue;
        const int size = i % 4 == 3 ? 0 : sizes[i % 4];
        views.push_back({scaled(from, size), scaled(at, size), scaled(up, sizes[rng() % 3]),
                         exact_basis(back, up)});
    }
    return views;
}

// Cameras that look at the origin, so that no rounding stands between input and angle, almost along
// up.
std::vector<View> views_nearly_parallel() {
    rt::Rng rng{23, 7};
    const auto any = [&] {
        return Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    };
    std::vector<View> views;
    while (views.size() < 100) {
        // Beside an axis, Real can hold much smaller angles.
        const bool is_axis = rng() % 3 == 0;
        const Vec3 up = is_axis ? Vec3{0, 1, 0} : any();
        const int least =
            is_axis ? for_this_precision(-60, -400) : 3 - std::numeric_limits<Real>::digits;
        const Real angle = std::exp2(rng.uniform(Real(least), Real(-4)));
        const Vec3 from = (rng() % 2 == 0 ? Real(-3) : Real(5)) * (up + angle * any());
        if (sine_of(exact_vector(from), up) > 0)
            views.push_back({from, {0, 0, 0}, up, exact_basis(exact_vector(from), up)});
    }
    return views;
}

std::string text(const View& view) {
    return "look_at(" + checkpoint::text(view.from) + ", " + checkpoint::text(view.at) + ", " +
           checkpoint::text(view.up) + ")";
}

std::string refusal(Vec3 from, Vec3 at, Vec3 up) {
    return checkpoint::refusal([&] { rt::look_at(from, at, up); });
}

std::string text(const Basis& b) {
    return "u = " + checkpoint::text(b.u) + ", v = " + checkpoint::text(b.v) +
           ", w = " + checkpoint::text(b.w);
}

const char* suggestion(const Basis& b) {
    for (const Vec3 e : {b.u, b.v, b.w})
        if (!is_finite(e))
            return "your code divides 0 by 0: if the cross product of up and w is zero, call "
                   "orthonormal_basis(w)";
    for (const Vec3 e : {b.u, b.v, b.w})
        if (length_error_in_ulp(e) > 16)
            return "a vector's length is not 1: normalize a cross product unless its two vectors "
                   "have length 1 and are perpendicular";
    if (std::abs(dot_in_double(b.v, b.w)) > 16 * static_cast<double>(rt::epsilon))
        return "v is not perpendicular to w: v is cross(w, u), not up itself";
    return "u = up x w and v = w x u; in the other order, the result points the other way "
           "(right-hand rule). If up x w is zero, call orthonormal_basis(w)";
}

}  // namespace

TEST_CASE("02.3 w points from the target back to the eye", "[02.3]") {
    const Basis b = rt::look_at({1, 2, 10}, {1, 2, 4}, {0, 1, 0});
    INFO("from (1, 2, 10) at (1, 2, 4): " EXPECTED "w = (0, 0, 1), " ACTUAL
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
        INFO("looking " << name << " with y up: " EXPECTED "u = " << checkpoint::text(u)
                        << ", v = " << checkpoint::text(v) << ", " ACTUAL << text(b)
                        << ".\nHint: " << suggestion(b));
        CHECK(b.u == u);
        CHECK(b.v == v);
    }
}

TEST_CASE("02.3 up may be slanted and of any length", "[02.3]") {
    for (const Vec3 up : {Vec3{0, 3, 4}, Vec3{0, Real(0.125), -2}, Vec3{0, 1, 100}}) {
        const Basis b = rt::look_at({0, 0, 0}, {0, 0, -2}, up);
        INFO("looking along -z with up " << checkpoint::text(up)
                                         << ": " EXPECTED "u = (1, 0, 0), v = (0, 1, 0), " ACTUAL
                                         << text(b) << ".\nHint: " << suggestion(b));
        CHECK(b.u == Vec3{1, 0, 0});
        CHECK(b.v == Vec3{0, 1, 0});
    }
}

TEST_CASE("02.3 a camera that looks steeply up or down and one with a tiny up have a basis",
          "[02.3]") {
    const auto check = [](Vec3 at, Vec3 up) {
        const ExactBasis exact = exact_basis(exact_vector(-at), up);
        const Basis b = rt::look_at({0, 0, 0}, at, up);
        INFO("look_at((0, 0, 0), " << checkpoint::text(at) << ", " << checkpoint::text(up)
                                   << "): " ACTUAL << text(b)
                                   << ", " EXPECTED "u = " << checkpoint::text(exact.u)
                                   << ".\nHint: only if up x w is exactly zero is there no plane");
        CHECK(error_in_ulp_of_1(b.u, exact.u) <= 32 / sine_of(exact_vector(at), up));
    };
    for (const Real down : {Real(16), Real(-16), Real(100), Real(-300)})
        check({1, -down, 2}, {0, 1, 0});
    for (const int power : {-40, -20, 20, 40}) check({3, 1, -4}, scaled({1, 2, 2}, power));
}

TEST_CASE("02.3 a camera that looks straight up or down has a basis", "[02.3]") {
    for (const Vec3 axis : {Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}})
        for (const Real height : {-4, -1, 1, 4}) {
            const Vec3 at{2, 0, 3}, up = 2 * axis;
            const Basis b = [&] {
                INFO(
                    "Hint: here up x w is zero and cannot be normalized: test for that, and return "
                    "orthonormal_basis(w)");
                return rt::look_at(at + height * axis, at, up);
            }();
            INFO("up is " << checkpoint::text(up) << ", and the view is the same vector times "
                          << -height / 2 << "; actual " << text(b) << ".\nHint: " << suggestion(b));
            REQUIRE(flaw_in_ulp(b) <= allowed_flaw);
            CHECK(b.w == (height > 0 ? axis : -axis));
        }
}

TEST_CASE("02.3 the basis is orthonormal and right-handed", "[02.3]") {
    for (const View& view : views_well_apart()) {
        const Basis b = rt::look_at(view.from, view.at, view.up);
        INFO(text(view) << " gives " << text(b) << ".\nHint: " << suggestion(b));
        REQUIRE(flaw_in_ulp(b) <= allowed_flaw);
    }
}

TEST_CASE("02.3 the basis is correct for any view and any up", "[02.3]") {
    rt::Rng rng{23, 1};
    int tried = 0;
    for (int i = 0; i < 600; ++i) {
        const Vec3 from = any_vector(rng, -1, 1), at = any_vector(rng, -1, 1),
                   up = any_vector(rng, -2, 2);
        const ExactVec3 back = exact_vector(from) - exact_vector(at);
        const double sine = sine_of(back, up);
        if (!(sine > 0.1)) continue;  // otherwise there is no view or no up
        ++tried;
        const ExactBasis exact = exact_basis(back, up);
        const Basis b = rt::look_at(from, at, up);
        INFO("look_at(" << checkpoint::text(from) << ", " << checkpoint::text(at) << ", "
                        << checkpoint::text(up) << ") gives " << text(b) << ", " EXPECTED "u = "
                        << checkpoint::text(exact.u) << ", v = " << checkpoint::text(exact.v)
                        << ", w = " << checkpoint::text(exact.w) << ".\nHint: " << suggestion(b));
        REQUIRE(error_in_ulp_of_1(b.w, exact.w) <= 6);
        // The error of a cross product of vectors that were normalized first is
        // divided by the sine.
        REQUIRE(error_in_ulp_of_1(b.u, exact.u) <= 16 / sine);
        REQUIRE(error_in_ulp_of_1(b.v, exact.v) <= 20 / sine);
    }
    REQUIRE(tried > 300);
}

TEST_CASE("02.3 the basis is accurate for coordinates of any size and distant cameras",
          "[02.3][hard]") {
    for (const View& view : views_well_apart()) {
        const Basis b = rt::look_at(view.from, view.at, view.up);
        INFO(text(view));
        {
            // normalize may be off by 3.5; the difference rounds once, in the component
            // and in the length.
            HINT(view.exact.w, b.w,
                 "w = normalize(from - at); normalize must scale a very long or short vector");
            REQUIRE(error_in_ulp(b.w, view.exact.w) <= 6);
        }
        {
            // Normalized first, up has 3.5 roundings and w 5.5. A cross product that is at
            // least 1/2 long doubles that; with its own roundings and those of normalize,
            // these are 24 halves.
            HINT(view.exact.u, b.u,
                 "scale before the cross product, so that its products do not overflow");
            REQUIRE(error_in_ulp_of_1(b.u, view.exact.u) <= 12);
        }
        HINT(view.exact.v, b.v, "v = cross(w, u)");
        REQUIRE(error_in_ulp_of_1(b.v, view.exact.v) <= 16);
    }
}

TEST_CASE("02.3 the basis is accurate for the smallest and the largest up", "[02.3][hard]") {
    constexpr int lowest =
                      std::numeric_limits<Real>::min_exponent - std::numeric_limits<Real>::digits,
                  highest = std::numeric_limits<Real>::max_exponent - 5;
    rt::Rng rng{23, 4};
    const auto whole = [&] { return std::floor(rng.uniform(-9, 10)); };
    for (int i = 0; i < 200; ++i) {
        const Vec3 up{whole(), whole(), whole()}, from = any_vector(rng, -1, 1);
        const ExactVec3 right = cross(exact_vector(up), exact_vector(from));
        if (!(exact_length(right).high > 0)) continue;
        const ExactBasis exact = exact_basis(exact_vector(from), up);
        const Vec3 upwards = scaled(up, i % 2 == 0 ? lowest : highest);
        const Basis b = rt::look_at(from, {0, 0, 0}, upwards);
        INFO("look_at(" << checkpoint::text(from) << ", (0, 0, 0), " << checkpoint::text(upwards)
                        << ")");
        HINT(exact.u, b.u, "scale `up`, too, before the cross product");
        REQUIRE(error_in_ulp(b.u, exact.u) <= 8);
        REQUIRE(flaw_in_ulp(b) <= allowed_flaw);
    }
}

TEST_CASE("02.3 the distance from camera to target may exceed the largest number", "[02.3][hard]") {
    constexpr int highest = std::numeric_limits<Real>::max_exponent;
    rt::Rng rng{23, 5};
    int tried = 0;
    for (int i = 0; i < 400; ++i) {
        // At least one coordinate of their difference is too large for Real.
        const auto any = [&] { return rng.uniform(-1, 1); };
        Vec3 from{any(), any(), any()}, at{any(), any(), any()};
        (i % 3 == 0 ? from.x : i % 3 == 1 ? from.y : from.z) = 1 - rt::epsilon;
        (i % 3 == 0 ? at.x : i % 3 == 1 ? at.y : at.z) = -rng.uniform(real(0.1), 1);
        if (i % 2 == 0) std::swap(from, at);
        const Vec3 up{any(), any(), any()};
        const ExactVec3 back = exact_vector(from) - exact_vector(at);
        const double sine = sine_of(back, up);
        if (!(sine > 0.5)) continue;
        ++tried;
        const ExactBasis exact = exact_basis(back, up);
        const Vec3 eye = scaled(from, highest), target = scaled(at, highest);
        INFO("look_at(" << checkpoint::text(eye) << ", " << checkpoint::text(target) << ", "
                        << checkpoint::text(up) << ")");
        {
            INFO(
                "All of these numbers are finite, so there is a view.\nHint: from - at is too "
                "large for a Real; from / 2 - at / 2 points the same way");
            REQUIRE(refusal(eye, target, up) == "nothing was thrown");
        }
        const Basis b = rt::look_at(eye, target, up);
        {
            HINT(exact.w, b.w, "if from - at is not finite, use normalize(from / 2 - at / 2)");
            REQUIRE(error_in_ulp_of_1(b.w, exact.w) <= 6);
        }
        HINT(exact.u, b.u, "scale both `up` and the difference, and then take their cross product");
        REQUIRE(error_in_ulp_of_1(b.u, exact.u) <= 12);
        REQUIRE(flaw_in_ulp(b) <= allowed_flaw);
    }
    REQUIRE(tried > 100);
}

TEST_CASE("02.3 a view parallel to up still has a basis", "[02.3][hard]") {
    // Whole numbers, so that the two are exactly parallel, of any lengths.
    rt::Rng rng{23, 2};
    const auto whole = [&] { return std::floor(rng.uniform(-4, 5)); };
    const auto any_power = [&](int most) {
        return static_cast<int>(rng() % static_cast<unsigned>(2 * most)) - most;
    };
    const int far = for_this_precision(90, 900);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 up{whole(), whole(), whole()};
        const Real distance = whole();
        if (up == Vec3{} || distance == 0) continue;
        const Vec3 at{whole(), whole(), whole()}, from = at + distance * up;
        const int size = any_power(far);
        const Vec3 eye = scaled(from, size), target = scaled(at, size);
        const Vec3 upwards = scaled(up, any_power(far));
        const Basis b = rt::look_at(eye, target, upwards);
        INFO("look_at(" << checkpoint::text(eye) << ", " << checkpoint::text(target) << ", "
                        << checkpoint::text(upwards) << ") gives " << text(b)
                        << ".\nHint: " << suggestion(b));
        REQUIRE(flaw_in_ulp(b) <= allowed_flaw);
        REQUIRE(error_in_ulp_of_1(b.w, exact_unit(exact_vector(distance * up))) <= 6);
    }
}

TEST_CASE("02.3 the basis is accurate for a view nearly parallel to up", "[02.3][hard]") {
    for (const View& view : views_nearly_parallel()) {
        const Basis b = rt::look_at(view.from, view.at, view.up);
        INFO(text(view));
        {
            // The cross product's components are within 2 roundings, which count in the component
            // and in the length, and normalize adds 3.5.
            HINT(view.exact.u, b.u,
                 "the view and up differ only in their last digits: take the cross product of up "
                 "and from - at as given, before normalize rounds them; the two are parallel only "
                 "if this product is zero");
            REQUIRE(error_in_ulp(b.u, view.exact.u) <= 8);
        }
        HINT(view.exact.v, b.v, "v = cross(w, u)");
        REQUIRE(error_in_ulp_of_1(b.v, view.exact.v) <= 8);
        INFO("your basis is " << text(b) << ".\nHint: " << suggestion(b));
        REQUIRE(flaw_in_ulp(b) <= allowed_flaw);
    }
}

TEST_CASE("02.3 even the smallest angle between view and up determines the basis", "[02.3][hard]") {
    // Two whole numbers that differ by 1 make the smallest angle there is; scaling by a power of
    // two rounds nothing.
    rt::Rng rng{23, 3};
    const Real most = for_this_precision<Real>(0x1p23, 0x1p52);
    const int far = for_this_precision(60, 600);
    const auto any_power = [&] {
        return static_cast<int>(rng() % static_cast<unsigned>(2 * far)) - far;
    };
    for (int i = 0; i < 600; ++i) {
        const auto whole = [&] { return std::floor(rng.uniform(-most, most)); };
        const auto step = [&] { return std::floor(rng.uniform(-1, 2) * (i % 3 == 0 ? 1 : 1000)); };
        const Vec3 up{whole(), whole(), whole()}, back = up + Vec3{step(), step(), step()};
        const Vec3 from = i % 2 == 0 ? back : -back;
        const ExactVec3 right = cross(exact_vector(up), exact_vector(from));
        if (right.x.high == 0 && right.y.high == 0 && right.z.high == 0) continue;
        const ExactBasis exact = exact_basis(exact_vector(from), up);
        const Vec3 eye = scaled(from, any_power()), upwards = scaled(up, any_power());
        const Basis b = rt::look_at(eye, {0, 0, 0}, upwards);
        INFO("look_at(" << checkpoint::text(eye) << ", (0, 0, 0), " << checkpoint::text(upwards)
                        << ")");
        HINT(exact.u, b.u,
             "no angle is so small that it counts as parallel: up and the view are parallel only "
             "if the cross product of up and from - at, scaled but not normalized, is exactly "
             "zero");
        REQUIRE(error_in_ulp(b.u, exact.u) <= 8);
        REQUIRE(flaw_in_ulp(b) <= allowed_flaw);
    }
}

TEST_CASE("02.3 even the smallest distance is a view", "[02.3][hard]") {
    const Real tiny = std::numeric_limits<Real>::denorm_min();
    for (const Real far : {Real(0), std::numeric_limits<Real>::max()}) {
        INFO("from (" << far << ", 0, " << tiny << ") at (" << far << ", 0, 0)");
        REQUIRE(refusal({far, 0, tiny}, {far, 0, 0}, {0, 1, 0}) == "nothing was thrown");
        CHECK(rt::look_at({far, 0, tiny}, {far, 0, 0}, {0, 1, 0}).w == Vec3{0, 0, 1});
        CHECK(rt::look_at({far, 0, tiny}, {far, 0, 0}, {0, 1, 0}).u == Vec3{1, 0, 0});
    }
}

TEST_CASE("02.3 look_at refuses a view without a direction or without an up", "[02.3][hard]") {
    INFO(
        "look_at must throw std::domain_error.\nHint: normalize throws it if from - at has no "
        "direction; check `up` yourself before the cross product, and throw if up == Vec3{} or "
        "!is_finite(up)");
    const Vec3 from{1, 2, 3}, at{4, -5, 6}, up{0, 1, 0};
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const Real huge = for_this_precision<Real>(Real(1e30), Real(1e300));
    CHECK(refusal(from, from, up) == "std::domain_error");
    CHECK(refusal(huge * from, huge * from, up) == "std::domain_error");
    CHECK(refusal(from / huge, from / huge, up) == "std::domain_error");
    CHECK(refusal(from, at, {0, 0, 0}) == "std::domain_error");
    CHECK(refusal(from, at, {Real(-0.0), 0, Real(-0.0)}) == "std::domain_error");
    for (const Real bad : {rt::infinity, -rt::infinity, nan})
        for (const Vec3 add : {Vec3{bad, 0, 0}, Vec3{0, bad, 0}, Vec3{0, 0, bad}}) {
            INFO(checkpoint::text(bad) << " is a component of from, at or up");
            CHECK(refusal(from + add, at, up) == "std::domain_error");
            CHECK(refusal(from, at + add, up) == "std::domain_error");
            CHECK(refusal(from, at, up + add) == "std::domain_error");
        }
}
