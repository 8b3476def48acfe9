#include <algorithm>
#include <cctype>
#include <companion/pages/plain_text.hpp>
#include <iterator>
#include <sstream>

namespace companion {
namespace {

struct Symbol {
    const char *name, *plain;
};

// A name that is not here, such as \sin, is shown without its backslash.
constexpr Symbol symbols[]{
    {"mathbf", ""},  {"mathrm", ""},   {"text", ""},     {"left", ""},      {"right", ""},
    {"big", ""},     {"Big", ""},      {"lvert", "|"},   {"rvert", "|"},    {"cdot", "·"},
    {"times", "×"},  {"le", "≤"},      {"ge", "≥"},      {"ne", "≠"},       {"pi", "π"},
    {"eta", "η"},    {"theta", "θ"},   {"varphi", "φ"},  {"alpha", "α"},    {"varepsilon", "ε"},
    {"infty", "∞"},  {"sqrt", "√"},    {"lfloor", "⌊"},  {"rfloor", "⌋"},   {"lceil", "⌈"},
    {"rceil", "⌉"},  {"oplus", "^"},   {"pm", "±"},      {"sum", "Σ"},      {"to", "→"},
    {"dots", "..."}, {"ldots", "..."}, {"cdots", "..."}, {"quad", "  "},    {"approx", "≈"},
    {"in", "∈"},     {"circ", "°"},    {"Delta", "Δ"},   {"qquad", "    "}, {"thinspace", " "}};

class Formula {
  public:
    explicit Formula(const std::string& tex) : tex_{tex} {}

    std::string plain() { return until('\0'); }

  private:
    bool at_end() const { return at_ >= tex_.size(); }

    std::string until(char end) {
        std::string text;
        while (!at_end() && tex_[at_] != end) text += next();
        if (!at_end()) ++at_;
        return text;
    }

    // A character, a group in braces or a command with all that belongs to it.
    std::string next() {
        const char c = tex_[at_++];
        if (c == '{') return until('}');
        if (c != '\\') return std::string(1, c);
        std::string name;
        while (!at_end() && std::isalpha(static_cast<unsigned char>(tex_[at_])))
            name += tex_[at_++];
        // "\," and the like are small spaces, "\\{" a brace.
        if (name.empty() && !at_end()) {
            const char mark = tex_[at_++];
            return std::isspace(static_cast<unsigned char>(mark)) || mark == ',' || mark == ';'
                       ? " "
                   : mark == '!' ? ""
                                 : std::string(1, mark);
        }
        if (name == "frac" || name == "tfrac" || name == "dfrac") {
            const std::string above = argument(), below = argument();
            return in_brackets(above) + '/' + in_brackets(below);
        }
        if (name == "sqrt") return "√" + in_brackets(argument());
        const auto known = std::find_if(std::begin(symbols), std::end(symbols),
                                        [&](const Symbol& symbol) { return name == symbol.name; });
        const std::string plain = known == std::end(symbols) ? name : known->plain;
        // The space that ends a command's name is not shown where the command is not.
        if (plain.empty() && !at_end() && tex_[at_] == ' ') ++at_;
        return plain;
    }

    std::string argument() {
        while (!at_end() && tex_[at_] == ' ') ++at_;
        return at_end() ? "" : next();
    }

    // Unless it is one character or one word.
    static std::string in_brackets(const std::string& text) {
        const bool is_simple = std::all_of(text.begin(), text.end(), [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) || (c & 0x80);
        });
        return is_simple ? text : '(' + text + ')';
    }

    const std::string& tex_;
    std::size_t at_ = 0;
};

std::string plain_line(const std::string& line) {
    std::string plain;
    for (std::size_t i = 0; i < line.size();) {
        const char c = line[i];
        const auto close = line.find(c, i + 1);
        if (c == '$' && close != std::string::npos) {
            const std::string tex = line.substr(i + 1, close - i - 1);
            plain += Formula{tex}.plain();
            i = close + 1;
        } else {
            if (c != '`') plain += c;
            ++i;
        }
    }
    return plain;
}

}  // namespace

std::string plain_text(const std::string& markdown) {
    // A formula may go on in the next line: paragraphs are taken as a whole, code by lines.
    std::string plain, paragraph;
    const auto end_paragraph = [&] {
        plain += plain_line(paragraph);
        paragraph.clear();
    };
    std::istringstream in{markdown};
    for (std::string line; std::getline(in, line);) {
        if (line.rfind("    ", 0) == 0 || line.empty()) {
            end_paragraph();
            plain += line + '\n';
        } else {
            paragraph += line + '\n';
        }
    }
    end_paragraph();
    return plain;
}

}  // namespace companion
