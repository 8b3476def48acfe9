#include <algorithm>
#include <app/errors.hpp>
#include <app/json.hpp>
#include <app/nearest_word.hpp>
#include <app/value.hpp>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace app {
namespace {

using nlohmann::json;

std::string list_of(const std::vector<std::string>& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i)
        list += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    return list;
}

std::string what_it_is(const json& value) {
    if (value.is_string()) return quoted(value.get_ref<const std::string&>());
    if (value.is_number()) return number_text(value.get<double>());
    if (value.is_array()) return "a list of " + std::to_string(value.size());
    return value.is_object() ? "an object" : value.dump();
}

}  // namespace

struct Value::File {
    std::string name, whole;
    json content;
};

Value::Value(std::shared_ptr<const File> file, const json& value, std::string path)
    : file_{std::move(file)}, json_{&value}, path_{std::move(path)} {}

Value Value::parse(const std::string& text, const std::string& file, const std::string& whole) {
    const auto shared = std::make_shared<const File>(File{file, whole, parse_json(text, file)});
    return {shared, shared->content, ""};
}

void Value::fail(const std::string& why) const {
    throw UsageError(file_->name + ": " + (path_.empty() ? file_->whole : path_) + ' ' + why);
}

void Value::refuse(const std::string& wanted) const {
    fail("must be " + wanted + ", not " + what_it_is(*json_));
}

bool Value::is_list() const {
    return json_->is_array();
}

bool Value::is_object() const {
    return json_->is_object();
}

bool Value::is_text() const {
    return json_->is_string();
}

double Value::number() const {
    if (!json_->is_number()) refuse("a number");
    return json_->get<double>();
}

double Value::number(Range range) const {
    const double value = json_->is_number() ? json_->get<double>() : NAN;
    if (!(range.low <= value && value <= range.high))
        refuse("a number from " + number_text(range.low) + " to " + number_text(range.high));
    return value;
}

std::uint64_t Value::whole(std::uint64_t low, std::uint64_t high) const {
    const double value = json_->is_number() ? json_->get<double>() : NAN;
    if (!(static_cast<double>(low) <= value && value <= static_cast<double>(high)) ||
        value != std::floor(value))
        refuse("a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return static_cast<std::uint64_t>(value);
}

bool Value::yes() const {
    if (!json_->is_boolean()) refuse("true or false");
    return json_->get<bool>();
}

const std::string& Value::text(const std::string& what) const {
    if (!is_text()) refuse(what + " in quotes");
    return json_->get_ref<const std::string&>();
}

const std::string& Value::word(const std::vector<std::string>& words) const {
    const std::string& chosen = text("one of " + list_of(words));
    if (std::find(words.begin(), words.end(), chosen) == words.end())
        fail("is " + quoted(chosen) + ", which is not known" + meant(chosen, words, "known are "));
    return chosen;
}

Value::List Value::list(const std::string& of_what, std::size_t least) const {
    if (!json_->is_array() || json_->size() < least)
        refuse("a list [ ... ] of " + (least ? std::to_string(least) + " or more " : "") + of_what);
    return List{*this};
}

std::size_t Value::List::size() const {
    return whole_.json_->size();
}

Value Value::List::operator[](std::size_t index) const {
    return {whole_.file_, (*whole_.json_)[index], path_of_item(whole_.path_, index)};
}

std::vector<std::string> Value::keys(const std::string& of_what) const {
    if (!is_object()) refuse("an object { ... } of " + of_what);
    std::vector<std::string> all;
    for (const auto& [key, value] : json_->items()) all.push_back(key);
    return all;
}

const Value& Value::with_keys(const std::vector<std::string>& known) const {
    if (!is_object()) refuse("an object { ... } with " + list_of(known));
    for (const auto& [key, value] : json_->items())
        if (std::find(known.begin(), known.end(), key) == known.end())
            throw UsageError(file_->name + ": " + path_of_member(path_, key) + " is not known" +
                             meant(key, known, "known are "));
    return *this;
}

std::optional<Value> Value::find(const std::string& key) const {
    const auto found = json_->find(key);
    if (found == json_->end()) return {};
    return Value{file_, *found, path_of_member(path_, key)};
}

Value Value::at(const std::string& key) const {
    if (const auto value = find(key)) return *value;
    if (!is_object()) refuse("an object { ... } with " + quoted(key));
    fail("needs " + quoted(key));
}

std::string number_text(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", number);
    return text;
}

std::string meant(const std::string& wrong, const std::vector<std::string>& words,
                  const std::string& otherwise) {
    if (const std::string nearest = nearest_word(wrong, words); !nearest.empty())
        return "; did you mean " + quoted(nearest) + '?';
    constexpr std::size_t most = 12;  // a longer list is no help
    if (words.empty() || words.size() > most) return "";
    std::vector<std::string> in_quotes;
    for (const std::string& word : words) in_quotes.push_back(quoted(word));
    return "; " + otherwise + list_of(in_quotes);
}

}  // namespace app
