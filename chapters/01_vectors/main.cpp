#include <app/run.hpp>
#include <study/report.hpp>

namespace {

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    return {app::draw(settings, progress, [](int, int) { return rt::Color{}; }), 0};
}

void run_study(study::Report&) {}

}  // namespace

int main(int argc, char** argv) {
    return app::run(argc, argv,
                    {.name = "01_vectors", .about = "", .defaults = {}, .render = render,
                     .study = run_study});
}
