#include <app/run.hpp>
#include <rt/counting_world.hpp>
#include <rt/lambert.hpp>
#include <rt/lambertian.hpp>
#include <rt/make_camera.hpp>
#include <rt/render_pixel.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>
#include <study/report.hpp>

namespace {

using namespace rt;

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    SphereList world{{{{{0, -1000, 0}, 1000}, 0}, {{{0, 1, 0}, 1}, 1}}};
    MaterialList<Lambertian> materials{
        {{{Real(0.5), Real(0.5), Real(0.5)}}, {{Real(0.8), Real(0.3), Real(0.3)}}}};
    const Camera camera = make_camera({{0, 1, 4}, {0, 1, 0}}, settings.width, settings.height);
    std::uint64_t rays = 0;
    CountingWorld<SphereList> counted{world, rays};
    const Quality quality{settings.spp, settings.depth, *settings.seed};
    auto image = app::draw(settings, progress, [&](int x, int y) {
        return render_pixel(camera, counted, materials,
                            GradientSky{{1, 1, 1}, {Real(0.5), Real(0.7), 1}}, SkyEnding{}, quality,
                            x, y);
    });
    return {image, rays};
}

void run_study(study::Report&) {}

}  // namespace

int main(int argc, char** argv) {
    app::Settings defaults;
    defaults.spp = 16;
    defaults.depth = 16;
    defaults.seed = 1;
    return app::run(argc, argv,
                    {.name = "04_normals_aa",
                     .about = "",
                     .defaults = defaults,
                     .render = render,
                     .study = run_study});
}
