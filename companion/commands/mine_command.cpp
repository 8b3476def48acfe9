#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/build/build.hpp>
#include <companion/build/side_build.hpp>
#include <companion/check/passing_chapters.hpp>
#include <companion/commands/commands.hpp>
#include <companion/system/process.hpp>
#include <companion/system/terminal.hpp>
#include <cstdio>

namespace companion {

int mine(const Course& course) {
    std::string numbers, last;
    for (const CheckedChapter& one : check_all_chapters(course)) {
        last = one.chapter.name;
        const bool yours = one.passes();
        if (yours) numbers += (numbers.empty() ? "" : ";") + one.chapter.number();
        const std::string whose = yours ? "yours     " : "solution's";
        std::printf("%-16s %s  %s\n", last.c_str(), (yours ? green(whose) : yellow(whose)).c_str(),
                    one.why().c_str());
        std::fflush(stdout);
    }
    if (last.empty()) throw app::Failure("there are no chapters");

    Course from = course;
    std::string program = last + "_solution";
    if (!numbers.empty()) {
        from =
            side_build(course, "mine", {"-DCMAKE_BUILD_TYPE=Release", "-DCOURSE_MINE=" + numbers});
        program = last + "_mine";
    }
    must_build(from, program);
    app::make_folder(course.out());
    fs::remove(course.out() / "mine.png");
    const Result result =
        run_process({.command = {from.program(program).string(), "--out", "mine.png"},
                     .folder = course.out(),
                     .output = Output::shown,
                     .timeout = 900});
    if (!result.ok()) throw app::Failure("the final scene: " + how_it_ended(result));
    std::puts(numbers.empty() ? "The picture is in out/mine.png. None of it is yours yet."
                              : "The picture is in out/mine.png.");
    return app::done;
}

}  // namespace companion
