#pragma once
// The commands of the companion, which commands.inc declares, each in a file of its own.

#include <companion/model/course.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace companion {

// What was typed after a command's name.
struct Given {
    std::optional<std::string> named = {};            // such as a chapter or an exercise
    std::map<std::string, std::string> options = {};  // by name, "--seed"; a flag's value is empty
    std::vector<std::string> rest = {};               // for the program that the command runs

    bool has(const std::string& option) const { return options.count(option) > 0; }
    // The value of an option that takes a whole number; 0 if it was not given.
    std::uint64_t number(const std::string& option) const {
        return has(option) ? std::stoull(options.at(option)) : 0;
    }
};

// Each returns the exit code.
#define TEXT(words)
#define SCRIPT(name, takes, about)
#define OPTION(name, takes, about)
#define COMMAND(name, takes, about) int name(const Course& course, const Given& given);
#define ALIAS(name, takes, about) COMMAND(name, takes, about)
#include <companion/commands/commands.inc>
#undef ALIAS
#undef COMMAND
#undef OPTION

}  // namespace companion
