#include <app/errors.hpp>
#include <companion/commands/commands.hpp>
#include <companion/pages/studies.hpp>
#include <companion/system/process.hpp>
#include <cstdio>

namespace companion {

int study(const Course& course, const Arguments& arguments) {
    if (arguments.size() > 1)
        throw app::UsageError("study takes one chapter at most, such as: study 03");
    std::vector<Chapter> chosen = chapters(course);
    if (!arguments.empty()) chosen = {find_chapter(chosen, arguments[0])};
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
