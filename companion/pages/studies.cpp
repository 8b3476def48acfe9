#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/pages/measurements.hpp>
#include <companion/pages/plot.hpp>
#include <companion/pages/studies.hpp>
#include <companion/system/process.hpp>
#include <system_error>

namespace companion {
namespace {

std::string plot_file(const Chapter& chapter, const std::string& study) {
    return chapter.name + '-' + slug(study) + ".svg";
}

}  // namespace

fs::path study_folder(const Course& course, Whose whose) {
    return course.out() / (whose == Whose::mine ? "study-mine" : "study");
}

std::vector<std::string> study_programs(const Chapter& chapter, Whose whose) {
    const std::string program = chapter.name + (whose == Whose::mine ? "_mine" : "_solution");
    return {program, program + "_float"};
}

void measure(const Course& course, const Chapter& chapter, bool show_tables, Whose whose) {
    const fs::path folder = study_folder(course, whose);
    app::make_folder(folder);
    fs::remove(folder / chapter.table());  // an older one must not be taken for this one
    for (const std::string& program : study_programs(chapter, whose)) {
        Run run{.command = {course.program(program).string(), "--study", folder.string()},
                .output = show_tables ? Output::shown : Output::errors_shown};
        if (!show_tables) run.command.push_back("--quiet");
        const Result result = run_process(run);
        if (!result.ok())
            throw app::Failure("the study of " + program + " failed: " + how_it_ended(result));
    }
}

int draw_plots(const Course& course, const Chapter& chapter, Whose whose) {
    const fs::path folder = study_folder(course, whose);
    int count = 0;
    for (const auto& rows : by_study(read_measurements(folder / chapter.table()))) {
        const std::string file = plot_file(chapter, rows.front().study);
        const fs::path script = folder / (file + ".gnuplot");
        app::replace_file(script, plot_script(rows, file));
        const Result result = run_process(
            {.command = {"gnuplot", script.filename().string()}, .folder = folder, .timeout = 60});
        if (!result.ok())
            throw app::Failure("gnuplot could not draw " + file + ": " + how_it_ended(result) +
                               ' ' + result.output);
        fs::remove(script);
        ++count;
    }
    return count;
}

std::vector<std::string> plots(const Course& course, const Chapter& chapter) {
    std::vector<std::string> files;
    const auto add = [&](const fs::path& file) {
        files.push_back(fs::relative(file, course.out()).generic_string());
    };
    if (const fs::path table = study_folder(course) / chapter.table(); fs::exists(table)) {
        for (const auto& rows : by_study(read_measurements(table)))
            if (const fs::path file = study_folder(course) / plot_file(chapter, rows.front().study);
                fs::exists(file))
                add(file);
    } else if (const fs::path shipped = course.root / "docs/plots"; fs::exists(shipped)) {
        for (const auto& entry : fs::directory_iterator(shipped))
            if (entry.path().filename().string().rfind(chapter.name + '-', 0) == 0)
                add(entry.path());
        std::sort(files.begin(), files.end());
    }
    return files;
}

}  // namespace companion
