#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/commands/commands.hpp>
#include <companion/pages/gallery.hpp>
#include <companion/system/process.hpp>
#include <cstdio>

namespace companion {
namespace {

// Renders a chapter's picture and returns what the program said of it. Throws app::Failure.
std::string render(const Course& course, const Chapter& chapter) {
    // An older picture must not pass for this one.
    fs::remove(course.out() / chapter.picture());
    // In out/, so that the program speaks of the picture by its name alone.
    const Result result =
        run_process({.command = {course.program(chapter.name + "_solution").string(), "--out",
                                 chapter.picture()},
                     .folder = course.out(),
                     .output = Output::errors_shown});
    if (!result.ok()) throw app::Failure(how_it_ended(result));
    // "03_sphere.png: 960x540 pixels in 0.1 s, ..." without the name, and without the line's end
    const std::string start = chapter.picture() + ": ";
    std::string said = result.output.substr(0, result.output.find('\n'));
    return said.rfind(start, 0) == 0 ? said.substr(start.size()) : said;
}

}  // namespace

int demo(const Course& course) {
    app::make_folder(course.out());
    bool ok = true;
    std::vector<Exhibit> exhibits;
    for (const Chapter& chapter : chapters(course)) {
        std::string said;
        try {
            said = render(course, chapter);
            std::printf("%-16s %s\n", chapter.name.c_str(), said.c_str());
        } catch (const std::exception& error) {  // the others are drawn all the same
            ok = false;
            std::fflush(stdout);
            std::fprintf(stderr, "%s: %s\n", chapter.name.c_str(), error.what());
        }
        std::fflush(stdout);
        exhibits.push_back(collect(course, chapter, said));
    }
    app::replace_file(course.out() / "index.html", gallery_html(exhibits));
    std::printf("The gallery is in %s\n", (course.out() / "index.html").string().c_str());
    return ok ? app::done : app::could_not;
}

}  // namespace companion
