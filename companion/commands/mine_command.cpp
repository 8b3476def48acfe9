#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/build/build.hpp>
#include <companion/check/yours.hpp>
#include <companion/commands/commands.hpp>
#include <companion/model/state.hpp>
#include <companion/system/files.hpp>
#include <companion/system/process.hpp>
#include <cstdio>

namespace companion {

int mine(const Course& course, const Given&) {
    const Chapter last = core_chapters(course).back();
    const Yours yours = put_yours_in_place(course, last);
    std::puts(yours.words().c_str());
    std::fflush(stdout);
    must_build(course, last.name + "_mine");
    app::make_folder(course.out());
    const Result result =
        run_process({.command = {course.program(last.name + "_mine").string(), "--out", "mine.png"},
                     .folder = course.out(),
                     .output = Output::printable,
                     .passes_signals = true,
                     .timeout = 900});
    if (result.passed_on) return app::stopped_by + result.passed_on;
    if (!result.ok()) throw app::Failure("the final scene: " + how_it_ended(result));
    // The page of `book --mine` says whose code drew it.
    const std::string hash = hash_of(read_file(course.out() / "mine.png"));
    change_state(course, [&](State& state) { state.drawn = {hash, yours.passing}; });
    std::puts("The picture is in out/mine.png.");
    return app::done;
}

}  // namespace companion
