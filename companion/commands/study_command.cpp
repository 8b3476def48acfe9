#include <app/errors.hpp>
#include <companion/build/build.hpp>
#include <companion/check/yours.hpp>
#include <companion/commands/commands.hpp>
#include <companion/pages/studies.hpp>
#include <companion/pages/study_comparison.hpp>
#include <companion/system/process.hpp>
#include <cstdio>

namespace companion {
namespace {

std::vector<Measurement> measured(const Course& course, const Chapter& chapter, Whose whose) {
    return read_measurements(study_folder(course, whose) / chapter.table());
}

}  // namespace

int study(const Course& course, const Named& name, bool mine) {
    std::vector<Chapter> chosen = chapters(course);
    if (name) chosen = {find_chapter(course, *name)};
    std::string words = "The solution's code was measured.";
    std::vector<Whose> codes{Whose::solution};
    if (mine) {
        words = put_yours_in_place(course, chosen.back()).words();
        codes = {Whose::mine, Whose::solution};
        for (const Chapter& chapter : chosen)
            for (const Whose whose : codes)
                for (const std::string& program : study_programs(chapter, whose))
                    must_build(course, program);
    }
    const bool with_plots = is_installed("gnuplot");
    int drawn = 0;
    for (const Chapter& chapter : chosen) {
        // One after the other, for what the machine does at another time is another measurement.
        for (const Whose whose : codes) {
            measure(course, chapter, whose == codes.front(), whose);
            if (with_plots) drawn += draw_plots(course, chapter, whose);
        }
        if (mine)
            std::printf("\n%s", study_comparison(measured(course, chapter, Whose::mine),
                                                 measured(course, chapter, Whose::solution))
                                    .c_str());
    }
    std::printf("\n%s Tables%s are in %s\n", words.c_str(), drawn ? " and plots" : "",
                study_folder(course, codes.front()).string().c_str());
    if (!with_plots) std::puts("No plots: gnuplot is not installed.");
    return app::done;
}

}  // namespace companion
