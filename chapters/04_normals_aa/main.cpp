// Chapter 04: one group of spheres in four ways: its normals as colors; lit by one distant light;
// with one sample per pixel against many; and with the light followed from bounce to bounce.

#include <algorithm>
#include <app/run.hpp>
#include <rt/canvas.hpp>
#include <rt/counting_world.hpp>
#include <rt/fill.hpp>
#include <rt/lambert.hpp>
#include <rt/make_camera.hpp>
#include <rt/render_pixel.hpp>
#include <rt/show_paths.hpp>
#include <string>

#include "scene.hpp"

namespace {

using namespace normals_aa;

const Color paper = from_hex(0x1b1f2a), line_color = from_hex(0xf4efe6);

// Where the panels are, in pixels: three small ones in a column that takes three tenths of the
// width, and a large one in the rest.
struct Layout {
    app::Box normals, lambert, samples, paths;

    Layout(int width, int height) {
        const int gap = std::min(width, height) / 68;
        const int column = (width - 3 * gap) * 3 / 10, row = (height - 4 * gap) / 3;
        const int left = column > 0 ? 2 * gap + column : gap;
        normals = app::pixel_box(gap, gap, column, row);
        lambert = app::pixel_box(gap, 2 * gap + row, column, row);
        samples = app::pixel_box(gap, 3 * gap + 2 * row, column, height - 4 * gap - 2 * row);
        paths = app::pixel_box(left, gap, width - gap - left, height - 2 * gap);
    }
};

// Writes a panel's name on a dark plate at the place (x, 0), if the picture is large enough to read
// it.
void write_name(app::Figure& panel, Real x, const char* name, int picture_height) {
    const Real size = static_cast<Real>(picture_height) / 45;
    if (size < 8) return;
    panel.box({x, 0, app::width_of(name, size) + size, 2 * size}, paper);
    panel.words({x + size / 2, size / 2}, name, {size, line_color});
}

// What a single ray sees, without any bounce.
template <World AnyWorld>
struct SingleRays {
    const AnyWorld& world;
    const Scene& scene;

    Color normal_color(const Ray& ray) const {
        const auto hit = world.hit(ray, {});
        if (!hit) return paper * Real(2.5);
        const Vec3 n = hit->normal;
        return Color{n.x + 1, n.y + 1, n.z + 1} / 2;
    }
    Color lambert_color(const Ray& ray) const {
        const auto hit = world.hit(ray, {});
        if (!hit) return paper;
        const Color albedo =
            scene.materials.materials[static_cast<std::size_t>(hit->material)].albedo;
        return albedo * (Real(0.04) + Real(0.96) * lambert(hit->normal, scene.sky.to_sun));
    }
};

template <Ending AnyEnding>
app::Picture render_with(const AnyEnding& ending, const app::Settings& settings,
                         app::Progress& progress) {
    const Scene scene = make_scene();
    if (!settings.show.empty())
        return show_paths(settings, progress, scene.world, scene.materials, scene.sky, ending);

    std::uint64_t rays = 0;
    const CountingWorld<SphereList> world{scene.world, rays};
    const SingleRays<CountingWorld<SphereList>> single{world, scene};
    const Layout layout{settings.width, settings.height};
    Image image = Canvas<Color>{settings.width, settings.height, paper};
    app::Figure figure{image};
    app::Figure normals = figure.part(layout.normals), lit = figure.part(layout.lambert),
                samples = figure.part(layout.samples), paths = figure.part(layout.paths);
    progress.start(normals.rows() + lit.rows() + samples.rows() + paths.rows());
    // Narrow panels see less at the sides, but always the full height of the group.
    View small_view = *settings.view;
    if (settings.given.count("fov") == 0) small_view.vertical_fov = radians(28);
    const Camera small = make_camera(small_view, normals.columns(), normals.rows());
    const Camera large = make_camera(*settings.view, paths.columns(), paths.rows());

    // The third panel shows pixels as large blocks.
    const int block = std::max(1, samples.rows() / 24);
    View near = group_view();
    near.vertical_fov = radians(11);
    near.at = {Real(0.62), Real(0.7), 1};
    const Camera blocks = make_camera(near, std::max(1, samples.columns() / block),
                                      std::max(1, samples.rows() / block));

    const Quality quality{settings.spp, settings.depth, *settings.seed};
    const auto average = [&](const Camera& camera, int x, int y, int count, auto see) {
        Rng random = pixel_rng(quality.seed, x, y);
        return pixel_average(count, random, [&](Vec2 offset) {
            return see(make_ray(camera, x, y, offset, random));
        });
    };
    const auto normal_color = [&](const Ray& ray) { return single.normal_color(ray); };
    const auto lambert_color = [&](const Ray& ray) { return single.lambert_color(ray); };
    const int smooth = std::min(quality.samples_per_pixel, 16);

    app::fill(
        normals, [&](int x, int y) { return average(small, x, y, smooth, normal_color); },
        &progress);
    app::fill(
        lit, [&](int x, int y) { return average(small, x, y, smooth, lambert_color); }, &progress);
    app::fill(
        samples,
        [&](int x, int y) {
            const int column = x / block, row = y / block, middle = blocks.width / 2;
            if (column == middle && x % block == 0) return line_color;
            if (column >= middle)
                return average(blocks, column, row, quality.samples_per_pixel, lambert_color);
            return lambert_color(primary_ray(blocks, column, row, {Real(0.5), Real(0.5)}));
        },
        &progress);
    app::fill(
        paths,
        [&](int x, int y) {
            return render_pixel(large, world, scene.materials, scene.sky, ending, quality, x, y);
        },
        &progress);

    const Real middle = static_cast<Real>(block * (blocks.width / 2) + 1);
    write_name(normals, 0, "normals", settings.height);
    write_name(lit, 0, "one distant light", settings.height);
    write_name(samples, 0, "1 sample", settings.height);
    write_name(samples, middle, "many", settings.height);
    write_name(paths, 0, "paths of light", settings.height);
    return {std::move(image), rays};
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const std::string& ending = settings.choice("ending");
    if (ending == "black") return render_with(BlackEnding{}, settings, progress);
    if (ending == "roulette") return render_with(RouletteEnding{}, settings, progress);
    return render_with(SkyEnding{}, settings, progress);
}

}  // namespace

int main(int argc, char** argv) {
    app::Settings defaults;
    defaults.width = 800;
    defaults.height = 450;
    defaults.spp = 100;
    defaults.depth = 16;
    defaults.seed = 1;
    defaults.view = group_view();
    defaults.view->vertical_fov = radians(33);
    return app::run(argc, argv,
                    {.name = "04_normals_aa",
                     .about = "normals as colors, one light, one sample against many, and paths",
                     .defaults = defaults,
                     .render = render,
                     .study = app::program_study,
                     .choices = {{"ending",
                                  "What happens to a path at the depth limit",
                                  {"sky", "black", "roulette"}}},
                     .shows = rt::shown_of_paths()});
}
