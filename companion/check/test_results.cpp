#include <algorithm>
#include <companion/check/test_results.hpp>
#include <companion/system/terminal.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

namespace companion {
namespace {

using nlohmann::json;

std::string trimmed(const std::string& text, const char* blank = " \t\r\n") {
    const auto first = text.find_first_not_of(blank);
    return first == std::string::npos
               ? ""
               : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

// "a\n      + b" as "a + b": line breaks and indents in a test do not matter.
std::string one_line(const std::string& text) {
    std::istringstream words{text};
    std::string line;
    for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
    return line;
}

// The text of an event under this key; empty if it has none.
std::string text_of(const json& event, const char* key) {
    return printable(event.value(key, ""));
}

TestCase described(const json& test) {
    TestCase described;
    described.name = text_of(test, "name");
    described.hard = test.value("hard", false);
    return described;
}

FailedAssertion read_failure(const json& event) {
    FailedAssertion failure;
    failure.exception = trimmed(text_of(event, "exception"));
    if (const std::string expression = one_line(text_of(event, "expression")); !expression.empty())
        failure.expression = text_of(event, "macro") + "( " + expression + " )";
    else if (!event.contains("exception"))
        failure.expression = "FAIL";
    failure.expanded = one_line(text_of(event, "expanded"));
    failure.missing = text_of(event, "missing");
    for (const json& message : event.value("messages", json::array()))
        failure.messages.push_back(
            {trimmed(text_of(message, "text")), trimmed(text_of(message, "expected"), " ,.;\n"),
             trimmed(text_of(message, "actual"), " ,.;\n"), message.value("if_it_crashes", false),
             message.value("counts", "")});
    return failure;
}

void read_event(const json& event, Report& report) {
    std::vector<TestCase>& tests = report.tests;
    const std::string what = text_of(event, "event");
    if (what == "cases")
        for (const json& test : event.at("cases")) report.compiled.push_back(described(test));
    if (what == "exits") report.exited = true;
    if (what == "begins") tests.push_back(described(event));
    if (tests.empty()) return;
    TestCase& test = tests.back();
    if (what == "failed") {
        test.failures.push_back(read_failure(event));
    } else if (what == "crashes") {
        test.crash = text_of(event, "cause");
        test.memory = text_of(event, "memory");
    } else if (what == "computes") {
        test.computed = event.value("seconds", 0);
    } else if (what == "waits") {
        test.waited = event.value("seconds", 0);
    } else if (what == "ends") {
        test.ended = true;
        test.passed = event.value("passed", false);
        test.output = trimmed(text_of(event, "output"));
    }
}

}  // namespace

bool Message::compares() const {
    // The expected value may have words before it: "the point (1, 4, 3)".
    return !expected.empty() && !actual.empty() && expected.find(actual) == std::string::npos;
}

const Message* FailedAssertion::expectation() const {
    const auto last = std::find_if(messages.rbegin(), messages.rend(), [](const Message& message) {
        return !message.expected.empty();
    });
    return last == messages.rend() ? nullptr : &*last;
}

Report read_report(const std::string& lines, const std::string& secret) {
    const std::string start = secret.empty() ? "{" : secret + " {";
    Report report;
    std::istringstream in{lines};
    for (std::string line; std::getline(in, line);) {
        if (line.rfind(start, 0) != 0) continue;  // the tested code printed this line
        try {
            read_event(json::parse(line.substr(start.size() - 1)), report);
        } catch (const json::exception&) {  // and this one
        }
    }
    return report;
}

std::string missing_exercise(const TestCase& test) {
    for (const FailedAssertion& failure : test.failures)
        if (!failure.missing.empty()) return failure.missing;
    return "";
}

}  // namespace companion
