// Chapter 01: what vectors can tell, drawn without a single ray.

#include <app/figure.hpp>
#include <app/run.hpp>
#include <rt/canvas.hpp>

#include "balls.hpp"

namespace {

using namespace vectors;

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const Vec3 light = normalize({Real(0.75), Real(0.55), Real(0.35)});
    const Ball large = ball_with_bristles(light);
    std::vector<Ball> turned;
    for (int i = 0; i < 6; ++i)
        turned.push_back(turned_ball(radians(-50 + 20 * static_cast<Real>(i))));

    // The picture is 16 units wide and 9 units high: the large ball on the left, two columns of
    // three turned balls on the right.
    const Real unit =
        std::min(static_cast<Real>(settings.width) / 16, static_cast<Real>(settings.height) / 9);
    const auto color_at = [&](Real x, Real y) {
        if (x < 9) return large.at((x - Real(4.5)) / 3, (Real(4.5) - y) / 3, light);
        const int column = x < Real(12.5) ? 0 : 1, row = std::clamp(static_cast<int>(y / 3), 0, 2);
        const Real middle_x = Real(10.7) + Real(3.4) * static_cast<Real>(column);
        const Real middle_y = Real(1.5) + 3 * static_cast<Real>(row);
        return turned[static_cast<std::size_t>(2 * row + column)].at(x - middle_x, middle_y - y,
                                                                     light);
    };
    // Each pixel is the average of nine points in it, so that edges are smooth:
    // chapter 04 explains why.
    return {app::draw<Canvas<Color>>(settings, progress, [&](int column, int row) {
        return app::average_of_nine(column, row,
                                    [&](Real x, Real y) { return color_at(x / unit, y / unit); });
    })};
}

}  // namespace

int main(int argc, char** argv) {
    return app::run(
        argc, argv,
        {.name = "01_vectors",
         .about = "the sign of the dot product on a ball, and a frame that a matrix turns",
         .defaults = {},
         .render = render,
         .study = app::program_study});
}
