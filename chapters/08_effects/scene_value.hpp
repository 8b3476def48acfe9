#pragma once
// A value of a scene file together with its position in the file, so that an error message can say
// where it is. Every function throws app::UsageError: file, key path, what is allowed.

#include <algorithm>
#include <app/errors.hpp>
#include <app/json.hpp>
#include <app/nearest_word.hpp>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <rt/color.hpp>
#include <rt/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

namespace effects {

using rt::Color;
using rt::Real;
using rt::Vec3;

struct Range {
    double low, high;
};

// Far enough for galaxies and atoms, and near enough that in float no square overflows.
inline constexpr Range coordinates{-1e9, 1e9}, lengths{1e-9, 1e9}, shares{0, 1}, light{0, 1e6};

inline std::string number_text(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", number);
    return text;
}

inline std::string list_of(const std::vector<std::string>& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i)
        list += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    return list;
}

class Value {
  public:
    Value(const app::Json& json, std::string path, const std::string& file)
        : json_{&json}, path_{std::move(path)}, file_{&file} {}

    [[noreturn]] void fail(const std::string& why) const {
        throw app::UsageError(*file_ + ": " + (path_.empty() ? "the scene" : path_) + ' ' + why);
    }

    bool is_object() const { return json_->kind == app::Json::Kind::object; }
    bool is_list() const { return json_->kind == app::Json::Kind::list; }
    bool is_text() const { return json_->kind == app::Json::Kind::text; }

    Real number(Range range) const {
        const std::string wanted =
            "must be a number from " + number_text(range.low) + " to " + number_text(range.high);
        if (json_->kind != app::Json::Kind::number) fail(wanted + ", not " + what_it_is());
        // Written so that NaN is refused, too.
        if (!(range.low <= json_->number && json_->number <= range.high))
            fail(wanted + ", not " + number_text(json_->number));
        return static_cast<Real>(json_->number);
    }

    // A whole number, small enough to be exact in a double.
    std::uint64_t whole(std::uint64_t low, std::uint64_t high) const {
        const std::string wanted =
            "must be a whole number from " + std::to_string(low) + " to " + std::to_string(high);
        if (json_->kind != app::Json::Kind::number) fail(wanted + ", not " + what_it_is());
        const double number = json_->number;
        if (!(static_cast<double>(low) <= number && number <= static_cast<double>(high)) ||
            number != std::floor(number))
            fail(wanted + ", not " + number_text(number));
        return static_cast<std::uint64_t>(number);
    }

    const std::string& text(const std::string& what) const {
        if (!is_text()) fail("must be " + what + " in quotes, not " + what_it_is());
        return json_->text;
    }

    // One of a few words.
    const std::string& word(const std::vector<std::string>& words) const {
        const std::string& chosen = text("one of " + list_of(words));
        if (std::find(words.begin(), words.end(), chosen) == words.end())
            fail("is " + app::quoted(chosen) + ", which is not known" +
                 meant(chosen, words, "known are "));
        return chosen;
    }

    std::vector<Value> list(const std::string& of_what) const {
        if (json_->kind != app::Json::Kind::list)
            fail("must be a list [ ... ] of " + of_what + ", not " + what_it_is());
        std::vector<Value> values;
        values.reserve(json_->items.size());
        for (std::size_t i = 0; i < json_->items.size(); ++i)
            values.emplace_back(json_->items[i], app::path_of_item(path_, i), *file_);
        return values;
    }

    // The members of an object whose keys are names that people chose.
    std::vector<std::pair<std::string, Value>> members(const std::string& of_what) const {
        if (!is_object()) fail("must be an object { ... } of " + of_what + ", not " + what_it_is());
        std::vector<std::pair<std::string, Value>> values;
        for (std::size_t i = 0; i < json_->items.size(); ++i)
            values.emplace_back(
                json_->keys[i],
                Value{json_->items[i], app::path_of_member(path_, json_->keys[i]), *file_});
        return values;
    }

    // An object that may have these keys and no others.
    const Value& with_keys(const std::vector<std::string>& known) const {
        if (!is_object())
            fail("must be an object { ... } with " + list_of(known) + ", not " + what_it_is());
        for (const std::string& key : json_->keys)
            if (std::find(known.begin(), known.end(), key) == known.end())
                throw app::UsageError(*file_ + ": " + app::path_of_member(path_, key) +
                                      " is not known" + meant(key, known, "known are "));
        return *this;
    }

    std::optional<Value> find(const std::string& key) const {
        for (std::size_t i = 0; i < json_->keys.size(); ++i)
            if (json_->keys[i] == key)
                return Value{json_->items[i], app::path_of_member(path_, key), *file_};
        return {};
    }
    Value at(const std::string& key) const {
        if (const auto value = find(key)) return *value;
        fail("needs " + app::quoted(key));
    }

    Real number(const std::string& key, Range range, Real otherwise) const {
        const auto value = find(key);
        return value ? value->number(range) : otherwise;
    }
    Vec3 vec3(const std::string& key, Vec3 otherwise) const {
        const auto value = find(key);
        return value ? value->vec3() : otherwise;
    }
    Color color(const std::string& key, Color otherwise, Range range) const {
        const auto value = find(key);
        return value ? value->color(range) : otherwise;
    }

    Vec3 vec3_within(const std::string& wanted, Range range) const {
        const auto [x, y, z] = three(wanted, range);
        return {x, y, z};
    }
    Vec3 vec3() const { return vec3_within("three numbers [x, y, z]", coordinates); }

    // "#rrggbb" as a designer writes it, or linear light [r, g, b].
    Color color(Range range) const {
        const char* const wanted = "a color, \"#rrggbb\" or [r, g, b]";
        if (!is_text()) {
            const auto [r, g, b] = three(wanted, range);
            return {r, g, b};
        }
        const std::string& hex = json_->text;
        std::uint32_t value = 0;
        bool good = hex.size() == 7 && hex[0] == '#';
        for (std::size_t i = 1; good && i < 7; ++i) {
            const auto digit = std::string_view{"0123456789abcdef"}.find(
                static_cast<char>('A' <= hex[i] && hex[i] <= 'F' ? hex[i] + ('a' - 'A') : hex[i]));
            good = digit != std::string_view::npos;
            value = value << 4 | static_cast<std::uint32_t>(digit & 15);
        }
        if (!good) fail(std::string{"must be "} + wanted + ", not " + app::quoted(hex));
        return rt::from_hex(value);
    }

    std::string what_it_is() const {
        using Kind = app::Json::Kind;
        switch (json_->kind) {
            case Kind::null:
                return "null";
            case Kind::boolean:
                return json_->number != 0 ? "true" : "false";
            case Kind::number:
                return number_text(json_->number);
            case Kind::text:
                return app::quoted(json_->text);
            case Kind::list:
                return "a list of " + std::to_string(json_->items.size());
            case Kind::object:
                return "an object";
        }
        return "";
    }

    // What to say after "is not known".
    static std::string meant(const std::string& wrong, const std::vector<std::string>& words,
                             const std::string& otherwise) {
        const std::string nearest = app::nearest_word(wrong, words);
        if (!nearest.empty()) return "; did you mean " + app::quoted(nearest) + '?';
        constexpr std::size_t most = 12;  // more are no help
        if (words.empty() || words.size() > most) return "";
        std::vector<std::string> in_quotes;
        for (const std::string& word : words) in_quotes.push_back(app::quoted(word));
        return "; " + otherwise + list_of(in_quotes);
    }

  private:
    std::array<Real, 3> three(const std::string& wanted, Range range) const {
        if (json_->kind != app::Json::Kind::list || json_->items.size() != 3)
            fail("must be " + wanted + ", not " + what_it_is());
        std::array<Real, 3> all{};
        for (std::size_t i = 0; i < 3; ++i)
            all[i] = Value{json_->items[i], app::path_of_item(path_, i), *file_}.number(range);
        return all;
    }

    const app::Json* json_;
    std::string path_;
    const std::string* file_;
};

}  // namespace effects
