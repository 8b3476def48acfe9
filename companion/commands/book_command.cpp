#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/check/yours.hpp>
#include <companion/commands/commands.hpp>
#include <companion/pages/shared_page.hpp>
#include <companion/system/files.hpp>
#include <cstdio>
#include <set>

namespace companion {
namespace {

// Fills build/mine/rt with those of the learner's headers that pass, and nothing else. The book's
// figures look for headers there first, and its pages say whose code they run. passed.txt, in
// build/mine, lists the exercises that pass.
void put_headers_in_place(const Course& course, const Yours& yours) {
    const fs::path folder = course.build / "mine/rt";
    app::make_folder(folder);
    std::set<fs::path> names;
    for (const fs::path& file : yours.files) {
        if (file.extension() != ".hpp") continue;
        names.insert(file.filename());
        app::replace_file(folder / file.filename(),
                          read_file(course.build / "yours/rt" / file.filename()));
    }
    for (const fs::path& file : source_files(folder))
        if (names.count(file.filename()) == 0) fs::remove(file);
}

}  // namespace

// The learner's part of the book: the page to share, and the headers for the figures.
int book(const Course& course, const Given& given) {
    if (!given.has("--mine")) throw app::UsageError("book: ./course makes the book by itself");
    const Yours yours = put_yours_in_place(course, core_chapters(course).back());
    put_headers_in_place(course, yours);
    std::string passed;
    for (const std::string& id : yours.passing) passed += id + "\n";
    app::replace_file(course.build / "mine/passed.txt", passed);
    std::printf("%s\n", yours.words().c_str());
    app::make_folder(course.out());
    const SharedPage page = collect_shared_page(course);
    app::replace_file(course.out() / "mine.html", shared_page_html(page));
    std::printf("The page to share is out/mine.html.%s\n",
                page.picture.empty()
                    ? " It has no picture yet: draw the final scene with ./course run 08, "
                      "then run ./course book --mine again."
                    : "");
    return app::done;
}

}  // namespace companion
