#pragma once
#define make_camera make_camera_unrecorded
#include_next <rt/make_camera.hpp>
#undef make_camera
#include <rt/record.hpp>

namespace rt {

inline Camera make_camera(const View& view, int width, int height) {
    const auto note = [](const char* name, const auto& value) {
        recorder::record().note("the view", name, value);
    };
    note("the camera's position", view.from);
    note("the point that the camera looks at", view.at);
    note("the direction that is up in the picture", view.up);
    note("the vertical field of view, in radians,", view.vertical_fov);
    note("the camera's width", width);
    note("the camera's height", height);
    return make_camera_unrecorded(view, width, height);
}

}  // namespace rt
