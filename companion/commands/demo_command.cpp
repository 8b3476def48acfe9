#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/commands/commands.hpp>
#include <companion/compare/picture.hpp>
#include <companion/pages/gallery.hpp>
#include <companion/system/files.hpp>
#include <companion/system/process.hpp>
#include <cstdio>
#include <rt/image_file.hpp>

namespace companion {
namespace {

// The program of chapter 09 does not have the course's options: it draws a scene file and writes
// PPM.
std::string render_scene(const Course& course, const Chapter& chapter) {
    const fs::path ppm = course.out() / (chapter.name + ".ppm");
    // On Windows, a program may not be able to read the letters of a whole path.
    const Result result = run_process(
        {.command = {course.program(chapter.name + "_solution").string(),
                     course.relative(course.build / chapter.scene), course.relative(ppm)},
         .folder = course.root,
         .output = Output::errors_shown});
    if (!result.ok()) throw app::Failure(how_it_ended(result));
    const Picture picture = parse_ppm(read_file(ppm));
    fs::remove(ppm);
    app::replace_file(course.out() / chapter.picture(), rt::encode_png(mean_of({picture})));
    char said[80];
    std::snprintf(said, sizeof said, "%dx%d pixels in %.1f s", picture.width, picture.height,
                  result.seconds);
    return said;
}

// The program's options for a picture as large as that of the chapter's text. By itself, the
// program draws a larger one, which takes longer.
std::vector<std::string> size_in_text(const Course& course, const Chapter& chapter) {
    constexpr int most_pixels = 1 << 22;
    const fs::path shown = course.root / "docs/images" / chapter.picture();
    if (!fs::exists(shown)) return {};
    const rt::Image image = rt::decode_image(read_file(shown), most_pixels);
    return {"--width", std::to_string(image.width()), "--height", std::to_string(image.height())};
}

// Renders a chapter's picture and returns what the program printed about it. Throws app::Failure.
std::string render(const Course& course, const Chapter& chapter) {
    // Otherwise an older picture might be taken for the new one.
    fs::remove(course.out() / chapter.picture());
    if (!chapter.has_exercises()) return render_scene(course, chapter);
    // Runs in out/, so that the program prints the picture's name without a folder.
    std::vector<std::string> command{course.program(chapter.name + "_solution").string(), "--out",
                                     chapter.picture()};
    const auto size = size_in_text(course, chapter);
    command.insert(command.end(), size.begin(), size.end());
    const Result result =
        run_process({.command = command, .folder = course.out(), .output = Output::errors_shown});
    if (!result.ok()) throw app::Failure(how_it_ended(result));
    // "03_sphere.png: 960x540 pixels in 0.1 s, ..." without the name, and without the line's end
    const std::string start = chapter.picture() + ": ";
    std::string said = result.output.substr(0, result.output.find('\n'));
    return said.rfind(start, 0) == 0 ? said.substr(start.size()) : said;
}

// All chapters, the one that draws the final scene last.
std::vector<Chapter> in_order(const Course& course) {
    std::vector<Chapter> all = every_chapter(course);
    std::erase_if(all, [](const Chapter& chapter) { return chapter.is_left_out(); });
    const std::string last = core_chapters(course).back().name;
    std::stable_partition(all.begin(), all.end(),
                          [&](const Chapter& chapter) { return chapter.name != last; });
    return all;
}

}  // namespace

int demo(const Course& course, const Given&) {
    app::make_folder(course.out());
    bool ok = true;
    std::vector<Exhibit> exhibits;
    for (const Chapter& chapter : in_order(course)) {
        std::string said;
        try {
            said = render(course, chapter);
            std::printf("%-16s %s\n", chapter.name.c_str(), said.c_str());
        } catch (const std::exception& error) {  // the others are drawn anyway
            ok = false;
            std::fflush(stdout);
            std::fprintf(stderr, "%s: %s\n", chapter.name.c_str(), error.what());
        }
        std::fflush(stdout);
        exhibits.push_back(collect(course, chapter, said));
    }
    const bool with_book = fs::exists(course.out() / "book/index.html");
    app::replace_file(course.out() / "index.html", gallery_html(exhibits, with_book));
    std::printf("The gallery is in %s\n", (course.out() / "index.html").generic_string().c_str());
    return ok ? app::done : app::could_not;
}

}  // namespace companion
