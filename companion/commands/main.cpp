// course COMMAND: the learner's companion. The script ./course builds it and calls it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <app/errors.hpp>
#include <app/json.hpp>
#include <app/nearest_word.hpp>
#include <companion/commands/commands.hpp>
#include <companion/model/stubs.hpp>
#include <companion/system/files.hpp>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <utility>

namespace {

using Words = std::vector<std::string>;

// The help on all commands; the script ./course shows the same file.
std::string help() {
    return companion::read_file(companion::fs::path{COURSE_ROOT} / "companion/help.txt");
}

// The help's line on one command, "check   [NN | NN.k]  build and try ...".
std::string help(const std::string& command) {
    std::istringstream text{help()};
    for (std::string line; std::getline(text, line);)
        if (line.rfind("  " + command + ' ', 0) == 0) return line.substr(2) + '\n';
    return "";
}

bool is_help(const std::string& word) {
    return word == "--help" || word == "-h";
}

// The commands, what each of them takes, and what was named.
struct CommandLine {
    CLI::App parser{"", "course"};
    Words names;
    companion::Named named;
    companion::Named sanitizer;  // of check --sanitize
    companion::Named answer;     // of ask --answer
    bool every_star = false;     // of check --stars
    bool is_mine = false;        // of study --mine
    bool of_texts = false;       // of study --docs
    std::string folder;          // of own judge
    int rung = 0;                // likewise; 0: all
    companion::Named part;       // likewise
    std::uint64_t seed = 0;      // likewise; 0: any
    int exit_code = app::done;

    CLI::App* add(const char* name, std::function<int()> run) {
        names.emplace_back(name);
        CLI::App* const command = parser.add_subcommand(name);
        command->callback([this, run = std::move(run)] { exit_code = run(); });
        return command;
    }
    CLI::Option* add(const char* name, const char* argument, std::function<int()> run) {
        return add(name, std::move(run))
            ->add_option_function<std::string>(argument,
                                               [this](const std::string& word) { named = word; });
    }

    explicit CommandLine(const companion::Course& course) {
        parser.require_subcommand(1);
        parser.set_help_flag();  // it may belong to the program that `run` runs
        using namespace companion;
        add("list", [&] { return list(course); });
        add("check", "chapter-or-exercise", [&] {
            if (!sanitizer) return check(course, named, every_star);
            if (!named && !sanitizer->empty()) named = std::exchange(*sanitizer, "");
            if (!named) throw app::UsageError("check --sanitize: needs an exercise, such as 01.3");
            return check_sanitized(course, *named, *sanitizer);
        });
        parser.get_subcommand("check")
            ->add_option_function<std::string>(
                "--sanitize", [this](const std::string& name) { sanitizer = name; })
            ->expected(0, 1)
            ->trigger_on_parse();
        parser.get_subcommand("check")->add_flag("--stars", every_star);
        add("watch", "chapter", [&] { return watch(course, named); });
        add("hint", "exercise", [&] { return hint(course, *named); })->required();
        add("run", "chapter", [&] {
            return run(course, *named, parser.get_subcommand("run")->remaining());
        })->required();
        parser.get_subcommand("run")->prefix_command();
        add("compare", "chapter", [&] { return compare(course, *named); })->required();
        add("mine", [&] { return mine(course); });
        add("certify", [&] { return certify(course); });
        CLI::App* const own = add("own", [&] { return exit_code; });
        own->require_subcommand(1);
        CLI::App* const created = own->add_subcommand("new");
        created->add_option("folder", folder)->required();
        created->callback([&] { exit_code = own_new(course, folder); });
        CLI::App* const judged = own->add_subcommand("judge");
        judged->add_option("folder", folder)->required();
        judged->add_option("--rung", rung);
        judged->add_option_function<std::string>("--part",
                                                 [this](const std::string& name) { part = name; });
        judged->add_option("--seed", seed);
        judged->callback([&] { exit_code = own_judge(course, folder, rung, part, seed); });
        add("reset", "exercise", [&] { return reset(course, *named); })->required();
        add("ask", "chapter", [&] { return ask(course, named, answer); });
        parser.get_subcommand("ask")->add_option_function<std::string>(
            "--answer", [this](const std::string& words) { answer = words; });
        add("demo", [&] { return demo(course); });
        add("book", [&] { return book_mine(course); });  // the texts' pages are the script's part
        parser.get_subcommand("book")->add_flag("--mine")->required();
        CLI::Option* const studied = add("study", "chapter", [&] {
            return of_texts ? study_of_texts(course) : study(course, named, is_mine);
        });
        CLI::App* const study = parser.get_subcommand("study");
        study->add_flag("--docs", of_texts)->excludes(studied, study->add_flag("--mine", is_mine));
    }
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;
};

[[noreturn]] void refuse(const std::string& word, const Words& known) {
    const std::string guess =
        app::nearest_word(word, known, std::min<std::size_t>(2, word.size() - 1));
    std::string all;
    for (const std::string& name : known) all += name + ", ";
    throw app::UsageError(
        "there is no command '" + word + "'; " +
        (guess.empty() ? "the commands are " + all + "help" : "did you mean " + guess + '?'));
}

int obey(Words words) {
    if (words.empty()) words = {"list"};
    if (words[0] == "help" || is_help(words[0])) {
        std::fputs(help().c_str(), stdout);
        return app::done;
    }
    const companion::Course course = companion::this_course();
    companion::keep_stubs(course);
    CommandLine commands{course};
    const std::string name = words[0];
    if (std::count(commands.names.begin(), commands.names.end(), name) == 0)
        refuse(name, commands.names);
    if (words.size() > 1 && is_help(words[1])) {
        std::fputs(("usage: course " + help(name)).c_str(), stdout);
        return app::done;
    }
    try {
        std::reverse(words.begin(), words.end());  // as the parser wants them
        commands.parser.parse(words);
    } catch (const CLI::ParseError& error) {
        throw app::UsageError(name + ": " + error.what() + "; ./course " + name +
                              " --help shows what it takes");
    }
    return commands.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
    // In English, because the companion reads the messages of compilers and CMake.
    ::setenv("LC_ALL", "C", true);
    return app::run_or_explain("course", [&] { return obey({argv + 1, argv + argc}); });
}
