#include <companion/check/test_results.hpp>
#include <cstdlib>

namespace companion {
namespace {

std::string trimmed(const std::string& text) {
    const char* const blank = " \t\r\n";
    const auto first = text.find_first_not_of(blank);
    return first == std::string::npos
               ? ""
               : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

// "&lt;" and the like as the characters that they stand for.
std::string unescaped(const std::string& text) {
    static const struct {
        const char *name, *meaning;
    } entities[]{{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}};
    std::string plain;
    for (std::size_t i = 0; i < text.size();) {
        bool known = false;
        for (const auto& [name, meaning] : entities)
            if (const std::string entity{name}; text.compare(i, entity.size(), entity) == 0) {
                plain += meaning;
                i += entity.size();
                known = true;
                break;
            }
        if (!known) plain += text[i++];
    }
    return plain;
}

// One tag after the other, and the text before each.
class Tags {
  public:
    explicit Tags(const std::string& xml) : xml_{xml} {}

    std::string name;        // "TestCase", or "/TestCase" at its end
    std::string attributes;  // as they stand
    std::string before;      // the text between the tag before and this one

    bool next() {
        const auto open = xml_.find('<', at_);
        auto close = open;
        for (bool quoted = false; close < xml_.size() && (quoted || xml_[close] != '>'); ++close)
            quoted ^= xml_[close] == '"';
        if (close >= xml_.size()) return false;
        before = unescaped(trimmed(xml_.substr(at_, open - at_)));
        const std::string tag = xml_.substr(open + 1, close - open - 1);
        const auto end = tag.find_first_of(" \t\r\n");
        name = tag.substr(0, end);
        attributes = end == std::string::npos ? "" : tag.substr(end);
        at_ = close + 1;
        return true;
    }

    std::string attribute(const std::string& key) const {
        const std::string start = ' ' + key + "=\"";
        const auto at = attributes.find(start);
        if (at == std::string::npos) return "";
        const auto from = at + start.size();
        return unescaped(attributes.substr(from, attributes.find('"', from) - from));
    }

  private:
    const std::string& xml_;
    std::size_t at_ = 0;
};

// "a\n      + b" as "a + b": how a test is laid out does not matter.
std::string one_line(const std::string& text) {
    std::string line;
    for (const char c : text) {
        const bool is_blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
        if (!is_blank)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    return line;
}

}  // namespace

std::vector<TestCase> read_report(const std::string& xml) {
    std::vector<TestCase> tests;
    FailedAssertion current;  // what is known so far of the next failure
    bool in_expression = false, expression_failed = false;
    for (Tags tags{xml}; tags.next();) {
        if (tags.name == "TestCase") {
            tests.emplace_back();
            tests.back().name = tags.attribute("name");
            current = {};
        }
        if (tests.empty()) continue;
        TestCase& test = tests.back();
        const auto failed = [&] {
            test.failures.push_back(current);
            current = {};
        };
        if (tags.name == "Expression") {
            in_expression = true;
            expression_failed = tags.attribute("success") != "true";
            current.expression = tags.attribute("type");
        } else if (tags.name == "/Info" || tags.name == "/Warning") {
            current.messages.push_back(tags.before);
        } else if (tags.name == "/Original") {
            current.expression += "( " + one_line(tags.before) + " )";
        } else if (tags.name == "/Expanded") {
            current.expanded = one_line(tags.before);
        } else if (tags.name == "/Exception") {
            current.exception = tags.before;
            if (!in_expression) failed();
        } else if (tags.name == "/Expression") {
            in_expression = false;
            if (expression_failed)
                failed();
            else
                current = {};
        } else if (tags.name == "/Failure") {
            current.expression = "FAIL";
            current.messages.push_back(tags.before);
            failed();
        } else if (tags.name == "/FatalErrorCondition") {
            test.crash = one_line(tags.before);
        } else if (tags.name == "/StdOut") {
            test.output = tags.before;
        } else if (tags.name == "OverallResult") {
            test.ended = true;
            test.passed = tags.attribute("success") == "true";
        }
    }
    return tests;
}

std::string missing_exercise(const TestCase& test) {
    const std::string start = "exercise ", end = " is still to be written";
    for (const FailedAssertion& failure : test.failures) {
        const auto last = failure.exception.find(end);
        if (last != std::string::npos && failure.exception.rfind(start, 0) == 0)
            return failure.exception.substr(start.size(), last - start.size());
    }
    return "";
}

}  // namespace companion
