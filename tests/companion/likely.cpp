#include <companion/check/likely.hpp>

#include "catch.hpp"

using namespace companion;

namespace {

Mistake mistake(const std::string& name, const std::string& caught_by, const std::string& before,
                const std::string& after) {
    return {.name = name,
            .title = {},
            .caught_by = caught_by,
            .explanation = {},
            .remarks = {},
            .edits = {{"rt/f.hpp", before, after, {}}}};
}

TestCase test(const std::string& name, bool passed, bool hard = false) {
    TestCase test;
    test.name = name;
    test.hard = hard;
    test.passed = passed;
    test.ended = true;
    return test;
}

std::vector<std::string> names(const std::vector<Mistake>& all) {
    std::vector<std::string> names;
    for (const Mistake& one : all) names.push_back(one.name);
    return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("the mistake whose code the answer has comes first", "[likely]") {
    const std::vector<Mistake> all{
        mistake("half", "01.1 one", "    return b / 2;\n", "    return b;\n"),
        mistake("sign", "01.1 one", "    if (x > 0) y = -y;\n", "    if (x >= 0) y = -y;\n"),
        mistake("root", "01.1 one", "    r = std::sqrt(d);\n", "    r = d;\n")};
    const std::vector<TestCase> tests{test("01.1 one", false)};
    const auto first = [&](const std::string& code) {
        return names(likely_mistakes(all, tests, code)).at(0);
    };
    // As a learner may write it, with other spaces and more around it.
    CHECK(first("Real f() { r = std::sqrt(d); if(x>=0) y=-y; return b / 2; }") == "sign");
    CHECK(first("Real f() { r = d; if (x > 0) y = -y; return b / 2; }") == "root");
    CHECK(first("Real f() { r = std::sqrt(d); if (x > 0) y = -y; return b; }") == "half");
}

TEST_CASE("the mistake that the first failing test case catches comes first", "[likely]") {
    const auto of = [](const std::string& name, const std::string& caught_by) {
        return mistake(name, caught_by, "a\n", "b\n");
    };
    const std::vector<Mistake> all{of("star", "01.1 star"), of("passed", "01.1 passes"),
                                   of("second", "01.1 two"), of("first", "01.1 one")};
    CHECK(names(likely_mistakes(all,
                                {test("01.1 star", false, true), test("01.1 passes", true),
                                 test("01.1 one", false), test("01.1 two", false)},
                                "")) == Names{"first", "second", "star"});
    // Once the core passes, it is the stars' turn.
    CHECK(names(likely_mistakes(all,
                                {test("01.1 passes", true), test("01.1 one", true),
                                 test("01.1 two", true), test("01.1 star", false, true)},
                                "")) == Names{"star"});
}

TEST_CASE("a mistake in code that the answer lacks is not tried", "[likely]") {
    std::vector<Mistake> all{mistake("shadow", "01.1 one", "a\n", "b\n")};
    all[0].remarks["only if the answer has"] = "shadow";
    const std::vector<TestCase> tests{test("01.1 one", false)};
    CHECK(likely_mistakes(all, tests, "int f();").empty());
    CHECK(likely_mistakes(all, tests, "bool shadow;").size() == 1);
}
