#include <algorithm>
#include <app/errors.hpp>
#include <companion/model/stubs.hpp>
#include <companion/system/files.hpp>
#include <regex>
#include <set>

namespace companion {
namespace {

const std::string file_mark = "==> ";

fs::path file_of(const Course& course, const Chapter& chapter) {
    return course.root / "companion/shipped_stubs" / (chapter.name + ".txt");
}

// The source without comments. Quoted text stays.
std::string code_of(const std::string& source) {
    std::string code;
    for (std::size_t i = 0; i < source.size(); ++i) {
        if (source.compare(i, 2, "//") == 0) {
            i = std::min(source.find('\n', i), source.size());
            code += '\n';
        } else if (source.compare(i, 2, "/*") == 0) {
            const auto end = source.find("*/", i + 2);
            i = end == std::string::npos ? source.size() : end + 1;
            code += ' ';
        } else if (source[i] == '"') {
            const std::size_t start = i;
            for (++i; i < source.size() && source[i] != '"' && source[i] != '\n'; ++i)
                i += source[i] == '\\';
            code += source.substr(start, i - start + 1);
        } else {
            code += source[i];
        }
    }
    return code;
}

}  // namespace

Stubs shipped_stubs(const Course& course, const Chapter& chapter) {
    const fs::path file = file_of(course, chapter);
    if (!fs::exists(file))
        throw app::Failure(file.string() +
                           " is missing: cmake --build build --target shipped_stubs makes it");
    return stubs_from_text(read_text(file));
}

Stubs present_stubs(const Course& course, const Chapter& chapter) {
    const fs::path folder = course.root / "exercises" / chapter.name;
    Stubs stubs;
    if (!fs::exists(folder)) return stubs;
    for (const auto& entry : fs::recursive_directory_iterator{folder}) {
        const std::string kind = entry.path().extension().string();
        if (entry.is_regular_file() && (kind == ".hpp" || kind == ".cpp"))
            stubs[entry.path().lexically_relative(folder)] = read_text(entry.path());
    }
    return stubs;
}

std::string to_text(const Stubs& stubs) {
    std::string text;
    for (const auto& [file, source] : stubs) text += file_mark + file.string() + '\n' + source;
    return text;
}

Stubs stubs_from_text(const std::string& text) {
    Stubs stubs;
    std::string* source = nullptr;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
        const std::string line = text.substr(at, end - at);
        at = end;
        if (line.rfind(file_mark, 0) == 0)
            source = &stubs[line.substr(file_mark.size(), line.size() - file_mark.size() - 1)];
        else if (source)
            *source += line;
        else
            throw app::Failure("the list of shipped stubs does not start with a file name: " +
                               line);
    }
    return stubs;
}

namespace {

// Where the code calls todo("NN.k" for this exercise.
std::vector<std::size_t> todos(const std::string& code, const std::string& exercise) {
    std::vector<std::size_t> found;
    for (auto at = code.find("todo"); at != std::string::npos; at = code.find("todo", at + 4)) {
        auto next = at + 4;
        for (const std::string& part : {std::string{"("}, '"' + exercise + '"'}) {
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
        // A constructor's members may have braces: a blank line or a ; ends the look back.
        const auto start = code.find_last_of(';', at), blank = code.rfind("\n\n", at);
        const std::size_t from = std::max(start == std::string::npos ? 0 : start,
                                          blank == std::string::npos ? 0 : blank);
        std::string before = code.substr(from, at - from);
        if (const auto brace = before.rfind("{\n"); brace != std::string::npos)
            before.erase(0, brace + 1);
        // "fill = {}" has no body.
        for (auto pair = before.find("{}"); pair != std::string::npos; pair = before.find("{}"))
            before.erase(pair, 2);
        std::smatch found;
        if (std::regex_search(before, found, head) && no_function.count(found[1]) == 0)
            return found[1];
    }
    return "";
}

}  // namespace

int count_todos(const std::string& source, const std::string& exercise) {
    return static_cast<int>(todos(code_of(source), exercise).size());
}

std::vector<std::string> functions_to_write(const std::string& source,
                                            const std::string& exercise) {
    const std::string code = code_of(source);
    std::vector<std::string> names;
    for (const std::size_t place : todos(code, exercise))
        if (const std::string name = function_around(code, place);
            std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
    return names;
}

}  // namespace companion
