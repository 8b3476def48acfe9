#include <unistd.h>

#include <companion/commands/judged_lines.hpp>
#include <companion/system/terminal.hpp>
#include <random>

namespace companion {

JudgedLines::JudgedLines() : on_terminal_{::isatty(STDOUT_FILENO) != 0} {
    if (on_terminal_) begins = [](const std::string& what) { print(dim("  " + what + " ...")); };
}

void JudgedLines::operator()(const JudgedLine& line) {
    ++lines;
    passed += line.passed;
    if (on_terminal_) print("\r\033[K");
    const std::string first = (line.passed ? "+ " : "x ") + line.what + '\n';
    print((line.passed ? green(first) : red(first)) + wrapped(line.actual, "    ") + '\n');
    if (line.passed) return;
    print(wrapped("expected: " + line.expected, "    ") + '\n');
    if (!line.suggestion.empty()) print(wrapped(line.suggestion, "    ") + '\n');
}

std::uint64_t scenes_seed(const Given& given) {
    const std::uint64_t wanted = given.number("--seed");
    return wanted ? wanted : 1 + std::random_device{}() % 9999;
}

}  // namespace companion
