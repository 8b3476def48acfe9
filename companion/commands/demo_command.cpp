#include <app/errors.hpp>
#include <app/files.hpp>
#include <chrono>
#include <companion/commands/commands.hpp>
#include <companion/pages/gallery.hpp>
#include <companion/pages/studies.hpp>
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

// Does one step of a chapter. Where it fails, says so and goes on.
template <class Work>
bool attempt(const Chapter& chapter, const char* what, Work work) {
    try {
        work();
        return true;
    } catch (const std::exception& error) {
        std::fflush(stdout);
        std::fprintf(stderr, "%s: the %s failed: %s\n", chapter.name.c_str(), what, error.what());
        return false;
    }
}

}  // namespace

int demo(const Course& course) {
    app::make_folder(course.out());
    const bool with_plots = is_installed("gnuplot");
    const std::vector<Chapter> all = chapters(course);
    bool ok = true;
    std::vector<Exhibit> exhibits;
    std::vector<std::string> rendered;
    for (const Chapter& chapter : all) {
        std::string said;
        ok &= attempt(chapter, "picture", [&] { said = render(course, chapter); });
        if (!said.empty()) std::printf("%-16s %s\n", chapter.name.c_str(), said.c_str());
        std::fflush(stdout);
        rendered.push_back(said);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto start = std::chrono::steady_clock::now();
        ok &= attempt(all[i], "study", [&] { measure(course, all[i], false); });
        if (with_plots) ok &= attempt(all[i], "plot", [&] { draw_plots(course, all[i]); });
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        std::printf("%-16s measured what accuracy costs in %.1f s\n", all[i].name.c_str(),
                    time.count());
        std::fflush(stdout);
        exhibits.push_back(collect(course, all[i], rendered[i]));
    }
    app::replace_file(course.out() / "index.html", gallery_html(exhibits));
    std::printf("The gallery is in %s\n", (course.out() / "index.html").string().c_str());
    return ok ? app::done : app::could_not;
}

}  // namespace companion
