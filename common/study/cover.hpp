#pragma once
// A scene like the cover of the classic tutorial, as plain values: 486 spheres of matte, metal and
// glass, three of them large and one the ground. Studies compare several ways to draw it.

#include <rt/color.hpp>
#include <rt/view.hpp>
#include <vector>

namespace study {

enum class CoverMaterial { matte, metal, glass };

struct CoverSphere {
    rt::Vec3 center;
    rt::Real radius = 1;
    CoverMaterial material = CoverMaterial::matte;
    rt::Color color{};  // of matte and metal
    rt::Real fuzz = 0;  // of metal
};

constexpr rt::Real cover_glass_index = rt::Real(1.5);

// The scene with its camera and settings. The picture has the size of the tutorial's first
// pictures. For timing, it is enough to draw some of its rows.
struct Cover {
    std::vector<CoverSphere> spheres;
    rt::View view{{13, 2, 3}, {0, 0, 0}, {0, 1, 0}, rt::radians(20)};
    rt::Color horizon{1, 1, 1}, above{rt::Real(0.5), rt::Real(0.7), 1};  // the sky
    int width = 400, height = 225, samples_per_pixel = 10, depth = 50;
    int row_step = 9;  // every ninth row is drawn

    int rows_drawn() const { return (height + row_step - 1) / row_step; }
    // The time for the whole picture in milliseconds, estimated from `drawn_ns`, the nanoseconds
    // that the drawn rows took.
    double whole_ms(double drawn_ns) const { return 1e-6 * drawn_ns * height / rows_drawn(); }
};

Cover make_cover();

// The mean color of the drawn rows, where shade(column, row) computes the color of a pixel. The
// mean depends on every color, so the compiler cannot leave out any computation.
template <class Shade>
rt::Color mean_color(const Cover& cover, Shade shade) {
    rt::Color sum;
    for (int y = 0; y < cover.height; y += cover.row_step)
        for (int x = 0; x < cover.width; ++x) sum += shade(x, y);
    return sum / static_cast<rt::Real>(cover.width * cover.rows_drawn());
}

}  // namespace study
