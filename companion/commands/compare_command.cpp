#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/build/build.hpp>
#include <companion/check/yours.hpp>
#include <companion/commands/commands.hpp>
#include <companion/compare/comparison_sheet.hpp>
#include <companion/compare/program_pictures.hpp>
#include <cstdio>
#include <rt/image_file.hpp>

namespace companion {
namespace {

Comparison compared(const Course& course, const Chapter& chapter) {
    must_build(course, chapter.name + "_mine");
    return compare(two_programs(course.program(chapter.name + "_mine"),
                                course.program(chapter.name + "_solution")));
}

// Whether right answers alone make the difference: open stars, or another right answer than ours.
// Then it is gone with the solution's code for them. Those with several right answers are tried
// first, then those of this chapter, then all. Empty if they do not explain it.
std::vector<std::string> explained(const Course& course, const Chapter& chapter,
                                   const Yours& yours) {
    std::set<std::string> several, here, all;
    for (const auto& [id, reason] : yours.may_differ) {
        all.insert(id);
        if (id.rfind(chapter.number() + '.', 0) == 0) here.insert(id);
        if (find_exercise(course, id).several_answers) several.insert(id);
    }
    std::set<std::set<std::string>> tried{{}};
    for (const std::set<std::string>& some : {several, here, all}) {
        if (!tried.insert(some).second) continue;
        std::fprintf(stderr,
                     "It differs. Drawing it with the solution's code for %zu %s, to see why ...\n",
                     some.size(), some.size() == 1 ? "exercise" : "exercises");
        put_yours_in_place_except(course, chapter, some);
        if (!compared(course, chapter).same) continue;
        std::vector<std::string> words{"It differs from the solution's, which is no mistake here:"};
        for (const std::string& id : some)
            words.push_back(id + ' ' + yours.may_differ.at(id) + '.');
        words.push_back(some.size() == 1
                            ? "With the solution's code for it, the pictures are the same."
                            : "With the solution's code for these, the pictures are the same.");
        return words;
    }
    return {};
}

}  // namespace

int compare(const Course& course, const Given& given) {
    const Chapter chapter = find_chapter(course, *given.named);
    const Yours yours = put_yours_in_place(course, chapter);
    must_build(course, chapter.name + "_solution");

    Comparison found;
    std::vector<std::string> excused;
    try {
        found = compared(course, chapter);
        if (!found.same) excused = explained(course, chapter, yours);
    } catch (const DrawingFailed& failed) {
        std::fprintf(stderr, "course: %s\n", failed.what());
        const bool to_write =
            !failed.result.signal && failed.result.exit_code == app::still_to_write;
        return to_write ? app::still_to_write : app::could_not;
    }
    auto words = found.words();
    if (!excused.empty()) {
        excused.insert(excused.end(), words.begin() + 1, words.end());
        words = excused;
    }
    std::printf("%s\n", yours.words().c_str());
    std::printf("%s: %s\n", chapter.name.c_str(), words[0].c_str());
    for (std::size_t i = 1; i < words.size(); ++i) std::printf("  %s\n", words[i].c_str());
    app::make_folder(course.out());
    const fs::path path = course.out() / (chapter.name + "_compare.png");
    app::replace_file(path, rt::encode_png(comparison_sheet(found)));
    std::printf("Both pictures and their difference are in %s\n",
                path.lexically_relative(course.root).c_str());
    return found.same || !excused.empty() ? app::done : app::could_not;
}

}  // namespace companion
