#include <companion/build/build.hpp>
#include <companion/commands/compared_picture.hpp>
#include <companion/compare/program_pictures.hpp>
#include <cstdio>
#include <rt/counted.hpp>

namespace companion {
namespace {

Comparison compared(const Course& course, const Chapter& chapter) {
    must_build(course, chapter.name + "_mine");
    return compare(two_programs(course.program(chapter.name + "_mine"),
                                course.program(chapter.name + "_solution")));
}

// The reasons why the picture differs although all answers are right: open stars, or right answers
// that differ from the solution. The picture is drawn again with the solution's code for some of
// these exercises: first for those with several right answers, then for those of this chapter, then
// for all. If it no longer differs, they are the reason. Empty if it always differs.
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
        std::fprintf(
            stderr,
            "It differs. Drawing it again with the solution's code for %s, to see why ...\n",
            rt::counted(some.size(), "exercise").c_str());
        put_yours_in_place_except(course, chapter, some);
        if (!compared(course, chapter).same) continue;
        std::vector<std::string> words{"It differs from the solution's, which is no mistake here:"};
        for (const std::string& id : some)
            words.push_back(id + ' ' + yours.may_differ.at(id) + '.');
        words.push_back("With the solution's code for " +
                        std::string(some.size() == 1 ? "this exercise" : "these exercises") +
                        ", the pictures are the same.");
        return words;
    }
    return {};
}

}  // namespace

ComparedPicture compare_picture(const Course& course, const Chapter& chapter, bool all_yours) {
    ComparedPicture picture{
        all_yours ? put_all_yours_in_place(course, chapter) : put_yours_in_place(course, chapter),
        {},
        {}};
    must_build(course, chapter.name + "_solution");
    picture.found = compared(course, chapter);
    if (!picture.found.same && picture.yours.failing.empty())
        picture.excused = explained(course, chapter, picture.yours);
    return picture;
}

std::string compared_in_one_line(const Course& course, const Chapter& chapter, const Yours& yours) {
    if (yours.files.empty()) return {};
    must_build(course, chapter.name + "_solution");
    const Comparison found = compared(course, chapter);
    const std::string verdict = chapter.name + ": " + found.words()[0];
    if (found.same) return verdict;
    return verdict + (yours.may_differ.empty() ? " Where: " : " Where, and whether it may: ") +
           "./course compare " + chapter.number() + (yours.failing.empty() ? "" : " --mine");
}

}  // namespace companion
