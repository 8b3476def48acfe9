#include <algorithm>
#include <app/errors.hpp>
#include <companion/build/build.hpp>
#include <companion/build/missing_include.hpp>
#include <companion/build/stale.hpp>
#include <companion/build/turn.hpp>
#include <companion/model/source.hpp>
#include <companion/model/state.hpp>
#include <companion/system/file_lock.hpp>
#include <companion/system/files.hpp>
#include <companion/system/process.hpp>
#include <companion/system/terminal.hpp>
#include <regex>
#include <sstream>
#include <string_view>
#include <thread>

namespace companion {
namespace {

constexpr std::size_t most_words = std::size_t{4} << 20;  // of a build's output

bool has(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

// "\n  the } in line 7 ends a struct: write }; there", if the error is that the ; after a struct is
// missing; otherwise empty. g++ shows what follows the struct.
std::string missing_semicolon(const Course& course, const std::string& error) {
    std::smatch place;
    if (!has(error, "expected initializer before") ||
        !std::regex_search(error, place, std::regex{"^([^:\n]+):(\\d+):"}))
        return "";
    const fs::path file = course.root / place[1].str();
    if (!fs::exists(file)) return "";
    const std::string text = read_file(file);
    if (has(text, "/*")) return "";  // code_of() drops the lines of such a comment
    std::istringstream in{code_of(text)};
    std::vector<std::string> lines;
    const auto before = static_cast<std::size_t>(std::stoul(place[2]) - 1);
    for (std::string line; lines.size() < before && std::getline(in, line);) lines.push_back(line);
    const auto is_blank = [](const std::string& line) {
        return line.find_first_not_of(" \t\r") == std::string::npos;
    };
    while (!lines.empty() && is_blank(lines.back())) lines.pop_back();
    if (lines.empty() || lines.back()[lines.back().find_last_not_of(" \t\r")] != '}') return "";
    // Goes back to the brace that the last one closes.
    int open = 0;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        for (auto at = line->rbegin(); at != line->rend(); ++at)
            if ((open += *at == '}' ? 1 : *at == '{' ? -1 : 0) == 0 && *at == '{') {
                const bool alone = std::next(line) != lines.rend() &&
                                   line->find_first_not_of(" \t") == line->find('{');
                const bool is_struct = std::regex_search(alone ? *std::next(line) : *line,
                                                         std::regex{"\\b(struct|class|enum)\\b"});
                return is_struct ? "\n  the } in line " + std::to_string(lines.size()) +
                                       " ends a struct: write }; there"
                                 : "";
            }
    }
    return "";
}

// What to look at, if the error is that the variable of a `for` is not known because the loop ended
// before; otherwise empty. The compiler's warning about the loop shows its source in the next line.
std::string ended_loop(const std::string& output, const std::string& error) {
    if (!has(error, "declared")) return "";
    std::istringstream in{output};
    std::smatch place, loop;
    for (std::string line, warning; std::getline(in, line); warning = line)
        if ((has(warning, "clause does not guard") || has(warning, "loop has empty body")) &&
            std::regex_search(warning, place, std::regex{":(\\d+):\\d+: "}) &&
            std::regex_search(line, loop, std::regex{"\\bfor \\(.*?(\\w+) [=:]"}) &&
            has(error, '\'' + loop[1].str() + '\''))
            return "the `for` in line " + place[1].str() +
                   " ends before this line: is there a ; after its ), or are braces missing?";
    return "";
}

}  // namespace

std::string with_relative_paths(const Course& course, std::string line) {
    for (const fs::path& folder : {course.root, fs::weakly_canonical(course.root)}) {
        const std::string prefix = folder.generic_string() + '/';
        for (auto at = line.find(prefix); at != std::string::npos; at = line.find(prefix))
            line.erase(at, prefix.size());
    }
    // The build runs in its own folder, so compilers may name files relative to that folder.
    if (line.rfind("../", 0) == 0) line.erase(0, 3);
    return line;
}

BuildResult build(const Course& course, const std::vector<std::string>& targets) {
    const Turn turn{course};
    return build_in_turn(course, targets);
}

BuildResult build_in_turn(const Course& course, const std::vector<std::string>& targets) {
    const FileLock lock{private_folder(course) / "build.lock"};
    const std::vector<std::string> cmake{"cmake", "--build", course.build.string(), "--target"};
    std::vector<std::string> command = cmake;
    command.insert(command.end(), targets.begin(), targets.end());
    command.push_back("--");
    if (fs::exists(course.build / "build.ninja")) {
        command.insert(command.end(), {"-k", "0"});
    } else {
        // make builds one target at a time unless told otherwise, and does not configure anew for a
        // target that it does not know yet.
        command.insert(
            command.end(),
            {"-k", "-j" + std::to_string(std::max(1u, std::thread::hardware_concurrency()))});
        std::vector<std::string> configure = cmake;
        configure.push_back("cmake_check_build_system");
        run_process({.command = configure});
    }
    remove_stale(course);
    const Result result = run_process(
        {.command = command, .most_cpu = most_compiling, .most_memory = memory_of_compiler()});
    note_built(course);
    return {result.ok(), printable(result.output, most_words)};
}

void must_build(const Course& course, const std::string& target) {
    const BuildResult result = build(course, {target});
    if (result.ok) return;
    const std::string error = first_error(course, result.output);
    throw app::Failure(error.empty() ? target + " cannot be built: " +
                                           result.output.substr(0, result.output.find('\n'))
                                     : error.substr(0, error.find('\n')));
}

std::string first_error(const Course& course, const std::string& output,
                        const std::vector<fs::path>& files) {
    // An error, with what a compiler prints around it: before it, how the compiler got there; after
    // it, the source.
    struct Error {
        std::string text;
        std::string came_from;  // "file:line" in the learner's files, if that led to the error
        bool is_within = false;
        std::string meant{};   // the error to show instead: the learner's parameter takes no const
        std::string remedy{};  // the standard library's header that g++ names
    };
    const auto with_remedy = [&](const Error& error) {
        std::string add = ended_loop(output, error.text);
        if (add.empty())
            add = error.remedy.empty() ? missing_include(course, error.text) : error.remedy;
        return error.text + missing_semicolon(course, error.text) +
               (add.empty() ? "" : "\n  " + add);
    };
    std::vector<Error> errors;
    std::string linker, came_from, open_brace;
    int shown = 0;              // lines of source that have been kept
    bool takes_source = false;  // the lines of source that follow belong to the note
    // The "file:line" of one of the files, if this line of output contains it.
    const auto place_in = [&](const std::string& line) -> std::string {
        for (const fs::path& file : files)
            if (const auto at = line.find(file.string() + ':'); at != std::string::npos) {
                const auto number = at + file.string().size() + 1;
                return line.substr(at, line.find_first_not_of("0123456789", number) - at);
            }
        return "";
    };
    std::istringstream in{output};
    for (std::string line; std::getline(in, line);) {
        line = with_relative_paths(course, line);
        const std::string place = place_in(line);
        const bool is_in_files = !place.empty(), is_within = is_in_files && line.find(place) == 0;
        // "file:line:column: error: what"
        if (has(line, ": error: ") || has(line, ": fatal error: ") || has(line, "out of memory")) {
            errors.push_back({line, came_from, is_within});
            takes_source = false;
            came_from.clear();
            shown = 0;
        } else if (takes_source && line.rfind(' ', 0) == 0) {
            errors.back().meant += '\n' + line;
            takes_source = false;
        } else if (!errors.empty() && line.rfind(' ', 0) == 0 && shown < 2) {
            errors.back().text += '\n' + line;
            ++shown;
        } else {
            shown = 2;
            std::smatch header;
            if (!errors.empty() &&
                std::regex_search(line, header,
                                  std::regex{": note: .*'(.+)' is defined in header '(<\\w+>)'"}))
                errors.back().remedy =
                    "add #include " + header[2].str() + ", which declares " + header[1].str();
            if (is_within && has(line, "to match this")) open_brace = line;
            const bool is_refusal = has(line, "would lose const") ||
                                    (has(line, "initializing argument") && !errors.empty() &&
                                     has(errors.back().text, "discards qualifiers"));
            if (is_within && is_refusal && !errors.empty() && errors.back().meant.empty()) {
                const auto note = line.find(": note: ");
                const std::string& text = errors.back().text;
                const auto what = text.find(": error: ");
                errors.back().meant =
                    has(line, "would lose const")
                        ? line.substr(0, note) + ": error: " + line.substr(note + 8)
                        : line.substr(0, note) + text.substr(what, text.find('\n') - what);
                takes_source = true;
            }
            if (is_in_files && (has(line, "from ") || has(line, "required "))) came_from = place;
        }
        if (linker.empty() &&
            (has(line, "undefined reference to ") || has(line, "multiple definition of ") ||
             has(line, "Undefined symbol"))) {
            const auto colon = line.rfind(": ");  // Apple's linker writes none
            linker = "the linker says: " +
                     line.substr(line.find_first_of("uUm", colon == line.npos ? 0 : colon));
        }
    }
    for (const Error& error : errors)
        if (error.is_within) return with_remedy(error);
    // After a brace that is never closed, every error is misleading, and this is the last message.
    if (!open_brace.empty())
        return open_brace.substr(0, open_brace.find(": note: ")) +
               ": error: the brace { here is never closed";
    for (const Error& error : errors)
        if (!error.meant.empty()) return error.meant;
    for (const Error& error : errors)
        if (!error.came_from.empty()) return error.text + "\n  which came from " + error.came_from;
    return errors.empty() ? linker : errors.front().text;
}

std::string first_warning(const Course& course, const std::string& output,
                          const std::vector<fs::path>& files) {
    const std::string mark = ": warning: ";
    const char* const grave[]{"[-Wreturn-type",          "[-Wreturn-local-addr",
                              "[-Wreturn-stack-address", "[-Wdangling",
                              "[-Winfinite-recursion",   "[-Wuninitialized",
                              "[-Wmaybe-uninitialized",  "[-Wsometimes-uninitialized"};
    std::string first, elsewhere;
    std::istringstream in{output};
    for (std::string line; std::getline(in, line);) {
        line = with_relative_paths(course, line);
        const auto at = line.find(mark);
        const auto file = std::find_if(files.begin(), files.end(), [&](const fs::path& one) {
            return line.rfind(one.string() + ':', 0) == 0;
        });
        const bool is_in_files = file != files.end();
        // "file:line" of "file:line:column: what"
        const auto place = [&] {
            return line.substr(0, line.find(':', file->string().size() + 1));
        };
        if (at == std::string::npos) {
            // g++ may warn about a variable at the place where it is used, in the test that calls
            // the learner's function, and only then note where the variable was declared.
            if (is_in_files && !elsewhere.empty() && has(line, ": note: "))
                return place() + ": " + elsewhere;
            continue;
        }
        // "file:line:column: warning: what [-Wname]"
        const auto option = line.rfind(" [-W");
        const auto what = at + mark.size();
        const std::string warning =
            line.substr(what, option == std::string::npos ? option : option - what);
        const bool is_grave = std::any_of(std::begin(grave), std::end(grave),
                                          [&](const char* name) { return has(line, name); });
        elsewhere = is_grave && !is_in_files ? warning : "";
        if (!is_in_files) continue;
        if (is_grave) return place() + ": " + warning;
        if (first.empty()) first = place() + ": " + warning;
    }
    return first;
}

}  // namespace companion
