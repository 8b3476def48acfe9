#include <algorithm>
#include <app/files.hpp>
#include <companion/model/course_file.hpp>
#include <companion/model/source.hpp>
#include <companion/model/stubs.hpp>
#include <companion/system/files.hpp>
#include <companion/system/process.hpp>
#include <regex>
#include <set>
#include <sstream>

namespace companion {
namespace {

fs::path kept_file(const Course& course, const fs::path& file) {
    return course.root / ".course/stubs" / file.lexically_relative("exercises");
}

// Whether the file is the same as in the course's repository: then it is a stub, even if it differs
// from the copy.
bool is_as_committed(const Course& course, const fs::path& file) {
    return run_process({.command = {"git", "diff", "--quiet", "HEAD", "--", file.string()},
                        .folder = course.root})
        .ok();
}

// The positions at which the code calls todo("NN.k" for this exercise, or for any exercise if its
// name is empty.
std::vector<std::size_t> todos(const std::string& code, const std::string& exercise) {
    std::vector<std::size_t> found;
    for (auto at = code.find("todo"); at != std::string::npos; at = code.find("todo", at + 4)) {
        auto next = at + 4;
        const std::string name = exercise.empty() ? "\"" : '"' + exercise + '"';
        for (const std::string& part : {std::string{"("}, name}) {
            next = std::min(code.find_first_not_of(" \t\r\n", next), code.size());
            if (code.compare(next, part.size(), part) != 0) {
                next = std::string::npos;
                break;
            }
            next += part.size();
        }
        if (next != std::string::npos) found.push_back(at);
    }
    return found;
}

// The name of the function whose body encloses a position: the word before its parameters.
std::string function_around(const std::string& code, std::size_t place) {
    static const std::regex head{
        R"((operator\s*[^\s\w(]+|~?[A-Za-z_]\w*)\s*\([^;{}]*\)[^;{}()]*(:[^;]*)?$)"};
    static const std::set<std::string> no_function{"if", "for", "while", "switch", "catch"};
    int depth = 0;
    for (std::size_t at = place; at-- > 0;) {
        if (code[at] == '}') ++depth;
        if (code[at] != '{' || depth-- > 0) continue;
        depth = 0;
        // A constructor's member list may contain braces, so the search backward ends only at a
        // blank line or a ;.
        const auto start = code.find_last_of(';', at), blank = code.rfind("\n\n", at);
        const std::size_t from = std::max(start == std::string::npos ? 0 : start,
                                          blank == std::string::npos ? 0 : blank);
        std::string before = code.substr(from, at - from);
        if (const auto brace = before.rfind("{\n"); brace != std::string::npos)
            before.erase(0, brace + 1);
        // The braces of "fill = {}" are not a body.
        for (auto pair = before.find("{}"); pair != std::string::npos; pair = before.find("{}"))
            before.erase(pair, 2);
        std::smatch found;
        if (std::regex_search(before, found, head) && no_function.count(found[1]) == 0)
            return found[1];
    }
    return "";
}

bool begins(const std::string& line, const char* word) {
    return line.rfind(word, 0) == 0;
}

}  // namespace

std::string core_contract(const std::string& stub) {
    std::string contract;
    enum { code, comment, left_out, declaration } now = code;
    std::istringstream lines{stub};
    for (std::string line; std::getline(lines, line);) {
        if (begins(line, "//")) {
            if (begins(line, "// Star:") || begins(line, "// Source:")) now = left_out;
            if (now == left_out) continue;
            if (now != comment && !contract.empty()) contract += '\n';
            now = comment;
            contract += line.substr(std::min<std::size_t>(3, line.size())) + '\n';
            continue;
        }
        const bool is_blank = line.find_first_not_of(" \t") == std::string::npos;
        if (is_blank || begins(line, "#") || now == code) {
            now = code;
            continue;
        }
        const auto end = line.find_first_of("{;");
        const auto last = line.substr(0, end).find_last_not_of(' ');
        contract += line.substr(0, last == std::string::npos ? 0 : last + 1) + '\n';
        now = end == std::string::npos ? declaration : code;
    }
    return contract;
}

int count_todos(const std::string& source, const std::string& exercise) {
    return static_cast<int>(todos(code_of(source, true), exercise).size());
}

int count_todos(const std::string& source) {
    return count_todos(source, "");
}

void keep_stubs(const Course& course) try {
    for (const Exercise& exercise : read_course_file(course).exercises)
        for (const fs::path& file : exercise.files) {
            const std::string now = text_if_there(course.root / file),
                              kept = text_if_there(kept_file(course, file));
            if (now == kept) continue;
            const int left = count_todos(now), all = count_todos(kept);
            if (left == 0 || left < all) continue;
            if (left == all && !is_as_committed(course, file)) continue;
            app::make_folder(kept_file(course, file).parent_path());
            app::replace_file(kept_file(course, file), now);
        }
} catch (const std::exception&) {  // a checkout that cannot be written to, or a broken course.json:
                                   // others say so
}

std::string shipped_stub(const Course& course, const fs::path& file) {
    if (const std::string kept = text_if_there(kept_file(course, file)); !kept.empty()) return kept;
    const std::string now = text_if_there(course.root / file);
    return count_todos(now) > 0 ? now : "";
}

std::vector<std::string> functions_to_write(const std::string& source,
                                            const std::string& exercise) {
    const std::string code = code_of(source, true);
    std::vector<std::string> names;
    for (const std::size_t place : todos(code, exercise))
        if (const std::string name = function_around(code, place);
            std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
    return names;
}

}  // namespace companion
