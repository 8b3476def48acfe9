// course COMMAND: the learner's companion. The script ./course builds it and calls it.
#include <algorithm>
#include <app/errors.hpp>
#include <app/json.hpp>
#include <companion/commands/commands.hpp>
#include <cstdio>

namespace {

struct Command {
    const char* name;
    const char* arguments;
    const char* summary;
    int (*run)(const companion::Course&, const companion::Arguments&);
};

// The script ./course has the same lines in its help, and a test compares them.
constexpr Command commands[] = {
    {"list", "", "how far you are, and what comes next (so does ./course alone)", companion::list},
    {"check", "[NN | NN.k]", "build and try your answers: to all, a chapter, an exercise",
     companion::check},
    {"watch", "[NN]", "check on every save, and move on by itself", companion::watch},
    {"hint", "NN.k", "the next of three hints: the idea, the formula, the shape of the code",
     companion::hint},
    {"run", "NN [OPTIONS]", "draw the chapter's picture with your code", companion::run},
    {"compare", "NN", "your picture beside the solution's, and whether they are the same",
     companion::compare},
    {"mine", "", "the final scene, drawn with your code where its checkpoints pass",
     companion::mine},
    {"certify", "", "the final test of your own code, with measured figures", companion::certify},
    {"reset", "NN.k", "put the exercise's stub back; what you wrote is kept", companion::reset},
    {"demo", "", "render every chapter's picture, measure, and make the gallery out/index.html",
     companion::demo},
    {"study", "[NN]", "measure what accuracy costs, and draw the plots", companion::study},
};

int help() {
    std::puts("usage: course COMMAND\n");
    for (const Command& command : commands)
        std::printf("  %-7s %-12s %s\n", command.name, command.arguments, command.summary);
    return app::done;
}

int help(const Command& command) {
    std::printf("usage: course %s%s%s\n\n  %s\n", command.name, *command.arguments ? " " : "",
                command.arguments, command.summary);
    return app::done;
}

bool is_help(const std::string& word) {
    return word == "--help" || word == "-h";
}

// The command that a word is nearly; empty where none is.
std::string meant(const std::string& word) {
    std::vector<std::string> names;
    for (const Command& command : commands) names.emplace_back(command.name);
    return app::nearest_word(word, names, std::min<std::size_t>(2, word.size() - 1));
}

int dispatch(const companion::Arguments& words) {
    if (words.empty()) return companion::list(companion::this_course(), {});
    if (words[0] == "help" || is_help(words[0])) return help();
    std::string known;
    for (const Command& command : commands) {
        if (words[0] == command.name && words.size() > 1 && is_help(words[1])) return help(command);
        if (words[0] == command.name)
            return command.run(companion::this_course(), {words.begin() + 1, words.end()});
        known += std::string(command.name) + ", ";
    }
    const std::string guess = meant(words[0]);
    throw app::UsageError(
        "there is no command '" + words[0] + "'; " +
        (guess.empty() ? "there are " + known + "help" : "did you mean " + guess + '?'));
}

}  // namespace

int main(int argc, char** argv) {
    return app::run_or_explain("course", [&] { return dispatch({argv + 1, argv + argc}); });
}
