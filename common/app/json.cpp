#include <algorithm>
#include <app/errors.hpp>
#include <app/json.hpp>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

namespace app {
namespace {

namespace fs = std::filesystem;

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

// A slip that people make often, by what stands where the parser stopped; "" if it is another one.
// `end` is behind the last character that was read, `said` what the parser says.
std::string slip(std::string_view text, std::size_t end, std::string_view said) {
    const auto says = [&](std::string_view part) { return said.find(part) != said.npos; };
    if (end == 0 || end > text.size()) return "";
    const std::string_view rest = text.substr(end - 1);
    if (says("invalid literal")) {
        const char c = rest[0];
        if (c == '/' || c == '#')
            return "JSON has no comments; \"about\": \"...\" takes their place";
        for (const char* const quote : {"'", "\xe2\x80", "`"})
            if (rest.rfind(quote, 0) == 0) return "texts stand in straight double quotes, \"...\"";
        if (says("object key")) return "keys stand in double quotes, \"...\"";
        if (c == ';') return "commas stand between values";
        if (c == '.' || c == '+') return "a number begins with a digit or with -";
        return "";
    }
    // Where the last word begins, and what stands before it.
    std::size_t start = end - 1;
    if (is_digit(text[start]))
        while (start > 0 &&
               (is_digit(text[start - 1]) || text[start - 1] == '.' || text[start - 1] == 'e' ||
                text[start - 1] == 'E' || text[start - 1] == '+' || text[start - 1] == '-'))
            --start;
    const std::string_view before = text.substr(0, start);
    const auto last = before.find_last_not_of(" \t\r\n");
    const bool after_comma = last != before.npos && before[last] == ',';
    if (says("unexpected number literal") && says("object key") && after_comma && last > 0 &&
        last + 1 == start && is_digit(before[last - 1]))
        return "a number has a decimal point, not a comma";
    if ((rest[0] == '}' || rest[0] == ']') && after_comma)
        return std::string{"a comma too many before "} + rest[0];
    if (says("unexpected number literal") && text[start] == '0' && end - start > 1)
        return "a number does not begin with 0";
    const bool unexpected_value =
        says("unexpected string literal") || says("unexpected number literal") ||
        says("unexpected '{'") || says("unexpected '['") || says("unexpected true literal") ||
        says("unexpected false literal") || says("unexpected null literal");
    if (unexpected_value && (says("parsing object -") || says("parsing array -")))
        return "a comma is missing before it";
    return "";
}

// What the parser has to say, without its own numbers and a place that is given in front.
std::string reason(std::string_view what, std::string_view text, std::size_t end) {
    const auto skip_past = [&](std::string_view mark) {
        const auto at = what.find(mark);
        if (at != std::string_view::npos) what.remove_prefix(at + mark.size());
    };
    skip_past("] ");
    if (what.rfind("parse error", 0) == 0) skip_past(": ");
    const std::string meant = slip(text, end, what);
    // What it read before belongs to other values.
    if (what.find("invalid literal") != what.npos) what = what.substr(0, what.find("; last read"));
    constexpr std::size_t most = 160;
    std::string said{what.substr(0, most)};
    if (what.size() > most) said += " ...";
    if (!meant.empty()) return said + "; " + meant;
    if (said.find("expected") == std::string::npos && said.find("literal") != std::string::npos)
        said += "; numbers, texts in quotes, [ ... ], { ... }, true, false and null are allowed";
    if (said.find("overflow") != std::string::npos) said += "; 1e308 is about the largest";
    return said;
}

// Puts the values together as the parser meets them.
class Builder : public nlohmann::json_sax<nlohmann::json> {
  public:
    Builder(const std::string& text, const std::string& name) : text_{text}, name_{name} {}

    Json result;

    bool null() override { return add({}); }
    bool boolean(bool value) override { return add({Json::Kind::boolean, value ? 1.0 : 0.0}); }
    bool number_integer(std::int64_t value) override {
        return add({Json::Kind::number, static_cast<double>(value)});
    }
    bool number_unsigned(std::uint64_t value) override {
        return add({Json::Kind::number, static_cast<double>(value)});
    }
    bool number_float(double value, const std::string&) override {
        return add({Json::Kind::number, value});
    }
    bool string(std::string& value) override {
        return add({Json::Kind::text, 0, std::move(value)});
    }
    bool binary(nlohmann::json::binary_t&) override { return false; }  // never in a text

    bool start_object(std::size_t) override { return open(Json::Kind::object); }
    bool start_array(std::size_t) override { return open(Json::Kind::list); }
    bool end_array() override { return close(); }
    bool end_object() override {
        const std::vector<std::string>& keys = open_.back().keys;
        std::vector<std::string_view> sorted(keys.begin(), keys.end());
        std::sort(sorted.begin(), sorted.end());
        const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
        if (twice != sorted.end())
            throw UsageError(name_ + ": " + path_of_member(path(), std::string{*twice}) +
                             " is there twice; every key may stand in its object once");
        return close();
    }
    bool key(std::string& value) override {
        open_.back().keys.push_back(std::move(value));
        return true;
    }
    bool parse_error(std::size_t position, const std::string&,
                     const nlohmann::json::exception& error) override {
        throw UsageError(name_ + ':' + line_and_column(text_, position) + ": " +
                         reason(error.what(), text_, position));
    }

  private:
    // Of the innermost open object.
    std::string path() const {
        std::string path;
        for (std::size_t i = 0; i + 1 < open_.size(); ++i)
            path = open_[i].kind == Json::Kind::object ? path_of_member(path, open_[i].keys.back())
                                                       : path_of_item(path, open_[i].items.size());
        return path;
    }
    bool add(Json value) {
        (open_.empty() ? result : open_.back().items.emplace_back()) = std::move(value);
        return true;
    }
    bool open(Json::Kind kind) {
        open_.push_back({kind});
        if (open_.size() > max_json_depth)
            throw UsageError(name_ + ": " + path() + " lies too deep; objects and lists may lie " +
                             std::to_string(max_json_depth) + " deep in each other");
        return true;
    }
    bool close() {
        Json done = std::move(open_.back());
        open_.pop_back();
        return add(std::move(done));
    }

    const std::string& text_;
    const std::string& name_;
    std::vector<Json> open_;  // objects and lists, from the outermost one
};

// How many letters to put in, take out or change, or neighbors to swap, to make one of the other.
std::size_t slips(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> table(a.size() + 1,
                                                std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                table[i][j] = i + j;
                continue;
            }
            table[i][j] = std::min({table[i - 1][j] + 1, table[i][j - 1] + 1,
                                    table[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                table[i][j] = std::min(table[i][j], table[i - 2][j - 2] + 1);
        }
    return table[a.size()][b.size()];
}

}  // namespace

std::string read_input_file(const fs::path& path, const std::string& name, std::size_t most) {
    const auto refuse = [&](const std::string& why) { throw UsageError(name + ' ' + why); };
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        if (error && error != std::errc::no_such_file_or_directory)
            refuse("cannot be read (" + error.message() + "); name a file that can");
        refuse("is not there; name a file that is");
    }
    if (fs::is_directory(status)) refuse("is a folder; name a file in it");
    if (!fs::is_regular_file(status)) refuse("is a device or a pipe; name a regular file");

    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    const std::unique_ptr<std::FILE, Close> file{std::fopen(path.c_str(), "rb")};
    if (!file)
        refuse(std::string{"cannot be read ("} + std::strerror(errno) + "); name a file that can");
    std::string bytes;
    char buffer[1 << 14];
    for (std::size_t got; (got = std::fread(buffer, 1, sizeof buffer, file.get())) > 0;) {
        bytes.append(buffer, got);
        if (bytes.size() > most)
            refuse("is too large; " + std::to_string(most >> 20) + " MiB are allowed");
    }
    if (std::ferror(file.get())) refuse("cannot be read; name a file that can");
    return bytes;
}

Json parse_json(const std::string& text, const std::string& name) {
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        throw UsageError(name + " is empty; a JSON object { ... } is wanted");
    // The parser would take it for the end.
    if (const auto zero = text.find('\0'); zero != std::string::npos)
        throw UsageError(name + ':' + line_and_column(text, zero + 1) +
                         ": a byte of zero; a JSON text has none");
    Builder builder{text, name};
    nlohmann::json::sax_parse(text, &builder);
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

std::string quoted(const std::string& text) {
    constexpr std::size_t most = 40;
    if (text.size() <= most) return '"' + text + '"';
    std::size_t end = most;  // of a whole character: further bytes of one are 10xxxxxx
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
    return '"' + text.substr(0, end) + "...\"";
}

std::string nearest_word(const std::string& wrong, const std::vector<std::string>& words) {
    // A third of the letters may be wrong, and one of two.
    return nearest_word(wrong, words, std::max<std::size_t>(wrong.size() / 3, 1));
}

std::string nearest_word(const std::string& wrong, const std::vector<std::string>& words,
                         std::size_t most) {
    std::string nearest;
    std::size_t best = most;
    if (wrong.size() > 40) return {};  // what is longer than a word is no slip
    for (const std::string& word : words) {
        // Who leaves out the end means the word.
        if (wrong.size() >= 3 && word.rfind(wrong, 0) == 0) return word;
        const std::size_t count = slips(wrong, word);
        if (count < best || (count == best && nearest.empty())) {
            best = count;
            nearest = word;
        }
    }
    return nearest;
}

}  // namespace app
