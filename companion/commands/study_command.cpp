#include <app/errors.hpp>
#include <companion/commands/commands.hpp>
#include <companion/pages/studies.hpp>
#include <companion/system/process.hpp>
#include <cstdio>

namespace companion {

int study(const Course& course, const Named& name) {
    std::vector<Chapter> chosen = chapters(course);
    if (name) chosen = {find_chapter(chosen, *name)};
    const bool with_plots = is_installed("gnuplot");
    int drawn = 0;
    for (const Chapter& chapter : chosen) {
        measure(course, chapter, true);
        if (with_plots) drawn += draw_plots(course, chapter);
    }
    std::printf("\nTables%s are in %s\n", drawn ? " and plots" : "",
                study_folder(course).string().c_str());
    if (!with_plots) std::puts("No plots: gnuplot is not installed.");
    return app::done;
}

}  // namespace companion
