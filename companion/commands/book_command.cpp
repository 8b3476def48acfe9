#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/check/yours.hpp>
#include <companion/commands/commands.hpp>
#include <companion/model/exercise.hpp>
#include <companion/pages/shared_page.hpp>
#include <companion/system/files.hpp>
#include <cstdio>
#include <set>

namespace companion {
namespace {

// Fills a folder with the headers among these files of the learner's, and nothing else.
void put_headers(const Course& course, const std::vector<fs::path>& files, const fs::path& folder) {
    app::make_folder(folder);
    std::set<fs::path> names;
    for (const fs::path& file : files) {
        if (file.extension() != ".hpp") continue;
        names.insert(file.filename());
        app::replace_file(folder / file.filename(), text_with_origin(course, file));
    }
    for (const fs::path& file : source_files(folder))
        if (names.count(file.filename()) == 0) fs::remove(file);
}

// What of the learner's the book's figures look for first: build/mine/rt has the headers that pass,
// and passed.txt, in build/mine, lists the exercises. If they are to run an exercise that fails,
// too, it stands in failing.txt, and build/mine/as_it_is/rt has its headers beside those that pass.
void put_in_place(const Course& course, const Yours& yours, const Exercise* failing) {
    const fs::path mine = course.build / "mine";
    put_headers(course, yours.files, mine / "rt");
    std::string passed;
    for (const std::string& id : yours.passing) passed += id + "\n";
    app::replace_file(mine / "passed.txt", passed);
    if (!failing) {
        fs::remove(mine / "failing.txt");
        return;
    }
    std::vector<fs::path> files = yours.files;
    files.insert(files.end(), failing->files.begin(), failing->files.end());
    put_headers(course, files, mine / "as_it_is/rt");
    app::replace_file(mine / "failing.txt", failing->id + "\n");
}

// Whether the learner has written something for the exercise, which does not pass.
bool fails(const Exercise& exercise, const Yours& yours) {
    const auto is_in = [&](const std::vector<std::string>& ids) {
        return std::count(ids.begin(), ids.end(), exercise.id) > 0;
    };
    if (is_in(yours.passing)) {
        std::printf("%s passes, so the figures need no switch for it.\n", exercise.id.c_str());
        return false;
    }
    if (is_in(yours.replaced)) return true;
    throw app::UsageError("book: " + exercise.id + " cannot run yet; ./course check " +
                          exercise.id + " says why");
}

}  // namespace

// The learner's part of the book: the page to share, and the headers for the figures.
int book(const Course& course, const Given& given) {
    if (!given.has("--mine")) throw app::UsageError("book: ./course makes the book by itself");
    const std::string& named = given.options.at("--mine");
    std::optional<Exercise> asked;
    if (!named.empty()) asked = find_exercise(course, named);
    const Yours yours = put_yours_in_place(course, core_chapters(course).back());
    const bool runs_failing = asked && fails(*asked, yours);
    put_in_place(course, yours, runs_failing ? &*asked : nullptr);
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
