// The camera: the angle that its rays span, what it looks at, and which way is up.
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/make_camera.hpp>
#include <rt/primary_ray.hpp>

#include "certificate.hpp"

namespace {

using namespace certify;

constexpr int cameras = 20'000;

double angle_between(Vec3 a, Vec3 b) {
    return std::atan2(static_cast<double>(rt::length(rt::cross(a, b))),
                      static_cast<double>(rt::dot(a, b)));
}

rt::View any_view(rt::Rng& rng) {
    rt::View view;
    view.from = 10 * checkpoint::any_direction(rng);
    view.at = view.from + checkpoint::any_size(rng, -2, 2) * checkpoint::any_direction(rng);
    view.up = checkpoint::any_size(rng, -2, 2) * checkpoint::any_direction(rng);
    view.vertical_fov = rt::radians(rng.uniform(1, 150));
    return view;
}

// The angle between the rays through the upper and the lower edge, in the middle column.
void field_of_view(Certificate& certificate) {
    rt::Rng rng{1, 2};
    double worst = 0;
    for (int i = 0; i < cameras; ++i) {
        const rt::View view = any_view(rng);
        const rt::Camera camera = rt::make_camera(view, 101, 67);
        const Real half = Real(0.5);
        const auto top = rt::primary_ray(camera, 50, 0, {half, 0}),
                   bottom = rt::primary_ray(camera, 50, 66, {half, 1});
        const double angle = angle_between(top.direction, bottom.direction);
        worst = std::max(worst, std::abs(angle - static_cast<double>(view.vertical_fov)) / epsilon);
    }
    certificate.at_most("02.2", "field of view of the rays, 1 to 150 degrees", worst, 32,
                        "epsilon");
}

void target(Certificate& certificate) {
    rt::Rng rng{2, 2};
    double worst = 0;
    for (int i = 0; i < cameras; ++i) {
        const rt::View view = any_view(rng);
        const rt::Camera camera = rt::make_camera(view, 101, 67);
        const auto ray = rt::primary_ray(camera, 50, 33, {Real(0.5), Real(0.5)});
        worst = std::max(worst, angle_between(ray.direction, view.at - view.from) / epsilon);
    }
    certificate.at_most("02.4", "the middle ray meets the point looked at", worst, 16, "epsilon");
}

void upright(Certificate& certificate) {
    rt::Rng rng{3, 2};
    double sideways = 0, frame = 0;
    int upside_down = 0;
    for (int i = 0; i < cameras; ++i) {
        const rt::View view = any_view(rng);
        const rt::Basis b = rt::look_at(view.from, view.at, view.up);
        // The part of up across the view may be small compared with up; that is
        // how well u is known.
        const Vec3 up = rt::normalize(view.up);
        sideways = std::max(sideways, static_cast<double>(std::abs(rt::dot(up, b.u))) / epsilon);
        upside_down += !(rt::dot(up, b.v) > 0);
        for (const Vec3 off :
             {rt::cross(b.u, b.v) - b.w, rt::cross(b.v, b.w) - b.u, rt::cross(b.w, b.u) - b.v})
            frame = std::max(frame, largest_component(off) / epsilon);
    }
    certificate.at_most("02.3*", "up leans to no side", sideways, 16, "epsilon");
    certificate.at_most("02.3", "pictures upside down, of 20,000", upside_down, 0, "");
    certificate.at_most("02.3*", "look-at frame, right angles and handedness", frame, 16,
                        "epsilon");
    const rt::Basis straight = rt::look_at({0, 0, 0}, {0, 5, 0}, {0, 1, 0});
    certificate.at_most(
        "02.3*", "frame of a view straight up",
        largest_component(rt::cross(straight.u, straight.v) - Vec3{0, -1, 0}) / epsilon, 8,
        "epsilon");
}

}  // namespace

int main() {
    return certify::certify(field_of_view, target, upright);
}
