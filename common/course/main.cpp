// course COMMAND: the learner's companion. The script ./course builds it and calls it.
#include <app/errors.hpp>
#include <course/commands.hpp>
#include <cstdio>

namespace {

struct Command {
    const char* name;
    const char* arguments;
    const char* summary;
    int (*run)(const course::Course&, const course::Arguments&);
};

constexpr Command commands[] = {
    {"demo", "", "render every chapter's picture, measure, and make the gallery out/index.html",
     course::demo},
    {"study", "[NN]", "measure what accuracy costs, and draw the plots", course::study},
};

int help() {
    std::puts("usage: course COMMAND\n");
    for (const Command& command : commands)
        std::printf("  %-7s %-5s %s\n", command.name, command.arguments, command.summary);
    return app::done;
}

int run(const course::Arguments& words) {
    if (words.empty() || words[0] == "help" || words[0] == "--help") return help();
    std::string known;
    for (const Command& command : commands) {
        if (words[0] == command.name)
            return command.run(course::this_course(), {words.begin() + 1, words.end()});
        known += std::string(command.name) + ", ";
    }
    throw app::UsageError("there is no command '" + words[0] + "'; there are " + known + "help");
}

}  // namespace

int main(int argc, char** argv) {
    return app::run_or_explain("course", [&] { return run({argv + 1, argv + argc}); });
}
