// course COMMAND: the learner's companion. The script ./course builds it and calls it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <app/errors.hpp>
#include <app/nearest_word.hpp>
#include <companion/commands/commands.hpp>
#include <companion/model/stubs.hpp>
#include <companion/system/platform.hpp>
#include <sstream>

namespace {

using companion::Course;
using companion::Given;
using Words = std::vector<std::string>;

// A line of commands.inc: a command, or an option of the command before it.
struct Declared {
    std::string name, takes;
    int (*run)(const Course&, const Given&) = nullptr;  // null: an option
};

const Declared declared[] = {
#define COMMAND(name, takes, about) {#name, takes, companion::name},
#define ALIAS(name, takes, about) COMMAND(name, takes, about)
#define OPTION(name, takes, about) {name, takes},
#include <companion/commands/commands.inc>
};

// The words of a command: "own_judge" is typed as two.
Words words_of(const Declared& command) {
    Words words;
    std::istringstream in{command.name};
    for (std::string word; std::getline(in, word, '_');) words.push_back(word);
    return words;
}

// The parser that is made from the declarations.
class CommandLine {
  public:
    explicit CommandLine(const Course& course) {
        parser_.set_help_flag();  // the script's, or that of the program that `run` runs
        parser_.allow_windows_style_options(false);  // "/c/own" names a folder, on Windows too
        CLI::App* command = nullptr;
        for (const Declared& one : declared)
            if (one.run)
                command = add_command(course, one);
            else
                add_option(*command, one);
    }
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    // Runs what these words ask for. Throws CLI::ParseError if they do not fit the declarations.
    int obey(Words words) {
        std::reverse(words.begin(), words.end());  // the parser expects them in reverse
        try {
            parser_.parse(words);
        } catch (const CLI::ExtrasError&) {  // its message lists them backward
            std::string extra;
            for (const std::string& word : parser_.remaining(true)) extra += ' ' + word;
            throw CLI::ParseError("not expected:" + extra, app::bad_input);
        }
        return exit_code_;
    }

  private:
    CLI::App* add_command(const Course& course, const Declared& one) {
        CLI::App* command = &parser_;
        for (const std::string& word : words_of(one)) {
            command->require_subcommand(1);
            const auto known = command->get_subcommands(
                [&](const CLI::App* other) { return other->get_name() == word; });
            command = known.empty() ? command->add_subcommand(word) : known.front();
        }
        if (!one.takes.empty()) {
            const bool is_optional = one.takes.front() == '[';
            const auto start = one.takes.find_first_not_of('[');
            command
                ->add_option_function<std::string>(
                    one.takes.substr(start, one.takes.find_first_of(" ]") - start),
                    [this](const std::string& word) { given_.named = word; })
                ->required(!is_optional);
        }
        if (one.takes.find("OPTIONS") != std::string::npos) command->prefix_command();
        command->callback([this, &course, command, run = one.run] {
            given_.rest = command->remaining();
            exit_code_ = run(course, given_);
        });
        return command;
    }

    void add_option(CLI::App& command, const Declared& one) {
        const auto take = [this, name = one.name](const std::string& value) {
            given_.options[name] = value;
        };
        if (one.takes.empty()) {
            command.add_flag_callback(one.name, [take] { take(""); });
            return;
        }
        CLI::Option* const option = command.add_option_function<std::string>(one.name, take);
        if (one.takes.front() == '[') option->expected(0, 1)->trigger_on_parse();
        if (one.takes == "N")
            option->check([](const std::string& text) {
                const bool fits = !text.empty() && text.size() < 19 &&
                                  text.find_first_not_of("0123456789") == std::string::npos;
                return fits ? "" : '\'' + text + "' is not a whole number";
            });
    }

    CLI::App parser_{"", "course"};
    Given given_;
    int exit_code_ = app::done;
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

int obey(const Words& words) {
    Words known;
    for (const Declared& one : declared)
        if (one.run && (known.empty() || known.back() != words_of(one)[0]))
            known.push_back(words_of(one)[0]);
    if (std::count(known.begin(), known.end(), words[0]) == 0) refuse(words[0], known);
    const Course course = companion::this_course();
    companion::keep_stubs(course);
    CommandLine line{course};
    try {
        return line.obey(words);
    } catch (const CLI::ParseError& error) {
        throw app::UsageError(words[0] + ": " + error.what() + "; ./course " + words[0] +
                              " --help shows what it takes");
    }
}

}  // namespace

int main(int argc, char** argv) {
    // In English, because the companion reads the messages of compilers and CMake.
    companion::set_variable("LC_ALL", "C");
    Words words{argv + 1, argv + argc};
    if (words.empty()) words = {"list"};
    return app::run_or_explain("course", [&] { return obey(words); });
}
