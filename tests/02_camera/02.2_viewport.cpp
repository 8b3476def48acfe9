#include <rt/viewport.hpp>
#include <stdexcept>

#include "checkpoint.hpp"
#include "exact_viewports.hpp"

using namespace checkpoint;

namespace {

// tan is within 1 unit in the last place in the usual libraries, and within 2 in all that are
// known. Halving and doubling are exact.
constexpr double allowed_height = 2;
// Two units in the last place may grow to four in a product, which rounds once more.
constexpr double allowed_width = 4.5;

const char* suggestion(double degrees, double computed, double exact) {
    const double radians = degrees * 3.14159265 / 180;
    const auto is = [&](double value) {
        return std::abs(computed - value) <= 1e-5 * std::abs(value);
    };
    if (is(exact / 2))
        return "that is half of it: the triangle reaches from the middle to the edge";
    if (is(2 * std::tan(radians))) return "the triangle has only half of the angle";
    if (is(2 * std::sin(radians / 2))) return "opposite by adjacent is the tangent, not the sine";
    if (is(2 * std::tan(radians / 2 * 3.14159265 / 180)) || is(2 * std::tan(degrees / 2)))
        return "the angle comes in radians, and std::tan takes radians";
    if (computed == 0) return "1 / 2 is 0 in C++, a quotient of whole numbers: write / 2";
    return "2 tan(vertical_fov / 2); a Viewport lists its width first, then its height";
}

}  // namespace

TEST_CASE("02.2 the height is twice the tangent of half of the angle", "[02.2]") {
    for (const auto& row : exact::viewports()) {
        if (row.degrees < 20 || row.degrees > 140) continue;
        const Real fov = real(row.vertical_fov);
        const Real height = rt::viewport_size(fov, 1).height;
        INFO("the height for a field of view of " << row.degrees << " degrees, " << text(fov)
                                                  << " radians");
        HINT(row.height, height,
             suggestion(row.degrees, static_cast<double>(height), row.height.high));
        REQUIRE(error_in_ulp(height, row.height) <= allowed_height);
    }
}

TEST_CASE("02.2 the width is the height times the aspect ratio", "[02.2]") {
    for (const Real aspect : {Real(0.25), Real(1), Real(2), Real(16)}) {
        const rt::Viewport viewport = rt::viewport_size(Real(1), aspect);
        INFO("aspect ratio " << text(aspect) << ": yours is " << text(viewport.width)
                             << " wide and " << text(viewport.height)
                             << " high.\nHint: the angle given is the vertical one, so the "
                                "height comes from it and the width from the height: width / "
                                "height is the aspect ratio");
        // Powers of two: the product does not round.
        CHECK(viewport.width == aspect * viewport.height);
    }
}

TEST_CASE("02.2 the height does not depend on the aspect ratio", "[02.2]") {
    const Real narrow = rt::viewport_size(Real(1), Real(0.5)).height;
    const Real wide = rt::viewport_size(Real(1), Real(2)).height;
    INFO("heights for aspect ratio 0.5 and 2: yours gives "
         << text(narrow) << " and " << text(wide)
         << ".\nHint: the field of view is the vertical one");
    CHECK(narrow == wide);
}

TEST_CASE("02.2 any angle from a thousandth of a degree to 179.9 degrees", "[02.2][hard]") {
    for (const auto& row : exact::viewports()) {
        const Real fov = real(row.vertical_fov), aspect = real(row.aspect_ratio);
        const rt::Viewport viewport = rt::viewport_size(fov, aspect);
        INFO("a field of view of " << row.degrees << " degrees, " << text(fov)
                                   << " radians, aspect ratio " << text(aspect));
        {
            HINT(row.height, viewport.height,
                 "2 std::tan(vertical_fov / 2) is accurate at every angle; a formula of your own "
                 "may not be");
            REQUIRE(error_in_ulp(viewport.height, row.height) <= allowed_height);
        }
        HINT(row.width, viewport.width, "height times aspect ratio, in Real throughout");
        REQUIRE(error_in_ulp(viewport.width, row.width) <= allowed_width);
    }
}

TEST_CASE("02.2 an angle of 0 or 180 degrees or not a number is refused", "[02.2][hard]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    for (const Real fov :
         {Real(0), Real(-1), rt::pi, 4 * rt::pi, rt::infinity, -rt::infinity, nan}) {
        INFO(
            "viewport_size("
            << text(fov)
            << ", 1) must throw std::domain_error.\nHint: test for "
               "what is right and throw otherwise; a comparison with not-a-number is always false");
        CHECK_THROWS_AS(rt::viewport_size(fov, 1), std::domain_error);
    }
    const Real below_pi = std::nextafter(rt::pi, Real(0));
    INFO("the largest angle below pi is fine");
    CHECK(rt::viewport_size(below_pi, 1).height > 1 / (4 * rt::epsilon));
}

TEST_CASE("02.2 an aspect ratio that is not a positive number is refused", "[02.2][hard]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    for (const Real aspect : {Real(0), Real(-1), rt::infinity, nan}) {
        INFO("viewport_size(1, "
             << text(aspect)
             << ") must throw std::domain_error.\nHint: the same test as for the "
                "angle, with 0 and infinity");
        CHECK_THROWS_AS(rt::viewport_size(1, aspect), std::domain_error);
    }
}
