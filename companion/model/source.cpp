#include <algorithm>
#include <cctype>
#include <companion/model/source.hpp>
#include <regex>

namespace companion {

std::string code_of(const std::string& text, bool keep_strings) {
    std::string code;
    const auto after = [&](std::size_t found, std::size_t length) {
        return found == std::string::npos ? text.size() : found + length;
    };
    for (std::size_t i = 0, end = 0; i < text.size(); i = end) {
        const auto starts = [&](const char* what) { return text.compare(i, 2, what) == 0; };
        const bool is_quote =
            text[i] == '"' ||
            (text[i] == '\'' && (i == 0 || !std::isalnum(static_cast<unsigned char>(text[i - 1]))));
        if (starts("//")) {
            end = after(text.find('\n', i), 1);
            code += '\n';
        } else if (starts("/*")) {
            end = after(text.find("*/", i + 2), 2);
            code += ' ';
        } else if (is_quote || starts("R\"")) {
            if (is_quote) {
                for (end = i + 1; end < text.size() && text[end] != text[i] && text[end] != '\n';
                     ++end)
                    end += text[end] == '\\';
                end = std::min(end + 1, text.size());
            } else {
                const auto open = std::min(text.find('(', i), text.size());
                const std::string close = ')' + text.substr(i + 2, open - i - 2) + '"';
                end = after(text.find(close, open), close.size());
            }
            code +=
                keep_strings ? text.substr(i, end - i) : std::string(2, is_quote ? text[i] : '"');
        } else {
            code += text[i];
            end = i + 1;
        }
    }
    return code;
}

std::vector<std::string> signatures(const std::string& text) {
    std::string code = std::regex_replace(code_of(text), std::regex{"(^|\n)[ \t]*#[^\n]*"}, "\n");
    code = std::regex_replace(
        code, std::regex{"\\b(inline|constexpr|static)\\b|\\[\\[[^\\]]*\\]\\]"}, " ");
    std::vector<std::string> found;
    std::string head;  // the code since the last ; or }
    int skipped = 0;   // open braces within a body
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

}  // namespace companion
