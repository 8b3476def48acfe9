#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/pages/measurements.hpp>
#include <companion/pages/plot.hpp>
#include <companion/pages/studies.hpp>
#include <companion/system/process.hpp>

namespace companion {

fs::path study_folder(const Course& course, Whose whose) {
    return course.out() / (whose == Whose::mine ? "study-mine" : "study");
}

std::vector<std::string> study_programs(const Chapter& chapter, Whose whose) {
    const std::string program = chapter.name + (whose == Whose::mine ? "_mine" : "_solution");
    return {program + "_study", program + "_float_study"};
}

void measure(const Course& course, const Chapter& chapter, bool show_tables, Whose whose) {
    const fs::path folder = study_folder(course, whose);
    app::make_folder(folder);
    fs::remove(folder / chapter.table());  // otherwise an old table might be taken for the new one
    for (const std::string& program : study_programs(chapter, whose)) {
        Run run{.command = {course.program(program).string(), "--study", folder.string()},
                .output = show_tables ? Output::printable : Output::errors_shown};
        if (!show_tables) run.command.push_back("--quiet");
        const Result result = run_process(run);
        if (!result.ok())
            throw app::Failure("the study of " + program + " failed: " + how_it_ended(result));
    }
}

Captions captions_of(const Course& course) {
    return read_captions(course.root / "docs/studies/captions.json");
}

void draw_plots(const fs::path& table, const fs::path& folder, const Captions& captions) {
    for (const auto& [file, plot] : plots_of(table, captions))
        app::replace_file(folder / file, plot);
}

void draw_plots_of_texts(const Course& course) {
    const fs::path folder = course.root / "docs/plots";
    const Captions captions = captions_of(course);
    fs::remove_all(folder);  // some of the old plots may be of studies that no longer exist
    app::make_folder(folder);
    for (const auto& entry : fs::directory_iterator(course.root / "docs/studies"))
        if (entry.path().extension() == ".csv") draw_plots(entry, folder, captions);
}

std::vector<Plot> plots(const Course& course, const Chapter& chapter) {
    const bool here = fs::exists(study_folder(course) / chapter.table());
    const fs::path folder = here ? study_folder(course) : course.root / "docs/plots";
    const fs::path table = (here ? folder : course.root / "docs/studies") / chapter.table();
    std::vector<Plot> found;
    if (!fs::exists(table)) return found;
    const Captions captions = here ? Captions{} : captions_of(course);
    for (const auto& rows : by_study(read_measurements(table))) {
        const std::string& study = rows.front().study;
        const fs::path file = folder / plot_file(table, study);
        if (!fs::exists(file)) continue;
        const std::string claim = captions.of(table, study).claim;
        found.push_back({fs::relative(file, course.out()).generic_string(), study,
                         claim.empty() ? "A plot of the study: " + study : claim});
    }
    return found;
}

}  // namespace companion
