#include <app/errors.hpp>
#include <app/json.hpp>
#include <companion/check/test_results.hpp>
#include <sstream>

namespace companion {
namespace {

using app::Json;

std::string trimmed(const std::string& text) {
    const char* const blank = " \t\r\n";
    const auto first = text.find_first_not_of(blank);
    return first == std::string::npos
               ? ""
               : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

// "a\n      + b" as "a + b": how a test is laid out does not matter.
std::string one_line(const std::string& text) {
    std::istringstream words{text};
    std::string line;
    for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
    return line;
}

// The text of an event under this key; empty if it has none.
std::string text_of(const Json& event, const std::string& key) {
    const Json* const found = app::find(event, key, Json::Kind::text);
    return found ? found->text : "";
}

bool is_true(const Json& event, const std::string& key) {
    const Json* const found = app::find(event, key, Json::Kind::boolean);
    return found && found->number != 0;
}

FailedAssertion read_failure(const Json& event) {
    FailedAssertion failure;
    failure.exception = trimmed(text_of(event, "exception"));
    if (const std::string expression = one_line(text_of(event, "expression")); !expression.empty())
        failure.expression = text_of(event, "macro") + "( " + expression + " )";
    else if (!app::find(event, "exception", Json::Kind::text))
        failure.expression = "FAIL";
    failure.expanded = one_line(text_of(event, "expanded"));
    failure.missing = text_of(event, "missing");
    if (const Json* const messages = app::find(event, "messages", Json::Kind::list))
        for (const Json& message : messages->items)
            failure.messages.push_back(trimmed(message.text));
    return failure;
}

void read_event(const Json& event, std::vector<TestCase>& tests) {
    const std::string what = text_of(event, "event");
    if (what == "begins") {
        tests.emplace_back().name = text_of(event, "name");
        tests.back().hard = is_true(event, "hard");
    }
    if (tests.empty()) return;
    TestCase& test = tests.back();
    if (what == "failed") {
        test.failures.push_back(read_failure(event));
    } else if (what == "crashes") {
        test.crash = text_of(event, "cause");
        test.memory = text_of(event, "memory");
    } else if (what == "ends") {
        test.ended = true;
        test.passed = is_true(event, "passed");
        test.output = trimmed(text_of(event, "output"));
    }
}

}  // namespace

std::vector<TestCase> read_report(const std::string& lines) {
    std::vector<TestCase> tests;
    std::istringstream in{lines};
    for (std::string line; std::getline(in, line);) {
        if (line.rfind('{', 0) != 0) continue;  // the tested code printed this
        try {
            read_event(app::parse_json(line, "report"), tests);
        } catch (const app::UsageError&) {  // and this
        }
    }
    return tests;
}

std::string missing_exercise(const TestCase& test) {
    for (const FailedAssertion& failure : test.failures)
        if (!failure.missing.empty()) return failure.missing;
    return "";
}

}  // namespace companion
