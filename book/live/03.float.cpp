// This file is compiled with Real = float and with another name for the namespace rt, so that the
// course's functions exist twice in one module.
#include "03.float.hpp"

#include <cmath>
#include <rt/hit_sphere.hpp>

#include "variants.hpp"

static_assert(sizeof(rt::Real) == sizeof(float));

namespace live {
namespace {

rt::Ray ray(double x, double y, double dx, double dy) {
    const auto real = [](double number) { return static_cast<rt::Real>(number); };
    return {{real(x), real(y), 0}, {real(dx), real(dy), 0}};
}

// The nearest meeting of all, and the next one beyond it.
Meetings meetings(variants::HitFunction hit, const rt::Ray& line) {
    const rt::Sphere sphere{{0, 0, 0}, 1};
    const auto low = hit(sphere, line, {-rt::infinity, rt::infinity});
    if (!low) return {};
    const auto high = hit(sphere, line, {std::nextafter(*low, rt::infinity), rt::infinity});
    return {2, *low, high.value_or(*low)};
}

}  // namespace

Meetings meetings_in_float(double x, double y, double dx, double dy) {
    return meetings(rt::hit_sphere, ray(x, y, dx, dy));
}

Meetings textbook_meetings_in_float(double x, double y, double dx, double dy) {
    return meetings(variants::textbook, ray(x, y, dx, dy));
}

}  // namespace live
