#include <app/errors.hpp>
#include <companion/build/build.hpp>
#include <companion/check/yours.hpp>
#include <companion/commands/commands.hpp>
#include <companion/pages/studies.hpp>
#include <companion/system/process.hpp>
#include <cstdio>

namespace companion {

int study(const Course& course, const Named& name, bool mine) {
    std::vector<Chapter> chosen = chapters(course);
    if (name) chosen = {find_chapter(chosen, *name)};
    const Whose whose = mine ? Whose::mine : Whose::solution;
    std::string words = "The solution's code was measured.";
    if (mine) {
        words = put_yours_in_place(course, chosen.back()).words();
        for (const Chapter& chapter : chosen)
            for (const std::string& program : study_programs(chapter, whose))
                must_build(course, program);
    }
    const bool with_plots = is_installed("gnuplot");
    int drawn = 0;
    for (const Chapter& chapter : chosen) {
        measure(course, chapter, true, whose);
        if (with_plots) drawn += draw_plots(course, chapter, whose);
    }
    std::printf("\n%s Tables%s are in %s\n", words.c_str(), drawn ? " and plots" : "",
                study_folder(course, whose).string().c_str());
    if (!with_plots) std::puts("No plots: gnuplot is not installed.");
    return app::done;
}

}  // namespace companion
