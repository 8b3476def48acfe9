#include <companion/check/verdict_text.hpp>

#include <csignal>

#include "catch.hpp"

using namespace companion;

namespace {

// What the learner reads of an answer with this verdict.
std::string told(const Verdict& verdict) {
    Checked checked;
    checked.exercise = {.id = "01.1", .title = "One", .chapter = {"01_x"}, .files = {"a.hpp"}};
    checked.verdict = verdict;
    return details(checked);
}

TestCase failing(const std::string& name, const std::string& expanded) {
    TestCase test;
    test.name = name;
    test.ended = true;
    test.failures.push_back({"CHECK( a == b )", expanded, "", {}, ""});
    return test;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("numbers are shown as a person writes them", "[verdict_text]") {
    CHECK(has(told(Failing{{failing("x", "1000 (0x3e8) == 1 (0x1)")}}), "1000 == 1\n"));
    const std::string addresses = told(Failing{{failing(
        "x", "0x000055d0c0ffee00 == 0x000055d0c0ffee40 || 0x000055d0c0ffee00 == nullptr")}});
    CHECK(has(addresses, "address A == address B || address A == nullptr"));
    std::string large(305, '5');
    large[0] = '-';
    CHECK(has(told(Failing{{failing("x", large + ".0 == 12.5")}}), "-5.55e+303 == 12.5"));
    // Hexadecimal fractions and short numbers stay.
    CHECK(has(told(Failing{{failing("x", "0x1.8000000p+1 == 0xff")}}), "0x1.8000000p+1 == 0xff"));
}

TEST_CASE("values that do not differ as they are shown are left out", "[verdict_text]") {
    for (const char* const values : {"0.0 == 0.0", "1.0 <= 1.0", "{?} == {?}", "false"})
        CHECK_FALSE(has(told(Failing{{failing("x", values)}}), "actual:"));
    for (const char* const values : {"0.0 == 0.1", "{ 1, 2 } == { 1, 3 }", "!true", "2.0 <= 1.0"})
        CHECK(has(told(Failing{{failing("x", values)}}), std::string{"actual: "} + values));
}

TEST_CASE("what an earlier assertion expected is left out", "[verdict_text]") {
    TestCase test = failing("x", "1 == 2");
    test.failures.front().messages = {{"pixel 3", "", ""},
                                      {"expected 4, but yours gives 4", "4", ""},
                                      {"row 2, as expected by all", "", ""},
                                      {"expected 2, but yours gives 1", "2", ""}};
    const std::string text = told(Failing{{test}});
    CHECK(has(text, "pixel 3"));
    CHECK(has(text, "row 2"));
    CHECK(has(text, "expected 2,"));
    CHECK_FALSE(has(text, "expected 4,"));
}

TEST_CASE("values that a message has compared are not shown again", "[verdict_text]") {
    TestCase test = failing("x", "4503.5 <= 4");
    const auto shows_values = [&](const std::string& expected, const std::string& actual) {
        test.failures.front().messages = {{"expected 1, actual 2", expected, actual}};
        return has(told(Failing{{test}}), "checked: CHECK( a == b )");
    };
    CHECK_FALSE(shows_values("7", "3.6"));
    CHECK_FALSE(shows_values("no hit", "t = 4"));
    // What was compared is something else, or its digits are too few; or the words alone say so.
    CHECK(shows_values("the point (1, 4, 3)", "(1, 4, 3)"));
    CHECK(shows_values("2", ""));
    CHECK(shows_values("", ""));
}

TEST_CASE("what helps only if the code crashes is told only then", "[verdict_text]") {
    TestCase test = failing("x", "1 == 2");
    test.failures.front().messages = {{"Hint, if this crashes: return", "", "", true},
                                      {"a leaf, if this crashes", "", ""}};
    const std::string fails = told(Failing{{test}});
    CHECK_FALSE(has(fails, "return"));
    CHECK(has(fails, "a leaf"));
    test.crash = "SIGSEGV";
    CHECK(has(told(Crashed{{test}}), "Hint, if this crashes: return"));
}

TEST_CASE("locks and threads are named from chapter 06 on", "[verdict_text]") {
    const auto told_in = [](const std::string& exercise, bool waits) {
        Checked checked;
        checked.exercise = {.id = exercise, .title = "One", .chapter = {}, .files = {"a.hpp"}};
        checked.verdict = Endless{{}, "it waited for 3 s without finishing", waits};
        return details(checked);
    };
    CHECK(has(told_in("05.6", true), "Which loop or recursion never ends?"));
    CHECK(has(told_in("06.2", false), "Which loop or recursion never ends?"));
    CHECK(has(told_in("06.2", true), "Does it wait for a lock"));
    CHECK_FALSE(has(told_in("05.6", true), "lock"));

    Tested aborted;
    aborted.exercise = "05.6";
    aborted.result.signal = SIGABRT;
    CHECK_FALSE(has(aborted.trouble(), "thread"));
    aborted.exercise = "12.1";
    CHECK(has(aborted.trouble(), "a std::thread was destroyed"));
}

TEST_CASE("a loop that a busy machine slows down does not wait", "[verdict_text]") {
    Tested tested;
    tested.result.timed_out = true;
    tested.result.seconds = 20;
    tested.result.cpu_seconds = 2;
    CHECK_FALSE(tested.waited());
    tested.result.cpu_seconds = 0.1;
    CHECK(tested.waited());
}

TEST_CASE("the most telling test case is shown, and the others are named", "[verdict_text]") {
    Checked checked;
    checked.verdict =
        Failing{{failing("many", "1 == 2"), failing("few", "3 == 4"), failing("one", "5 == 6")}};
    const auto shows = [&](const std::string& telling, const std::string& shown,
                           const std::string& others) {
        return has(details(checked, telling), "  " + shown + "\n    checked:") &&
               has(details(checked, telling), "Also failing:\n" + others);
    };
    CHECK(shows("", "many", "    few\n    one\n"));
    CHECK(shows("one", "one", "    many\n    few\n"));
    CHECK(shows("another", "many", "    few\n    one\n"));
}

TEST_CASE("a line that drops a fraction is shown where the core fails", "[verdict_text]") {
    Checked checked;
    checked.slip = "a.hpp:3: `1 / 2` divides whole numbers";
    checked.verdict = Failing{{failing("x", "1 == 2")}};
    CHECK(
        has(details(checked), "Look at this line:\n    a.hpp:3: `1 / 2` divides whole numbers\n"));
    checked.verdict = Passed{};
    CHECK_FALSE(has(details(checked), "Look at"));
}

TEST_CASE("an exercise that is begun says what comes next", "[verdict_text]") {
    Checked checked;
    checked.exercise.functions = 3;
    checked.verdict = Begun{std::vector<TestCase>(4), {"normalize"}};
    CHECK(has(summary_line(checked), "2 of 3 functions are written, next: normalize"));
    checked.verdict = Begun{std::vector<TestCase>(4), {"a", "b", "c"}};
    CHECK_FALSE(has(summary_line(checked), "functions"));
}

TEST_CASE("a crash does not hide what failed before it", "[verdict_text]") {
    TestCase crashed = failing("second", "");
    crashed.failures.front().expression = "CHECK( {Unknown expression after the reported line} )";
    crashed.crash = "SIGSEGV";
    const std::string both = told(Crashed{{failing("first", "1 == 2"), crashed}});
    CHECK(has(both, "second"));
    CHECK(has(both, "Before that, this failed:\n  first\n"));
    CHECK(has(both, "1 == 2"));
    CHECK_FALSE(has(both, "Unknown expression"));
    CHECK_FALSE(has(told(Crashed{{crashed}}), "Before that"));
}

TEST_CASE("what is still to be written does not count as failing", "[verdict_text]") {
    TestCase passing, missing = failing("later", "");
    passing.passed = passing.ended = true;
    missing.failures.front().missing = "01.1";
    const auto line = [](const std::vector<TestCase>& tests) {
        Checked checked;
        checked.verdict = Failing{tests};
        return summary_line(checked);
    };
    const TestCase wrong = failing("wrong", "1 == 2");
    CHECK(has(line({passing, wrong, missing, missing}),
              "failing: 1 of 4 test cases, 2 still to be written"));
    CHECK_FALSE(has(line({passing, wrong, wrong}), "written"));
    CHECK(has(line({missing, missing}), "failing: no test case calls your code"));
}

TEST_CASE("stars are told once the core passes", "[verdict_text]") {
    TestCase star = failing("the star", "8 == 7"), core = failing("the core", "3 == 2");
    star.hard = true;
    const std::string text = told(Failing{{star, core}});
    CHECK(has(text, "the core"));
    CHECK_FALSE(has(text, "the star"));

    Checked checked;
    checked.exercise.id = "01.1";
    checked.exercise.title = "One";
    checked.exercise.chapter.name = "01_x";
    checked.verdict = Passed{};
    CHECK(open_stars(checked).empty());
    checked.verdict = Passed{.stars = 4,
                             .open_stars = {{star},
                                            {failing("another", "1 == 2"), true},
                                            {failing("third", ""), false, "it divided by 0"}}};
    CHECK(has(summary_line(checked), "* 01.1"));
    CHECK(has(summary_line(checked), "core passes, 3 stars open\n"));
    CHECK(
        has(summary_line(checked, "--stars"), "core passes, 3 stars open (--stars shows them)\n"));
    CHECK(float_lines({checked}, "--stars") ==
          "    01.1  in float: 1 more star is open (--stars shows it)\n");
    const std::string all = open_stars(checked);
    CHECK(has(all, "the star\n"));
    CHECK(has(all, "another, in float\n"));
    CHECK(has(all, "it divided by 0.\n"));

    CHECK(has(where_to_read(checked), "now or later. Stuck? ./course hint 01.1\n"));
    CHECK_FALSE(has(all, "warned"));
    checked.warning = "a.hpp:3: suggest parentheses around assignment used as truth value";
    const std::string with_warning = open_stars(checked);
    CHECK(has(with_warning, "The compiler warned:\n    a.hpp:3: suggest"));
    CHECK(has(with_warning, "write `==` to compare"));
}
