#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/rng.hpp>
#include <rt/turned_view.hpp>

#include "checkpoint.hpp"

using namespace checkpoint;
using rt::View;

namespace {

void check_near(Vec3 actual, Vec3 expected, Real scale, const char* hint) {
    HINT(expected, actual, hint);
    const bool is_near = length(actual - expected) <= 30 * rt::epsilon * scale;
    CHECK(is_near);
}

View some_view(rt::Rng& random) {
    const auto point = [&] {
        const Real x = random.uniform(-5, 5), y = random.uniform(-5, 5), z = random.uniform(-5, 5);
        return Vec3{x, y, z};
    };
    const Vec3 from = point(), at = point(), up = point();
    return {from, at, up, real(0.7)};
}

}  // namespace

TEST_CASE("13.5 one frame of four turns the camera by a quarter turn", "[13.5]") {
    const View view{{3, 1, 0}, {1, 0, 0}, {0, 1, 0}, 1};
    const Vec3 expected[] = {{3, 1, 0}, {1, 1, -2}, {-1, 1, 0}, {1, 1, 2}};
    for (int frame = 0; frame < 4; ++frame) {
        INFO("frame " << frame
                      << " of 4: in the view, the camera is 2 to the right of the point "
                         "that it looks at, and 1 above it");
        check_near(rt::turned_view(view, frame, 4).from, expected[frame], 3,
                   "seen from above, the camera goes counterclockwise: from +x to -z");
    }
}

TEST_CASE("13.5 only the camera moves", "[13.5]") {
    rt::Rng random{135, 1};
    for (int i = 0; i < 100; ++i) {
        const View view = some_view(random);
        const View turned = rt::turned_view(view, 1 + i % 7, 9);
        CHECK(turned.at == view.at);
        CHECK(turned.up == view.up);
        CHECK(turned.vertical_fov == view.vertical_fov);
    }
}

TEST_CASE("13.5 the camera keeps its height and distance", "[13.5]") {
    rt::Rng random{135, 2};
    for (int i = 0; i < 300; ++i) {
        const View view = some_view(random);
        const Vec3 axis = rt::normalize(view.up), away = view.from - view.at;
        const int frames = 2 + i % 11, frame = 1 + i % (frames - 1);
        const Vec3 turned = rt::turned_view(view, frame, frames).from - view.at;
        INFO("frame " << frame << " of " << frames << ", up " << text(view.up));
        check_near(
            {dot(turned, axis), length(turned), 0}, {dot(away, axis), length(away), 0}, 40,
            "x is the height above `at`, measured along up, and y is the distance. Up may have "
            "any length and direction");
        // The angle between the parts across the axis.
        const Vec3 before = away - dot(away, axis) * axis,
                   after = turned - dot(turned, axis) * axis;
        const Real angle = 2 * rt::pi * static_cast<Real>(frame) / static_cast<Real>(frames);
        const Real cosine = dot(before, after) / dot(before, before);
        HINT(std::cos(angle), cosine, "in frame k of n, the camera has turned by k/n of 2 pi");
        CHECK(std::abs(cosine - std::cos(angle)) <= 1000 * rt::epsilon);
    }
}

TEST_CASE("13.5 a camera straight above the point stays there", "[13.5]") {
    const View view{{1, 7, 3}, {1, 2, 3}, {0, 4, 0}, 1};
    for (int frame = 0; frame < 5; ++frame) {
        INFO("frame " << frame << " of 5: the part of the vector to the camera that turns is 0");
        check_near(rt::turned_view(view, frame, 5).from, view.from, 7,
                   "a vector of length 0 has no direction: do not normalize the part that turns");
    }
}

TEST_CASE("13.5 a whole turn gives exactly the original view", "[13.5][hard]") {
    rt::Rng random{135, 3};
    for (int i = 0; i < 100; ++i) {
        const View view = some_view(random);
        for (const int frame : {0, 120, 240, 120'000'000}) {
            const View turned = rt::turned_view(view, frame, 120);
            HINT(view.from, turned.from,
                 "frame " + std::to_string(frame) +
                     " of 120 must be the view itself, to the last bit: the film is shown in a "
                     "loop");
            REQUIRE(turned.from == view.from);
        }
        const View once = rt::turned_view(view, 7, 120);
        CHECK(rt::turned_view(view, 127, 120).from == once.from);
    }
}
