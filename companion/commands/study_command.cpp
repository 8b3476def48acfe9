#include <app/errors.hpp>
#include <companion/build/build.hpp>
#include <companion/build/turn.hpp>
#include <companion/check/yours.hpp>
#include <companion/commands/commands.hpp>
#include <companion/pages/studies.hpp>
#include <companion/pages/study_comparison.hpp>
#include <cstdio>

namespace companion {
namespace {

std::vector<Measurement> measured(const Course& course, const Chapter& chapter, Whose whose) {
    return read_measurements(study_folder(course, whose) / chapter.table());
}

// Draws the plots of the texts, docs/plots, from the tables in docs/studies.
int study_of_texts(const Course& course, const Given& given) {
    if (given.named || given.options.size() > 1)
        throw app::UsageError("study --docs: takes nothing else");
    draw_plots_of_texts(course);
    std::puts("The plots in docs/plots have been redrawn from docs/studies.");
    return app::done;
}

}  // namespace

int study(const Course& course, const Given& given) {
    const Turn turn{course};  // nothing else may disturb what is measured
    if (given.has("--docs")) return study_of_texts(course, given);
    const bool mine = given.has("--mine");
    std::vector<Chapter> chosen = chapters(course);
    if (given.named) chosen = {find_chapter(course, *given.named)};
    std::string words = "The solution's code was measured.";
    const Whose shown = mine ? Whose::mine : Whose::solution;
    if (mine) words = put_yours_in_place(course, chosen.back()).words();
    std::puts("Building the programs; the first time, this takes a few minutes.");
    std::fflush(stdout);
    for (const Chapter& chapter : chosen)
        for (const Whose whose : {Whose::mine, Whose::solution})
            if (mine || whose == Whose::solution)
                for (const std::string& program : study_programs(chapter, whose))
                    must_build(course, program);
    Captions captions = captions_of(course);
    captions.with_claims = false;  // nobody has looked at what is measured here
    const auto draw = [&](const Chapter& chapter, Whose whose) {
        draw_plots(study_folder(course, whose) / chapter.table(), study_folder(course, whose),
                   captions);
    };
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const Chapter& chapter = chosen[i];
        // The learner's code is measured between two runs of the solution: a difference that is no
        // larger than the one between those two runs does not count.
        std::printf("study %s, %zu of %zu, about %d s\n", chapter.name.c_str(), i + 1,
                    chosen.size(), (mine ? 3 : 1) * chapter.study_seconds);
        std::fflush(stdout);
        std::vector<Measurement> solution;
        if (mine) {
            measure(course, chapter, false);
            solution = measured(course, chapter, Whose::solution);
        }
        measure(course, chapter, true, shown);
        draw(chapter, shown);
        if (!mine) continue;
        measure(course, chapter, false);
        draw(chapter, Whose::solution);
        std::printf("\n%s\n", study_comparison(measured(course, chapter, Whose::mine), solution,
                                               measured(course, chapter, Whose::solution))
                                  .c_str());
    }
    std::printf("\n%s Tables and plots are in %s\n", words.c_str(),
                study_folder(course, shown).generic_string().c_str());
    return app::done;
}

}  // namespace companion
