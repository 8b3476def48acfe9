#include <companion/check/test_results.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

namespace companion {
namespace {

using nlohmann::json;

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

FailedAssertion read_failure(const json& event) {
    FailedAssertion failure;
    if (event.contains("expression"))
        failure.expression = event.value("macro", "") + "( " + one_line(event["expression"]) + " )";
    else if (!event.contains("exception"))
        failure.expression = "FAIL";
    failure.expanded = one_line(event.value("expanded", ""));
    failure.exception = trimmed(event.value("exception", ""));
    failure.missing = event.value("missing", "");
    for (const json& message : event.at("messages")) failure.messages.push_back(trimmed(message));
    return failure;
}

void read_event(const json& event, std::vector<TestCase>& tests) {
    const std::string what = event.at("event");
    if (what == "begins") tests.emplace_back().name = event.at("name");
    if (tests.empty()) return;
    TestCase& test = tests.back();
    if (what == "failed") {
        test.failures.push_back(read_failure(event));
    } else if (what == "crashes") {
        test.crash = event.at("cause");
    } else if (what == "ends") {
        test.ended = true;
        test.passed = event.at("passed");
        test.output = trimmed(event.at("output"));
    }
}

}  // namespace

std::vector<TestCase> read_report(const std::string& lines) {
    std::vector<TestCase> tests;
    std::istringstream in{lines};
    for (std::string line; std::getline(in, line);) {
        if (line.rfind('{', 0) != 0) continue;  // the tested code printed this
        try {
            if (const json event = json::parse(line, nullptr, false); event.is_object())
                read_event(event, tests);
        } catch (const json::exception&) {  // and this
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
