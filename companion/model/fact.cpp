#include <algorithm>
#include <app/errors.hpp>
#include <cmath>
#include <companion/model/fact.hpp>

namespace companion {

using Kind = app::Json::Kind;

void Fact::fail(const std::string& what) const {
    throw app::UsageError(file_ + ": " + (path_.empty() ? "the top level" : path_) + ' ' + what);
}

bool Fact::has(const char* key) const {
    return std::find(json_.keys.begin(), json_.keys.end(), key) != json_.keys.end();
}

Fact Fact::operator[](const char* key) const {
    require(json_.kind == Kind::object, "an object, { ... }");
    const std::string path = app::path_of_member(path_, key);
    for (std::size_t i = 0; i < json_.keys.size(); ++i)
        if (json_.keys[i] == key) return {json_.items[i], file_, path};
    throw app::UsageError(file_ + ": " + path + " is missing");
}

std::vector<Fact> Fact::list() const {
    require(json_.kind == Kind::list && !json_.items.empty(), "a list, [ ... ], of one or more");
    std::vector<Fact> facts;
    for (std::size_t i = 0; i < json_.items.size(); ++i)
        facts.push_back({json_.items[i], file_, app::path_of_item(path_, i)});
    return facts;
}

std::string Fact::text() const {
    require(json_.kind == Kind::text && !json_.text.empty(), "a text in quotes");
    return json_.text;
}

double Fact::number() const {
    require(json_.kind == Kind::number, "a number");
    return json_.number;
}

int Fact::count(int least) const {
    require(json_.kind == Kind::number && json_.number >= least && json_.number <= 1000 &&
                json_.number == std::floor(json_.number),
            "a whole number from " + std::to_string(least) + " to 1000");
    return static_cast<int>(json_.number);
}

bool Fact::yes() const {
    require(json_.kind == Kind::boolean, "true or false");
    return json_.number != 0;
}

}  // namespace companion
