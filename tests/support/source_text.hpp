#pragma once
// Reading the course's own sources, roughly: enough to check rules about them.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace source_text {

namespace fs = std::filesystem;

inline std::string read(const fs::path& path) {
    std::ifstream in{path, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
}

// All files below a folder whose names end in one of these, sorted; none where the
// folder is missing.
inline std::vector<fs::path> files(const fs::path& folder,
                                   const std::vector<std::string>& extensions) {
    std::vector<fs::path> found;
    if (!fs::exists(folder)) return found;
    for (const auto& entry : fs::recursive_directory_iterator{folder})
        if (std::find(extensions.begin(), extensions.end(), entry.path().extension()) !=
            extensions.end())
            found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

inline std::vector<fs::path> folders(const fs::path& folder) {
    std::vector<fs::path> found;
    if (!fs::exists(folder)) return found;
    for (const auto& entry : fs::directory_iterator{folder})
        if (entry.is_directory()) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

// The code without comments and, unless they are to be kept, without the contents of strings.
inline std::string code_of(const std::string& text, bool keep_strings = false) {
    std::string code;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto starts = [&](const char* what) { return text.compare(i, 2, what) == 0; };
        if (starts("//")) {
            while (i < text.size() && text[i] != '\n') ++i;
            code += '\n';
        } else if (starts("/*")) {
            i = std::min(text.find("*/", i), text.size() - 2) + 1;
            code += ' ';
        } else if (starts("R\"")) {
            const auto open = text.find('(', i);
            const std::string close = ')' + text.substr(i + 2, open - i - 2) + '"';
            const auto end = text.find(close, open) + close.size();
            code += keep_strings ? text.substr(i, end - i) : "\"\"";
            i = end - 1;
        } else if (text[i] == '"' ||
                   (text[i] == '\'' &&
                    (i == 0 || !std::isalnum(static_cast<unsigned char>(text[i - 1]))))) {
            const std::size_t start = i;
            for (++i; i < text.size() && text[i] != text[start]; ++i) i += text[i] == '\\';
            code += keep_strings ? text.substr(start, i - start + 1) : std::string(2, text[start]);
        } else {
            code += text[i];
        }
    }
    return code;
}

// What a pattern's first group matches, everywhere.
inline std::vector<std::string> matches(const std::string& text, const char* pattern) {
    const std::regex regex{pattern};
    std::vector<std::string> found;
    for (std::sregex_iterator it{text.begin(), text.end(), regex}, end; it != end; ++it)
        found.push_back((*it)[1]);
    return found;
}

// The functions that a header defines at namespace level: everything up to the body, without
// `inline` and the like, words one space apart.
inline std::vector<std::string> signatures(const std::string& text) {
    std::string code = std::regex_replace(code_of(text), std::regex{"(^|\n)[ \t]*#[^\n]*"}, "\n");
    code = std::regex_replace(
        code, std::regex{"\\b(inline|constexpr|static)\\b|\\[\\[[^\\]]*\\]\\]"}, " ");
    std::vector<std::string> found;
    std::string head;  // since the last ; or }
    int skipped = 0;   // braces that are open within a body
    for (const char c : code) {
        if (skipped > 0) {
            skipped += (c == '{') - (c == '}');
        } else if (c == '{') {
            const bool is_function = head.find('(') != std::string::npos;
            const bool is_namespace = std::regex_search(head, std::regex{"^\\s*namespace\\b"});
            if (is_function) {
                head = std::regex_replace(head, std::regex{"\\s+"}, " ");
                head = std::regex_replace(head, std::regex{"^ | $| (?=[,)&*(])|(\\() "}, "$1");
                found.push_back(head);
            }
            skipped = is_namespace ? 0 : 1;
            head.clear();
        } else if (c == ';' || c == '}') {
            head.clear();
        } else {
            head += c;
        }
    }
    return found;
}

}  // namespace source_text
