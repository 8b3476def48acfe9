#include <companion/pages/markdown.hpp>
#include <sstream>

namespace companion {
namespace {

bool starts_with(const std::string& text, std::size_t at, const std::string& start) {
    return text.compare(at, start.size(), start) == 0;
}

bool is_blank(const std::string& line) {
    return line.find_first_not_of(" \t\r") == std::string::npos;
}

bool is_link_elsewhere(const std::string& target) {
    return target.find("://") != std::string::npos || starts_with(target, 0, "mailto:");
}

}  // namespace

std::string document_title(const std::string& markdown) {
    std::istringstream in{markdown};
    for (std::string line; std::getline(in, line);)
        if (starts_with(line, 0, "# ")) return line.substr(2);
    return {};
}

std::string first_paragraph(const std::string& markdown, const std::string& section) {
    std::istringstream in{markdown};
    std::string paragraph;
    bool within = false;
    for (std::string line; std::getline(in, line);) {
        if (starts_with(line, 0, "#")) {
            if (within) break;
            within = line == "## " + section;
        } else if (within && is_blank(line)) {
            if (!paragraph.empty()) break;
        } else if (within && !(paragraph.empty() && starts_with(line, 0, "!["))) {
            paragraph += (paragraph.empty() ? "" : " ") + line;
        }
    }
    return paragraph;
}

std::string escape_html(const std::string& text) {
    std::string html;
    for (const char c : text) {
        if (c == '&')
            html += "&amp;";
        else if (c == '<')
            html += "&lt;";
        else if (c == '>')
            html += "&gt;";
        else if (c == '"')
            html += "&quot;";
        else
            html += c;
    }
    return html;
}

std::string to_html(const std::string& text, const std::string& base) {
    struct Span {
        const char *mark, *tag;
        bool is_verbatim;
    };
    constexpr Span spans[] = {
        {"`", "code", true}, {"$", "i", true}, {"**", "strong", false}, {"*", "em", false}};

    std::string html;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == '[') {
            const auto middle = text.find("](", at), end = text.find(')', middle);
            if (middle != std::string::npos && end != std::string::npos) {
                const std::string target = text.substr(middle + 2, end - middle - 2);
                html += "<a href=\"" +
                        escape_html(is_link_elsewhere(target) ? target : base + target) + "\">" +
                        to_html(text.substr(at + 1, middle - at - 1), base) + "</a>";
                at = end + 1;
                continue;
            }
        }
        bool found = false;
        for (const auto& [mark, tag, is_verbatim] : spans) {
            const std::size_t length = std::string(mark).size();
            if (!starts_with(text, at, mark)) continue;
            const auto end = text.find(mark, at + length);
            if (end == std::string::npos || end == at + length) continue;
            const std::string inner = text.substr(at + length, end - at - length);
            html += std::string("<") + tag + '>' +
                    (is_verbatim ? escape_html(inner) : to_html(inner, base)) + "</" + tag + '>';
            at = end + length;
            found = true;
            break;
        }
        if (!found) html += escape_html(text.substr(at++, 1));
    }
    return html;
}

}  // namespace companion
