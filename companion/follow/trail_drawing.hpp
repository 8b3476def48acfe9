#pragma once
#include <companion/follow/trail.hpp>

namespace companion {

// The picture that a trail is drawn over: the bytes of a PNG file, and its size in pixels.
struct TrailPicture {
    std::string png = {};  // empty: there is none
    int width = 0, height = 0;
};

// The trail, which begins with the camera, as an SVG file in three views: over the picture, from
// above and from the side. The points have the numbers of in_words. Each sphere that was met is a
// circle.
std::string drawn(const Trail& trail, const TrailPicture& picture);

}  // namespace companion
