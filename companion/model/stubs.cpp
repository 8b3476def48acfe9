#include <algorithm>
#include <app/errors.hpp>
#include <companion/model/stubs.hpp>
#include <companion/system/files.hpp>

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
    return stubs_from_text(read_file(file));
}

Stubs present_stubs(const Course& course, const Chapter& chapter) {
    const fs::path folder = course.root / "exercises" / chapter.name;
    Stubs stubs;
    if (!fs::exists(folder)) return stubs;
    for (const auto& entry : fs::recursive_directory_iterator{folder}) {
        const std::string kind = entry.path().extension().string();
        if (entry.is_regular_file() && (kind == ".hpp" || kind == ".cpp"))
            stubs[entry.path().lexically_relative(folder)] = read_file(entry.path());
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
            throw app::Failure("the list of shipped stubs starts with no file's name: " + line);
    }
    return stubs;
}

int count_todos(const std::string& source, const std::string& exercise) {
    const std::string code = code_of(source);
    int count = 0;
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
        count += next != std::string::npos;
    }
    return count;
}

}  // namespace companion
