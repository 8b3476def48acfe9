#include <app/errors.hpp>
#include <companion/check/prepare.hpp>
#include <companion/commands/commands.hpp>
#include <companion/system/terminal.hpp>

namespace companion {

int prepare(const Course& course, const Given& given) {
    if (given.has("--end"))
        end_preparing(course);
    else
        prepare(course, next_exercises(course),
                [](const std::string& what) { print("Building " + what + ".\n"); });
    return app::done;
}

}  // namespace companion
