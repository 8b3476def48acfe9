// graft_mistakes NN: our answer to a graft passes; the one to the graft before it does not, and no
// mistake of tests/mistakes/tracer/NN.md does: each fails at the line that it names. Lines that a
// busy machine cannot judge do not count.
//
// graft_mistakes NN FOLDER: our answer passes with the headers of this folder, too.

#include <app/errors.hpp>
#include <companion/build/remake.hpp>
#include <companion/model/mistakes.hpp>
#include <companion/own/graft_judge.hpp>
#include <companion/own/tracer.hpp>
#include <companion/system/files.hpp>
#include <cstdio>

#include "temporary_folder.hpp"

using namespace companion;
using checkpoint::TemporaryFolder;

namespace {

// True if a line fails for a program: this one, or any if it is empty. On a busy machine, one may.
bool fails(const Course& course, const Chapter& chapter, const fs::path& program, bool may,
           const std::string& only = {}) {
    const fs::path answer = course.program("tracer." + chapter.number());
    GraftRequest request{chapter, program, answer, chapter.graft->headers};
    request.only_line = only;
    struct Enough {};
    try {
        judge_graft(course, request, [&](const JudgedLine& line) {
            if (line.busy_machine ? !may : line.passed) return;
            std::printf("    x %s: %s\n", line.what.c_str(), line.actual.c_str());
            throw Enough{};
        });
    } catch (const Enough&) {
        return true;
    }
    return false;
}

// The same of this source, compiled like the answer.
bool source_fails(const Course& course, const Chapter& chapter, const std::string& source,
                  const std::string& only = {}) {
    const TemporaryFolder folder;
    checkpoint::write_file(folder / (chapter.number() + ".cpp"), source);
    const Remake remake{course, "tracer." + chapter.number()};
    const BuildResult built = remake(folder.path(), folder / "tracer");
    if (!built.ok) throw app::Failure("does not compile:\n" + built.output);
    return fails(course, chapter, folder / "tracer", true, only);
}

bool report(bool as_it_should, const std::string& what) {
    std::printf("%s %s\n", as_it_should ? "right" : "WRONG", what.c_str());
    std::fflush(stdout);
    return as_it_should;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2 && argc != 3) throw app::UsageError("usage: graft_mistakes NN [FOLDER]");
    const Course course = this_course();
    const Chapter chapter = find_chapter(course, argv[1]);
    if (argc == 3) {
        const TemporaryFolder folder;
        const BuildResult built =
            Remake{course, "tracer." + chapter.number()}(argv[2], folder / "tracer");
        if (!built.ok) throw app::Failure("does not compile:\n" + built.output);
        return report(!fails(course, chapter, folder / "tracer", false), "our answer passes")
                   ? app::done
                   : app::could_not;
    }
    fs::path before = course.root / "solutions/00_toolchain/first.cpp";
    for (const Chapter& other : grafts(course))
        if (other.name < chapter.name) before = tracer_answer(course, other);

    const fs::path ours = course.program("tracer." + chapter.number());
    bool all = report(!fails(course, chapter, ours, false), "our answer passes");
    // The outlines are the same as before; the headers that it must use are what is new.
    if (chapter.graft->reads != Graft::Reads::nothing)
        all = report(source_fails(course, chapter, read_file(before)),
                     "the answer to the graft before fails") &&
              all;
    for (const Mistake& mistake :
         read_mistakes(course.root / "tests/mistakes/tracer" / (chapter.number() + ".md"))) {
        const auto edited = edited_files(mistake, course.root / "solutions/tracer");
        all = report(source_fails(course, chapter, edited.begin()->second, mistake.caught_by),
                     mistake.name) &&
              all;
    }
    return all ? app::done : app::could_not;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return app::could_not;
}
