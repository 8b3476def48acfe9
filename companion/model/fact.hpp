#pragma once
// Reading a file of facts: every error says where it is and what would be right.

#include <app/json.hpp>
#include <string>
#include <vector>

namespace companion {

// A value of a JSON file and its position there. All members throw app::UsageError if the value is
// not of the kind that is asked for.
class Fact {
  public:
    // The file's name is for messages. The JSON must outlive the fact.
    Fact(const app::Json& json, std::string file, std::string path = "")
        : json_{json}, file_{std::move(file)}, path_{std::move(path)} {}

    [[noreturn]] void fail(const std::string& what) const;
    bool has(const char* key) const;
    Fact operator[](const char* key) const;
    std::vector<Fact> list() const;  // of one or more
    std::string text() const;        // not empty
    double number() const;
    int count(int least = 1) const;  // at most 1000
    bool yes() const;
    bool is_text() const { return json_.kind == app::Json::Kind::text; }

  private:
    void require(bool fits, const std::string& wanted) const {
        if (!fits) fail("should be " + wanted);
    }

    const app::Json& json_;
    std::string file_, path_;
};

}  // namespace companion
