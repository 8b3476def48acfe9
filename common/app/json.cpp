#include <algorithm>
#include <app/errors.hpp>
#include <app/json.hpp>
#include <cctype>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>

namespace app {
namespace {

using nlohmann::json;

std::string line_and_column(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const auto last_break = before.rfind('\n');
    const std::size_t column =
        before.size() - (last_break == std::string_view::npos ? 0 : last_break + 1);
    return std::to_string(line) + ':' + std::to_string(std::max<std::size_t>(column, 1));
}

bool is_digit(char c) {
    return '0' <= c && c <= '9';
}

// What was wrong where the parser stopped.
struct Slip {
    std::string_view before;    // what stands before the token, without the blanks between
    std::string_view token;     // as far as it was read; empty where the text ended before it
    bool touches = false;       // no blank stands between them
    bool ended = false;         // the text ended, within the token or instead of it
    std::string_view expected;  // one of those below
};

constexpr std::string_view a_value = "a value", first_item = "a value or ]",
                           a_key = "a key in double quotes",
                           first_key = "a key in double quotes or }", a_colon = "a colon",
                           next_item = "a comma or ]", next_member = "a comma or }",
                           the_end = "end of input";

// Where the last token of a text begins.
std::size_t last_token(std::string_view text) {
    std::size_t start = 0;
    const auto is_of_word = [&](std::size_t i) {
        return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) ||
                                   text[i] == '-' || text[i] == '+' || text[i] == '.');
    };
    for (std::size_t at = 0; at < text.size();) {
        if (std::strchr(" \t\r\n", text[at])) {
            ++at;
            continue;
        }
        start = at++;
        if (text[start] == '"') {
            while (at < text.size() && text[at++] != '"') at += text[at - 1] == '\\';
        } else if (is_of_word(start)) {
            while (is_of_word(at)) ++at;
            const std::string_view word = text.substr(start, at - start);
            // A token that is cut short includes the character that is wrong.
            at += !is_digit(word.back()) && word != "true" && word != "false" && word != "null";
        }
    }
    return start;
}

// What is wrong inside a text in quotes: JSON has few ways to write special characters.
std::string broken_text(const Slip& slip) {
    const auto last = static_cast<unsigned char>(slip.token.back());
    if (slip.ended) return "a closing quote is missing";
    if (last < ' ') return "a closing quote is missing, or \\n for a line break, \\t for a tab";
    if (last >= 0x80) return "this is not valid UTF-8";
    return "after \\ there must be one of \" \\ / b f n r t, or u and four hexadecimal digits";
}

// What the slip is usually called, judging by the token and by what was expected in its place; ""
// if the slip is not a common one.
std::string named(const Slip& slip) {
    const char first = slip.token.empty() ? '\0' : slip.token[0];
    const char last = slip.before.empty() ? '\0' : slip.before.back();
    const bool wants_value = slip.expected == a_value || slip.expected == first_item;
    const bool wants_key = slip.expected == a_key || slip.expected == first_key;
    if (first == '"' && (wants_value || wants_key)) return broken_text(slip);
    if (slip.token.empty()) return "";
    if (first == '/' || first == '#') return "JSON has no comments; use \"about\": \"...\" instead";
    for (const char* const quote : {"'", "\xe2", "`"})
        if (slip.token.rfind(quote, 0) == 0) return "texts need straight double quotes, \"...\"";
    if (last == ',' && (first == '}' || first == ']'))
        return std::string{"one comma too many before "} + first;
    if (wants_key && is_digit(first) && last == ',' && slip.touches && slip.before.size() > 1 &&
        is_digit(slip.before[slip.before.size() - 2]))
        return "a number has a decimal point, not a comma";
    if (wants_key && std::isalpha(static_cast<unsigned char>(first)))
        return "keys need double quotes, \"...\"";
    if (first == ';') return "values are separated by commas";
    if (wants_value && (first == '.' || first == '+'))
        return "a number begins with a digit or with -";
    if (wants_value && (first == '-' || is_digit(first))) return "expected a digit";
    if (wants_value)
        return "numbers, texts in quotes, [ ... ], { ... }, true, false and null are allowed";
    if (first == '0' && slip.token.size() > 1) return "a number does not begin with 0";
    if ((slip.expected == next_item || slip.expected == next_member) &&
        (std::isalnum(static_cast<unsigned char>(first)) || (first && std::strchr("\"{[-", first))))
        return "a comma is missing before it";
    return "";
}

std::string words(const Slip& slip) {
    constexpr std::size_t most = 40;
    std::string shown{slip.token.substr(0, most)};
    for (char& c : shown)  // the text may be cut within a character
        if (c < ' ' || c > '~') c = '?';
    if (slip.token.size() > most) shown += " ...";
    const std::string found = slip.ended ? "the text ends here" : "unexpected " + shown;
    const std::string name = named(slip);
    return found + "; " + (name.empty() ? "expected " + std::string{slip.expected} : name);
}

// Builds the value from what the parser finds, and keeps track of the position in the text.
class Builder : public nlohmann::json_sax<json> {
  public:
    Builder(const std::string& text, const std::string& file) : text_{text}, file_{file} {}

    json result;

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(std::int64_t value) override { return add(value); }
    bool number_unsigned(std::uint64_t value) override { return add(value); }
    bool number_float(double value, const std::string&) override { return add(value); }
    bool string(std::string& value) override { return add(std::move(value)); }
    bool binary(json::binary_t&) override { return false; }  // never in a text

    bool start_object(std::size_t) override { return open(json::object()); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_array() override { return close(); }
    bool end_object() override { return close(); }
    bool key(std::string& key) override {
        Open& inner = open_.back();
        if (inner.value.contains(key))
            throw UsageError(file_ + ": " + path_of_member(path(), key) +
                             " appears twice; each key may appear only once in its object");
        count();
        inner.key = std::move(key);
        inner.wants_value = true;
        return true;
    }
    bool parse_error(std::size_t position, const std::string& token,
                     const json::exception& error) override {
        const std::string place = file_ + ':' + line_and_column(text_, position) + ": ";
        constexpr int out_of_range = 406;  // the library's code for a number that is too large
        if (error.id == out_of_range)
            throw UsageError(place + "the number " + token.substr(0, 40) +
                             " is too large; 1e308 is about the largest");
        throw UsageError(place + words(slip_at(position)));
    }

  private:
    // An object or a list that is not closed yet.
    struct Open {
        json value;
        std::string key{};  // of the member that is being read
        bool wants_value = false;
    };

    // The path of the innermost open object.
    std::string path() const {
        std::string path;
        for (std::size_t i = 0; i + 1 < open_.size(); ++i)
            path = open_[i].value.is_object() ? path_of_member(path, open_[i].key)
                                              : path_of_item(path, open_[i].value.size());
        return path;
    }
    // What was wrong, if the parser stopped after `position` bytes.
    Slip slip_at(std::size_t position) const {
        const bool ended = position > text_.size();
        const std::string_view text = std::string_view{text_}.substr(0, position);
        std::size_t start = last_token(text);
        const bool is_open_text =
            text[start] == '"' && (text.size() == start + 1 || text.back() != '"');
        if (ended && !is_open_text) start = text.size();
        const auto last = text.substr(0, start).find_last_not_of(" \t\r\n");
        const std::size_t used = last == text.npos ? 0 : last + 1;
        return {text.substr(0, used), text.substr(start), used == start, ended,
                expected(used ? text[used - 1] : '\0')};
    }
    std::string_view expected(char last) const {
        if (open_.empty()) return is_read_ ? the_end : a_value;
        const Open& inner = open_.back();
        const bool first = inner.value.empty();
        if (inner.value.is_array()) return last == ',' ? a_value : first ? first_item : next_item;
        if (inner.wants_value) return last == '"' ? a_colon : a_value;
        return last == ',' ? a_key : first ? first_key : next_member;
    }
    // Counts one more key or value.
    void count() {
        if (++count_ > max_json_values)
            throw UsageError(file_ + " has too many keys and values; " +
                             std::to_string(max_json_values) + " are allowed");
    }
    bool add(json value) {
        count();
        is_read_ = open_.empty();
        if (open_.empty()) {
            result = std::move(value);
            return true;
        }
        Open& inner = open_.back();
        if (inner.value.is_array())
            inner.value.push_back(std::move(value));
        else
            inner.value[inner.key] = std::move(value);
        inner.wants_value = false;
        return true;
    }
    bool open(json value) {
        open_.push_back({std::move(value)});
        if (open_.size() > max_json_depth)
            throw UsageError(file_ + ": " + path() +
                             " is nested too deeply; objects and lists may be nested " +
                             std::to_string(max_json_depth) + " deep");
        return true;
    }
    bool close() {
        json done = std::move(open_.back().value);
        open_.pop_back();
        return add(std::move(done));
    }

    const std::string& text_;
    const std::string& file_;
    std::vector<Open> open_;  // the outermost one first
    bool is_read_ = false;    // whether the whole text has been read
    std::size_t count_ = 0;   // of keys and values so far
};

}  // namespace

json parse_json(const std::string& text, const std::string& file) {
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        throw UsageError(file + " is empty; expected a JSON object { ... }");
    // The parser would take a zero byte for the end of the text.
    if (const auto zero = text.find('\0'); zero != std::string::npos)
        throw UsageError(file + ':' + line_and_column(text, zero + 1) +
                         ": a zero byte; a JSON text has none");
    Builder builder{text, file};
    json::sax_parse(text, &builder);
    return std::move(builder.result);
}

std::string path_of_member(const std::string& parent, const std::string& key) {
    const bool plain =
        !key.empty() && key.size() <= 40 && std::all_of(key.begin(), key.end(), [](char c) {
            return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
                   c == '_' || c == '-';
        });
    if (!plain) return parent + '[' + quoted(key) + ']';
    return parent.empty() ? key : parent + '.' + key;
}

std::string path_of_item(const std::string& parent, std::size_t index) {
    return parent + '[' + std::to_string(index) + ']';
}

std::string to_json(const std::map<std::string, std::string>& texts) {
    return json(texts).dump();
}

std::map<std::string, std::string> texts_in(const std::string& text, const std::string& file) {
    return parse_json(text, file).get<std::map<std::string, std::string>>();
}

std::string quoted(const std::string& text) {
    constexpr std::size_t most = 40;
    if (text.size() <= most) return '"' + text + '"';
    std::size_t end = most;  // moved back to a character's first byte: the others are 10xxxxxx
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
    return '"' + text.substr(0, end) + "...\"";
}

}  // namespace app
