#include <rt/todo.hpp>
#include <rt/viewport.hpp>
#include <stdexcept>
#include <string>

#include "checkpoint.hpp"
#include "exact_functions.hpp"
#include "random_inputs.hpp"
#include "refusal.hpp"

using namespace checkpoint;

namespace {

// tan is within 1 unit in the last place in the usual libraries, and within 2 in all known ones; a
// sine divided by a cosine is within 4. Halving and doubling are exact.
constexpr double allowed_height = 4;
// Four units in the last place may grow to eight in a product, which rounds once more.
constexpr double allowed_width = 9;

// Both sides for an angle and a ratio, given the exact height.
void check_viewport(Real fov, Real aspect, Exact exact_height) {
    const rt::Viewport viewport = rt::viewport_size(fov, aspect);
    INFO("viewport_size(" << text(fov) << ", " << text(aspect) << ")");
    {
        INFO("height");
        HINT(exact_height, viewport.height,
             "2 std::tan(vertical_fov / 2) is accurate at every angle; a formula of your own may "
             "not be");
        REQUIRE(error_in_ulp(viewport.height, exact_height) <= allowed_height);
    }
    const Exact exact_width = exact_height * Exact(aspect);
    INFO("width");
    HINT(exact_width, viewport.width,
         "the width is the height times the aspect ratio; compute with Real throughout");
    REQUIRE(error_in_ulp(viewport.width, exact_width) <= allowed_width);
}

void check_viewport(Real fov, Real aspect) {
    check_viewport(fov, aspect, Exact(2) * exact_tangent_of_half(static_cast<double>(fov)));
}

// Angles in degrees, from a thousandth to 179.9.
template <class Check>
void for_angles(Check check) {
    for (const Real degrees :
         {0.001, 0.01, 0.1, 1.0, 20.0, 45.0, 50.0, 60.0, 90.0, 120.0, 140.0, 170.0, 179.0, 179.9})
        check(degrees);
    rt::Rng rng{22, 3};
    for (int i = 0; i < 300; ++i) check(std::abs(any_number(rng, -3, real(2.2))));
    for (int i = 0; i < 200; ++i) check(180 - std::abs(any_number(rng, -1, real(1.5))));
}

Real radians(Real degrees) {
    return degrees * (rt::pi / 180);
}

// What a call throws, in words.
std::string refusal(Real fov, Real aspect) {
    return checkpoint::refusal([&] { rt::viewport_size(fov, aspect); });
}

const char* suggestion(double degrees, double computed, double exact) {
    const double radians = degrees * 3.14159265 / 180;
    const auto is = [&](double value) {
        return std::abs(computed - value) <= 1e-5 * std::abs(value);
    };
    if (is(exact / 2))
        return "your height is half of the right one: the triangle reaches only from the middle to "
               "the edge";
    if (is(2 * std::tan(radians))) return "the triangle has only half of the angle";
    if (is(2 * std::sin(radians / 2))) return "opposite over adjacent is the tangent, not the sine";
    if (is(2 * std::tan(radians / 2 * 3.14159265 / 180)) || is(2 * std::tan(degrees / 2)))
        return "the angle is given in radians, and std::tan takes radians";
    if (computed == 0)
        return "1 / 2 is 0 in C++, because it is a quotient of whole numbers: write / 2";
    return "the height is 2 tan(vertical_fov / 2); a Viewport has its width first, and then its "
           "height";
}

}  // namespace

TEST_CASE("02.2 the height is twice the tangent of half the angle", "[02.2]") {
    for_angles([](Real degrees) {
        if (degrees < 20 || degrees > 140) return;
        const Real fov = radians(degrees);
        const Exact expected = Exact(2) * exact_tangent_of_half(static_cast<double>(fov));
        const Real height = rt::viewport_size(fov, 1).height;
        INFO("the height for a field of view of " << degrees << " degrees, "
                                                  << checkpoint::text(fov) << " radians");
        HINT(expected, height,
             suggestion(static_cast<double>(degrees), static_cast<double>(height), expected.high));
        REQUIRE(error_in_ulp(height, expected) <= allowed_height);
    });
}

TEST_CASE("02.2 the width is the height times the aspect ratio", "[02.2]") {
    for (const Real aspect : {Real(0.25), Real(1), Real(1.7), Real(2), Real(16)}) {
        const rt::Viewport viewport = rt::viewport_size(Real(1), aspect);
        INFO("aspect ratio "
             << text(aspect) << ": your viewport is " << text(viewport.width) << " wide and "
             << text(viewport.height)
             << " high.\nHint: the field of view is vertical: compute the height from it, and the "
                "width from the height. The aspect ratio is width / height, and the result is "
                "{width, "
                "height}, in this order");
        const Exact expected = Exact(aspect) * Exact(viewport.height);
        CHECK(error_in_ulp(viewport.width, expected) <= 1);
    }
}

TEST_CASE("02.2 the height does not depend on the aspect ratio", "[02.2]") {
    const Real narrow = rt::viewport_size(Real(1), Real(0.5)).height;
    const Real wide = rt::viewport_size(Real(1), Real(2)).height;
    INFO("aspect ratios 0.5 and 2: " EXPECTED "the same height for both, " ACTUAL
         << text(narrow) << " and " << text(wide) << ".\nHint: the field of view is vertical");
    CHECK(error_in_ulp(narrow, Exact(wide)) <= allowed_height);
}

TEST_CASE("02.2 height and width are accurate to 4 and 9 units in the last place at any angle",
          "[02.2][hard]") {
    rt::Rng rng{22, 1};
    for_angles([&](Real degrees) {
        for (const Real aspect : {Real(1), Real(1.5), Real(1e-4), Real(1e4)})
            check_viewport(radians(degrees), aspect);
        check_viewport(radians(degrees), std::abs(any_number(rng, -20, 20)));
    });
}

TEST_CASE("02.2 height and width are as accurate for extreme angles and aspect ratios",
          "[02.2][hard]") {
    const Real smallest = std::numeric_limits<Real>::denorm_min();
    const Real largest = std::numeric_limits<Real>::max();
    constexpr Real low = for_this_precision<Real>(-30, -250);
    rt::Rng rng{22, 2};
    for (int i = 0; i < 500; ++i) {
        const Real fov = std::abs(any_number(rng, low, -5)),
                   some = std::abs(any_number(rng, -3, 3));
        check_viewport(fov, some);
        check_viewport(Real(0x1p-20), std::abs(any_number(rng, low, -low)));
    }
    check_viewport(smallest, 1, Exact(smallest));
    check_viewport(Real(0x1p-20), largest);
    for (Real step = rt::epsilon; step < Real(1e-5); step *= 2)
        check_viewport(std::nextafter(rt::pi - step, Real(0)), 1);
}

TEST_CASE("02.2 an angle of 0 or 180 degrees or NaN is refused", "[02.2][hard]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const Real smallest = std::numeric_limits<Real>::denorm_min();
    for (const Real fov :
         {Real(0), Real(-0.0), -smallest, Real(-1), rt::pi, std::nextafter(rt::pi, Real(4)),
          4 * rt::pi, rt::infinity, -rt::infinity, nan}) {
        INFO("viewport_size("
             << text(fov)
             << ", 1) must throw std::domain_error.\nHint: test for a valid angle and throw "
                "otherwise; a comparison with NaN is always false");
        CHECK(refusal(fov, 1) == "std::domain_error");
    }
}

TEST_CASE("02.2 an aspect ratio that is not a positive number is refused", "[02.2][hard]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const Real smallest = std::numeric_limits<Real>::denorm_min();
    for (const Real aspect :
         {Real(0), Real(-0.0), -smallest, Real(-1), rt::infinity, -rt::infinity, nan}) {
        INFO("viewport_size(1, " << text(aspect)
                                 << ") must throw std::domain_error.\nHint: test the ratio as you "
                                    "test the angle, with the limits 0 and infinity");
        CHECK(refusal(1, aspect) == "std::domain_error");
    }
}
