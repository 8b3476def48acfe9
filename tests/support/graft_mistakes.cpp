// graft_mistakes NN: our answer to a graft passes; the one to the graft before it does not, and no
// mistake of tests/mistakes/tracer/NN.md does: each fails at the line that it names, and the
// learner is told what main() hands over, by the mistake's remark, or else the mistake's title. The
// same holds for a right tracer that is written in another way, tests/other_tracers/NN.cpp, if
// there is one, and its mistakes. Lines that a busy machine cannot judge do not count.
//
// graft_mistakes NN FOLDER: our answer passes with the headers of this folder, too.

#include <app/errors.hpp>
#include <companion/build/remake.hpp>
#include <companion/model/mistakes.hpp>
#include <companion/own/graft_reason.hpp>
#include <companion/own/tracer.hpp>
#include <companion/system/files.hpp>
#include <cstdio>
#include <map>
#include <optional>
#include <regex>

#include "temporary_folder.hpp"

using namespace companion;
using checkpoint::TemporaryFolder;

namespace {

// The first line that fails for a program: this line, or any if it is empty. On a busy machine, one
// may.
std::optional<JudgedLine> failing_line(GraftRequest request, const Course& course, bool may,
                                       const std::string& only = {}) {
    request.only_line = only;
    struct Enough {};
    std::optional<JudgedLine> found;
    try {
        judge_graft(course, request, [&](const JudgedLine& line) {
            if (line.busy_machine ? !may : line.passed) return;
            std::printf("    x %s: %s\n", line.what.c_str(), line.actual.c_str());
            found = line;
            throw Enough{};
        });
    } catch (const Enough&) {
    }
    return found;
}

GraftRequest request_for(const Course& course, const Chapter& chapter, const fs::path& program) {
    return {chapter, program, course.program("tracer." + chapter.number()), chapter.graft->headers};
}

bool passes(const Course& course, const Chapter& chapter, const fs::path& program) {
    return !failing_line(request_for(course, chapter, program), course, false);
}

// A program that is compiled like the answer, from this source.
class Program {
  public:
    Program(const Course& course, const Chapter& chapter, const std::string& source,
            const std::map<std::string, std::string>& headers = {}) {
        checkpoint::write_file(folder_ / (chapter.number() + ".cpp"), source);
        for (const auto& [name, text] : headers) checkpoint::write_file(folder_ / name, text);
        const Remake remake{course, "tracer." + chapter.number()};
        const BuildResult built = remake(folder_.path(), path());
        if (!built.ok) throw app::Failure("does not compile:\n" + built.output);
    }
    fs::path path() const { return folder_ / "tracer"; }

  private:
    TemporaryFolder folder_;
};

bool report(bool as_it_should, const std::string& what) {
    std::printf("%s %s\n", as_it_should ? "right" : "WRONG", what.c_str());
    std::fflush(stdout);
    return as_it_should;
}

// Whether the mistakes in this file, each made in a source from this folder, fail and are told.
bool are_told(const Course& course, const Chapter& chapter, const fs::path& file,
              const fs::path& folder) {
    bool all = true;
    for (const Mistake& mistake : read_mistakes(file)) {
        const std::string source = edited_files(mistake, folder).begin()->second;
        const Program program{course, chapter, source};
        const GraftRequest request = request_for(course, chapter, program.path());
        const auto line = failing_line(request, course, true, mistake.caught_by);
        if (!line) {
            all = report(false, mistake.name + " passes");
            continue;
        }
        const std::string words = GraftReason{course, request, source}(*line);
        const auto pattern = mistake.remarks.find("main hands over");
        const bool is_told = pattern == mistake.remarks.end()
                                 ? words.find("ike: " + mistake.title + ". ") != std::string::npos
                                 : std::regex_search(words, std::regex{pattern->second});
        all = report(is_told, mistake.name + ": " + words) && all;
    }
    return all;
}

// Nothing is told of a right tracer's main(), even if it is asked for a reason.
bool is_not_blamed(const Course& course, const Chapter& chapter, const std::string& source) {
    const Program program{course, chapter, source};
    const GraftRequest request = request_for(course, chapter, program.path());
    GraftReason reason{course, request, source};
    bool all = true;
    judge_graft(course, request, [&](JudgedLine line) {
        line.passed = false;
        line.suggestion = "";
        const std::string words = reason(line);
        all = all && words.find("In your main()") == std::string::npos &&
              words.find("This looks like") == std::string::npos;
        if (!words.empty()) std::printf("    %s: %s\n", line.what.c_str(), words.c_str());
    });
    return all;
}

// A wrong header is told from a wrong main(), even if its checkpoints pass, as they may.
bool header_is_told(const Course& course, const Chapter& chapter, const std::string& mistake) {
    const std::string source = read_file(tracer_answer(course, chapter));
    const Program program{
        course, chapter, source,
        edited_files(course, chapter.name, read_mistake(course, chapter, mistake))};
    const GraftRequest request = request_for(course, chapter, program.path());
    const auto line = failing_line(request, course, true);
    return line && GraftReason{course, request, source}(*line).find("One of your headers") !=
                       std::string::npos;
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
        return report(passes(course, chapter, folder / "tracer"), "our answer passes")
                   ? app::done
                   : app::could_not;
    }
    fs::path before = course.root / "solutions/00_toolchain/first.cpp";
    for (const Chapter& other : grafts(course))
        if (other.name < chapter.name) before = tracer_answer(course, other);

    bool all = report(passes(course, chapter, course.program("tracer." + chapter.number())),
                      "our answer passes");
    // The outlines are the same as before; the headers that it must use are what is new.
    if (chapter.graft->reads != Graft::Reads::nothing)
        all = report(failing_line(request_for(course, chapter,
                                              Program{course, chapter, read_file(before)}.path()),
                                  course, true)
                         .has_value(),
                     "the answer to the graft before fails") &&
              all;
    const std::string number = chapter.number();
    all = are_told(course, chapter, course.root / "tests/mistakes/tracer" / (number + ".md"),
                   course.root / "solutions/tracer") &&
          all;
    if (number == "05")
        all = report(header_is_told(course, chapter, "05.2_darkens"), "a wrong header is told") &&
              all;
    const fs::path others = course.root / "tests/other_tracers";
    if (!fs::exists(others / (number + ".cpp"))) return all ? app::done : app::could_not;
    const std::string other = read_file(others / (number + ".cpp"));
    all = report(passes(course, chapter, Program{course, chapter, other}.path()),
                 "another right tracer passes") &&
          all;
    all = report(is_not_blamed(course, chapter, other), "nothing is told of it") && all;
    all = are_told(course, chapter, others / (number + ".md"), others) && all;
    return all ? app::done : app::could_not;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return app::could_not;
}
