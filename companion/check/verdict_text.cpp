#include <algorithm>
#include <companion/check/compiler_words.hpp>
#include <companion/check/verdict_text.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/terminal.hpp>
#include <rt/counted.hpp>
#include <sstream>

namespace companion {
namespace {

// The text, with blanks added up to this many columns.
std::string padded(std::string text, std::size_t width) {
    if (text.size() < width) text.resize(width, ' ');
    return text;
}

std::string cases(int count) {
    return rt::counted(count, "test case");
}

// "; 2 of 3 functions are written, next: normalize".
std::string functions_done(int all, const std::vector<std::string>& names_left) {
    const int left = static_cast<int>(names_left.size());
    if (left == 0 || all < 2 || left >= all) return "";
    return "; " + std::to_string(all - left) + " of " + std::to_string(all) +
           " functions are written, next: " + bold(names_left.front());
}

constexpr const char* to_write = "It is still to be written: replace the lines with rt::todo.\n";

// One function for each kind of verdict.
template <class... Cases>
struct Kinds : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Kinds(Cases...) -> Kinds<Cases...>;

std::string failing_text(const Failing& failing, bool in_float) {
    int all = 0, wrong = 0, missing = 0;  // test cases of the core; stars are not counted
    for (const TestCase& test : failing.tests) {
        if (test.hard) continue;
        ++all;
        if (!test.passed) ++(missing_exercise(test).empty() ? wrong : missing);
    }
    if (wrong == 0) return red("failing: no test case calls your code");
    return red((in_float ? "failing in float: " : "failing: ") + std::to_string(wrong) + " of " +
               cases(all)) +
           (missing == 0 ? "" : yellow(", " + std::to_string(missing) + " still to be written"));
}

std::string begun_text(const Checked& checked, const Begun& begun) {
    const int all = static_cast<int>(begun.tests.size()), passed = checked.passed_cases();
    return yellow(passed == 0 ? "begun: all " + cases(all) + " reach an rt::todo"
                              : "begun: " + std::to_string(passed) + " of " + cases(all) +
                                    " pass, and the rest is still to be written") +
           functions_done(checked.exercise.functions, begun.left);
}

// How to see them, after the number of open stars.
std::string shown_by(const std::string& command, bool is_one) {
    return command.empty() ? "" : " (" + command + (is_one ? " shows it)" : " shows them)");
}

std::string passed_text(const Passed& passed, const std::string& stars_command) {
    if (passed.open_stars.empty()) return green("done");
    const int open = static_cast<int>(passed.open_stars.size());
    return green("core passes") + ", " + yellow(stars_open(open)) +
           shown_by(stars_command, open == 1);
}

std::string verdict_text(const Checked& checked, const std::string& stars_command) {
    return std::visit(
        Kinds{[&](const Passed& passed) { return passed_text(passed, stars_command); },
              [&](const Failing& failing) { return failing_text(failing, checked.in_float); },
              [](const NotBegun&) { return dim("to be written"); },
              [&](const Begun& begun) { return begun_text(checked, begun); },
              [](const Waiting& waiting) { return yellow("needs " + waiting.missing + " first"); },
              [](const NoFile&) { return red("a file is missing"); },
              [](const auto& other) { return red(other.says); }},
        checked.verdict);
}

std::string symbol_of(const Verdict& verdict) {
    return std::visit(
        Kinds{[](const Passed& passed) { return green(passed.open_stars.empty() ? "+" : "*"); },
              [](const NotBegun&) { return dim("."); }, [](const Begun&) { return dim("."); },
              [](const Waiting&) { return yellow("-"); }, [](const auto&) { return red("x"); }},
        verdict);
}

// At most this many lines of a text.
std::string first_lines(const std::string& text, int count) {
    constexpr std::size_t most = 2000;
    std::istringstream in{text.substr(0, most)};
    std::string kept, line;
    for (int i = 0; i < count && std::getline(in, line); ++i) kept += line + '\n';
    if (text.size() > most) return kept + "...\n";
    if (std::getline(in, line)) kept += "...\n";
    return kept;
}

// Removes the hexadecimal form that Catch2 adds to whole numbers: "3210 (0xc8a)".
std::string without_hexadecimal(std::string text) {
    for (auto at = text.find(" (0x"); at != std::string::npos; at = text.find(" (0x", at)) {
        const auto end = text.find_first_not_of("0123456789abcdef", at + 4);
        if (end == std::string::npos || text[end] != ')') break;
        text.erase(at, end + 1 - at);
    }
    return text;
}

// Replaces addresses by "address A", "address B" and so on, because all that matters is which of
// them are equal. Eight digits, which are a number of 32 bits, are not an address.
std::string without_addresses(std::string text) {
    const char* const digits = "0123456789abcdefABCDEF";
    std::vector<std::string> seen;
    for (auto at = text.find("0x"); at != std::string::npos; at = text.find("0x", at + 1)) {
        const auto end = std::min(text.find_first_not_of(digits, at + 2), text.size());
        if (end - at < 2 + 9 || (end < text.size() && (text[end] == '.' || text[end] == 'p')))
            continue;
        const std::string address = text.substr(at, end - at);
        auto known = std::find(seen.begin(), seen.end(), address);
        if (known == seen.end()) known = seen.insert(seen.end(), address);
        const auto which = static_cast<std::size_t>(known - seen.begin());
        text.replace(at, end - at,
                     which < 26 ? "address " + std::string(1, static_cast<char>('A' + which))
                                : "another address");
    }
    return text;
}

// Shortens numbers that have more digits than are meaningful, as in "5.31e+303".
std::string without_long_numbers(std::string text) {
    constexpr std::size_t most = 30;
    const char* const digits = "0123456789";
    for (auto at = text.find_first_of(digits); at != std::string::npos;
         at = text.find_first_of(digits, at)) {
        auto end = std::min(text.find_first_not_of(digits, at), text.size());
        if (end - at > most) {
            const std::string exponent = "e+" + std::to_string(end - at - 1);
            if (end + 1 < text.size() && text[end] == '.')
                end = std::min(text.find_first_not_of(digits, end + 1), text.size());
            text.replace(at, end - at,
                         text.substr(at, 1) + '.' + text.substr(at + 1, 2) + exponent);
            end = at + 4 + exponent.size();
        }
        at = end;
    }
    return text;
}

std::string readable(const std::string& text) {
    return without_long_numbers(without_addresses(without_hexadecimal(text)));
}

// Whether this is Catch2's name for the expression in which a program crashed.
bool is_unknown(const FailedAssertion& failure) {
    return failure.expression.find("{Unknown expression") != std::string::npos;
}

// Whether the values say what is wrong. Values such as "false", "{?} == {?}", or "0.0 == 0.0",
// where the digits that differ are not shown, do not.
bool says_more(const FailedAssertion& failure) {
    const std::string& values = failure.expanded;
    if (values.empty() || values == "false" || values.find("{?}") != std::string::npos ||
        failure.expression.find(values) != std::string::npos)
        return false;
    for (const char* const sign : {" == ", " <= ", " >= ", " < ", " > "})
        if (const auto at = values.find(sign); at != std::string::npos)
            return values.substr(0, at) != values.substr(at + std::string{sign}.size());
    return true;
}

std::string describe(const FailedAssertion& failure, bool is_star) {
    const Message* const last = failure.expectation();
    std::string text;
    for (const Message& message : failure.messages)
        if (!message.if_it_crashes && !message.text.empty() &&
            (message.expected.empty() || &message == last))
            text += wrapped(readable(message.text), "    ");
    // The values of an assertion add nothing where a message has compared them already.
    const bool is_told = !is_star && last && last->compares();
    if (!is_told && !failure.expression.empty() && failure.expression != "FAIL" &&
        !is_unknown(failure)) {
        text += wrapped("checked: " + failure.expression, "    ");
        if (says_more(failure)) text += wrapped("actual: " + readable(failure.expanded), "    ");
    }
    if (!failure.exception.empty()) text += wrapped("it threw: " + failure.exception, "    ");
    return text;
}

// The text of a test case's first failure that has one.
std::string describe_all(const TestCase& test) {
    for (const FailedAssertion& failure : test.failures)
        if (const std::string text = describe(failure, test.hard); !text.empty()) return text;
    return "";
}

// What the test case in which the code crashed has to say about that.
std::string hint_on_crash(const std::vector<TestCase>& tests) {
    for (const TestCase& test : tests)
        if (test.broke_off() && !test.failures.empty())
            for (const Message& message : test.failures.back().messages)
                if (message.if_it_crashes) return wrapped(message.text, "  ");
    return "";
}

// Introduces what failed before a program crashed or was stopped.
std::string before_that(const std::string& failing) {
    return failing.empty() ? "" : "\nBefore that, this failed:\n" + failing;
}

// The test cases of the core that fail: one in full detail, the one with the name `first` or else
// the first, and the others by name. Stars can wait until the core passes.
std::string failing_cases(std::vector<TestCase> tests, const std::string& first = "") {
    std::stable_partition(tests.begin(), tests.end(),
                          [&](const TestCase& test) { return test.name == first; });
    std::string text, others;
    for (const TestCase& test : tests) {
        if (test.hard || test.passed || !missing_exercise(test).empty()) continue;
        if (test.broke_off() && describe_all(test).empty())
            continue;  // the crash is described elsewhere
        if (!text.empty()) {
            others += "    " + test.name + '\n';
            continue;
        }
        text += "  " + bold(test.name) + '\n';
        text += describe_all(test);
        if (!test.output.empty())
            text += "    your code printed:\n" + wrapped(first_lines(test.output, 10), "      ");
    }
    if (!others.empty()) text += "\n  Also failing:\n" + others;
    return text;
}

// What a compiler's message means.
std::string in_plain_words(const std::string& message) {
    const std::string words = plain_words(message);
    return words.empty() ? "" : wrapped("In plain words: " + words, "    ");
}

std::string warned(const Checked& checked) {
    std::string text;
    if (!checked.warning.empty())
        text += "\n  " + yellow("The compiler warned:") + '\n' + wrapped(checked.warning, "    ") +
                in_plain_words(checked.warning);
    if (!checked.slip.empty())
        text += "\n  " + yellow("Look at this line:") + '\n' + wrapped(checked.slip, "    ");
    return text;
}

// What ended the program, and in which test case.
std::string where(const std::vector<TestCase>& tests) {
    std::string name;
    for (const TestCase& test : tests)
        if (test.broke_off()) name = test.name;
    return name.empty() ? "" : " in the test case\n  " + bold(name);
}

std::string how_to_find_the_line(const Exercise& exercise) {
    const std::string other = instead_of_sanitizers();
    if (!other.empty()) return wrapped("To find the line: " + other + '.', "  ");
    return "  To find the line:  ./course check " + exercise.id + " --sanitize\n";
}

std::string what_is_wrong(const Checked& checked, const std::string& telling) {
    return std::visit(
        Kinds{[](const Passed&) { return std::string{}; },
              [](const NoFile& no_file) { return red(no_file.trouble) + '\n'; },
              [&](const NotCompiled& refused) {
                  return "It does not compile" + std::string{checked.in_float ? " in float" : ""} +
                         ". The first error:\n\n" + refused.error + '\n' +
                         in_plain_words(refused.error);
              },
              [&](const Crashed& crashed) {
                  return "It crashes" + where(crashed.tests) + '\n' +
                         wrapped(crashed.cause + '.', "  ") + hint_on_crash(crashed.tests) +
                         warned(checked) + '\n' + how_to_find_the_line(checked.exercise) +
                         before_that(failing_cases(crashed.tests));
              },
              [&](const Left& left) {
                  return "Your code ended the program" + where(left.tests) +
                         "\n  A function must return to its caller: do not call std::exit, "
                         "std::_Exit or the like.\n" +
                         warned(checked) + before_that(failing_cases(left.tests));
              },
              [&](const Endless& endless) {
                  return "It was stopped: " + endless.cause + where(endless.tests) +
                         (endless.waits && knows_threads(checked.exercise.id)
                              ? "\n  Does it wait for a lock that is never released, or for a "
                                "thread that never ends?\n"
                              : "\n  Which loop or recursion never ends?\n") +
                         warned(checked) + before_that(failing_cases(endless.tests));
              },
              [](const Waiting& waiting) {
                  return "It calls your function of exercise " + waiting.missing +
                         ", which is still to be written: write it first.\n";
              },
              [](const NotBegun&) { return std::string{to_write}; },
              [](const Begun& begun) {
                  return to_write + (begun.hint.empty() ? "" : '\n' + wrapped(begun.hint, "  "));
              },
              [&](const Failing& failing) {
                  const bool fits_double_only = checked.in_float && checked.warning.empty();
                  return std::string{
                             fits_double_only
                                 ? "\nIt passes in double and fails in float (rt::Real is float): "
                                   "is a constant or a tolerance\nright only for double?\n"
                                 : ""} +
                         '\n' +
                         (failing.reason.empty() ? failing_cases(failing.tests, telling)
                                                 : wrapped(failing.reason, "  ")) +
                         warned(checked);
              }},
        checked.verdict);
}

}  // namespace

std::string summary_line(const Checked& checked, const std::string& stars_command) {
    return "  " + symbol_of(checked.verdict) + ' ' + checked.exercise.id + "  " +
           padded(checked.exercise.title, 36) + ' ' + verdict_text(checked, stars_command) + '\n';
}

std::string float_lines(const std::vector<Checked>& all, const std::string& stars_command) {
    std::string lines;
    for (const Checked& checked : all) {
        if (checked.in_float) lines += summary_line(checked);
        if (!checked.passed()) continue;
        const auto& open = checked.passed()->open_stars;
        const auto more = std::count_if(open.begin(), open.end(),
                                        [](const OpenStar& star) { return star.in_float; });
        if (more > 0)
            lines +=
                "    " + checked.exercise.id + "  in float: " + rt::counted(more, "more star") +
                (more == 1 ? " is open" : " are open") + shown_by(stars_command, more == 1) + '\n';
    }
    return lines;
}

std::string details(const Checked& checked, const std::string& telling) {
    const Exercise& exercise = checked.exercise;
    if (checked.is<NoFile>()) return what_is_wrong(checked, telling);
    const std::string head =
        bold(exercise.id + ' ' + exercise.title) + ", " + exercise.file_list() + "\n";
    return checked.passed() ? head : head + what_is_wrong(checked, telling);
}

std::string looks_like(const Mistake& mistake, Joins joins) {
    const char* const start = joins == Joins::first   ? "This looks like: "
                              : joins == Joins::as_or ? "or like: "
                                                      : "and like: ";
    return "\n  " + yellow(start + mistake.title) + '\n' + wrapped(mistake.explanation, "    ");
}

std::string where_to_read(const Checked& checked) {
    const Exercise& exercise = checked.exercise;
    if (checked.is<NoFile>()) return "";
    return "\n  Read " + exercise.section() + (checked.passed() ? ", now or later" : "") +
           ". Stuck? ./course hint " + exercise.id + '\n';
}

std::string open_stars(const Checked& checked) {
    const Passed* const passed = checked.passed();
    if (!passed || passed->open_stars.empty()) return "";
    std::string text;
    for (const OpenStar& star : passed->open_stars) {
        text += (text.empty() ? "" : "\n") + yellow("Star: ") + bold(star.test.name) +
                (star.in_float ? ", in float" : "") + '\n';
        if (!star.trouble.empty()) text += wrapped(star.trouble + '.', "    ");
        text += describe_all(star.test);
    }
    return text + warned(checked);
}

std::string stars_open(int count) {
    return rt::counted(count, "star") + " open";
}

}  // namespace companion
