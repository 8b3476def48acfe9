#pragma once
// The values of JSON files that people write, each with its position in its file.

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace app {

struct Range {
    double low, high;
};

// A value of a JSON file and its position in that file. If the value is not of the kind that a
// function asks for, the function throws UsageError, which names the file, the position, what is
// allowed, and what the value is.
class Value {
  public:
    // The value that a text holds. Messages call it by the name `whole`, such as "the scene".
    static Value parse(const std::string& text, const std::string& file,
                       const std::string& whole = "the top level");

    // "FILE: POSITION WHY"
    [[noreturn]] void fail(const std::string& why) const;
    // "FILE: POSITION must be WANTED, not ..."
    [[noreturn]] void refuse(const std::string& wanted) const;

    bool is_list() const;
    bool is_object() const;
    bool is_text() const;

    double number() const;
    double number(Range range) const;
    std::uint64_t whole(std::uint64_t low, std::uint64_t high) const;  // high: at most 2^53
    bool yes() const;
    const std::string& text(const std::string& what = "a text") const;
    const std::string& word(const std::vector<std::string>& words) const;  // one of these
    class List;
    List list(const std::string& of_what, std::size_t least = 0) const;

    // The keys of an object that are names that people chose.
    std::vector<std::string> keys(const std::string& of_what) const;
    // Returns this object. Throws UsageError if it has any other key than these.
    const Value& with_keys(const std::vector<std::string>& known) const;
    std::optional<Value> find(const std::string& key) const;  // none if it is absent
    Value at(const std::string& key) const;

  private:
    struct File;
    Value(std::shared_ptr<const File> file, const nlohmann::json& json, std::string path);

    std::shared_ptr<const File> file_;
    const nlohmann::json* json_;
    std::string path_;
};

// The items of a list. Each is made when it is asked for, because a file may have millions.
class Value::List {
  public:
    std::size_t size() const;
    bool empty() const { return size() == 0; }
    Value operator[](std::size_t index) const;

    struct Iterator {
        const List* list;
        std::size_t index;
        Value operator*() const { return (*list)[index]; }
        Iterator& operator++() {
            ++index;
            return *this;
        }
        bool operator==(const Iterator&) const = default;
    };
    Iterator begin() const { return {this, 0}; }
    Iterator end() const { return {this, size()}; }

  private:
    friend class Value;
    explicit List(Value whole) : whole_{std::move(whole)} {}

    Value whole_;
};

// A number in the form in which a person writes it.
std::string number_text(double number);

// What to say after "is not known": the word that was probably meant, or `otherwise` and all words.
std::string meant(const std::string& wrong, const std::vector<std::string>& words,
                  const std::string& otherwise);

}  // namespace app
