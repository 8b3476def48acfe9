#include <algorithm>
#include <app/platform.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/terminal.hpp>
#include <cstdlib>
#include <sstream>

namespace companion {
namespace {

bool has_colors() {
    static const bool has = [] {
        const char* const no = std::getenv("NO_COLOR");
        return app::is_terminal(stdout) && !(no && *no) && has_escapes(std::getenv("TERM"));
    }();
    return has;
}

std::string colored(const char* code, const std::string& text) {
    return has_colors() ? std::string{"\033["} + code + 'm' + text + "\033[0m" : text;
}

// Counts the bytes of UTF-8 that begin a character.
std::size_t characters(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    }));
}

}  // namespace

WaitingLine::WaitingLine(const std::string& what) : is_shown_{app::is_terminal(stdout)} {
    if (is_shown_) print(dim("  " + what + " ..."));
}

WaitingLine::~WaitingLine() {
    if (is_shown_) print("\r\033[K");
}

namespace {
std::function<void(const std::string&)> listener;
}

Overhears::Overhears(std::function<void(const std::string&)> listen) {
    listener = std::move(listen);
}

Overhears::~Overhears() {
    listener = nullptr;
}

void print(const std::string& text) {
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
    if (listener) listener(text);
}

std::string green(const std::string& text) {
    return colored("32", text);
}
std::string red(const std::string& text) {
    return colored("31", text);
}
std::string yellow(const std::string& text) {
    return colored("33", text);
}
std::string bold(const std::string& text) {
    return colored("1", text);
}
std::string dim(const std::string& text) {
    return colored("2", text);
}

// Whether a character here, in three bytes, makes a terminal write what follows from right to left:
// U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069.
static bool turns_text(const std::string& text, std::size_t at) {
    const std::string two = text.substr(at, 2);
    if (at + 2 >= text.size()) return false;
    const auto last = static_cast<unsigned char>(text[at + 2]);
    if (two == "\xe2\x80") return last == 0x8e || last == 0x8f || (last >= 0xaa && last <= 0xae);
    return two == "\xe2\x81" && last >= 0xa6 && last <= 0xa9;
}

std::string printable(const std::string& text, std::size_t most) {
    std::string kept;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = [&](std::size_t at) {
            return at < text.size() ? static_cast<unsigned char>(text[at]) : 0u;
        };
        if (kept.size() >= most) return kept + "...";
        if (byte(i) == 0x1b && byte(i + 1) == '[') {  // up to its last byte
            for (i += 2; i < text.size() && (byte(i) < 0x40 || byte(i) > 0x7e);) ++i;
        } else if (byte(i) == 0x1b && byte(i + 1) == ']') {  // up to the bell or another escape
            for (i += 2; i < text.size() && byte(i) != '\a' && byte(i) != 0x1b;) ++i;
            if (byte(i) == 0x1b && byte(i + 1) != '\\') --i;
        } else if (byte(i) == 0x1b) {
            ++i;
        } else if (byte(i) == 0xc2 && byte(i + 1) >= 0x80 && byte(i + 1) < 0xa0) {
            ++i;  // skip Unicode's second set of control characters
        } else if (turns_text(text, i)) {
            char name[8];
            std::snprintf(name, sizeof name, "\\u%04x",
                          (byte(i) & 15u) << 12 | (byte(i + 1) & 63u) << 6 | (byte(i + 2) & 63u));
            kept += name;
            i += 2;
        } else if (text[i] == '\n' || text[i] == '\t' || (byte(i) >= 0x20 && byte(i) != 0x7f)) {
            kept += text[i];
        }
    }
    return kept;
}

void Shown::add(const char* bytes, std::size_t count) {
    constexpr std::size_t most = 1 << 20, most_in_line = 1 << 12;
    if (count_ > most) return;
    count_ += count;
    line_.append(bytes, count);
    const auto end = line_.size() > most_in_line ? line_.size() : line_.rfind('\n') + 1;
    print(printable(line_.substr(0, end), most));
    line_.erase(0, end);
    if (count_ > most) print("\n... and more, which is not shown.\n");
}

void Shown::end() const {
    print(printable(line_));
}

std::string bar(int part, int whole, int width) {
    const int filled = whole > 0 ? part * width / whole : 0;
    return '[' + std::string(static_cast<std::size_t>(filled), '#') +
           std::string(static_cast<std::size_t>(width - filled), '.') + ']';
}

std::string wrapped(const std::string& text, const std::string& indent, std::size_t width) {
    std::string all;
    std::istringstream lines{text};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words{line};
        std::string current;
        for (std::string word; words >> word;) {
            if (!current.empty() && characters(indent + current) + 1 + characters(word) > width) {
                all += indent + current + '\n';
                current.clear();
            }
            current += (current.empty() ? "" : " ") + word;
        }
        all += indent + current + '\n';
    }
    return all;
}

}  // namespace companion
