#include <algorithm>
#include <companion/check/compiler_words.hpp>
#include <companion/check/known_mistakes.hpp>
#include <companion/check/verdict_text.hpp>
#include <companion/model/progress.hpp>
#include <companion/own/standing.hpp>
#include <companion/system/terminal.hpp>
#include <sstream>

namespace companion {
namespace {

// The text, padded with blanks to this many columns.
std::string padded(std::string text, std::size_t width) {
    if (text.size() < width) text.resize(width, ' ');
    return text;
}

std::string cases(int count) {
    return std::to_string(count) + (count == 1 ? " test case" : " test cases");
}

std::string files_of(const Exercise& exercise) {
    std::string files;
    for (const fs::path& file : exercise.files)
        files += (files.empty() ? "" : ", ") + file.string();
    return files;
}

// "; 2 of 3 functions are written, next: normalize".
std::string functions_done(const Checked& checked) {
    const int all = checked.exercise.functions, left = static_cast<int>(checked.left.size());
    if (left == 0 || all < 2 || left >= all) return "";
    return "; " + std::to_string(all - left) + " of " + std::to_string(all) +
           " functions are written, next: " + bold(checked.left.front());
}

std::string verdict_text(const Checked& checked) {
    const int all = static_cast<int>(checked.tests.size()), passed = passed_cases(checked);
    const auto missing = static_cast<int>(std::count_if(
        checked.tests.begin(), checked.tests.end(),
        [](const TestCase& test) { return !test.passed && !missing_exercise(test).empty(); }));
    const int failing = all - passed - missing;
    switch (checked.verdict) {
        case Verdict::passed:
            if (checked.open_stars.empty()) return green("done");
            return green("core passes") + ", " +
                   yellow(stars_open(static_cast<int>(checked.open_stars.size())));
        case Verdict::failing:
            if (failing == 0) return red("failing: no test case reaches your code");
            return red((checked.in_float ? "failing in float: " : "failing: ") +
                       std::to_string(failing) + " of " + cases(all)) +
                   (missing == 0 ? ""
                                 : yellow(", " + std::to_string(missing) + " still to be written"));
        case Verdict::no_file:
            return red("a file is missing");
        case Verdict::to_write:
            if (all == 0) return dim("to be written");
            return yellow(passed == 0 ? "begun: all " + cases(all) + " hit an rt::todo"
                                      : "begun: " + std::to_string(passed) + " of " + cases(all) +
                                            " pass, the rest is still to be written") +
                   functions_done(checked);
        case Verdict::waiting:
            return yellow("needs " + checked.missing + " first");
        case Verdict::not_compiled:
            return red("does not compile");
        case Verdict::crashed:
            return red("crashes");
        case Verdict::endless:
            return red("does not end");
    }
    return "";
}

std::string symbol_of(const Checked& checked) {
    switch (checked.verdict) {
        case Verdict::passed:
            return green(checked.open_stars.empty() ? "+" : "*");
        case Verdict::to_write:
            return dim(".");
        case Verdict::waiting:
            return yellow("-");
        default:
            return red("x");
    }
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

// Catch2 shows whole numbers in hexadecimal as well: "3210 (0xc8a)".
std::string without_hexadecimal(std::string text) {
    for (auto at = text.find(" (0x"); at != std::string::npos; at = text.find(" (0x", at)) {
        const auto end = text.find_first_not_of("0123456789abcdef", at + 4);
        if (end == std::string::npos || text[end] != ')') break;
        text.erase(at, end + 1 - at);
    }
    return text;
}

// Addresses as "address A", "address B": all that they can tell is which of them are equal. Numbers
// of 32 bits, eight digits, are not addresses.
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

// Numbers with more digits than are meaningful, as "5.31e+303".
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

// Whether the values say what is wrong: not "false", nor "0.0 == 0.0" with digits that are not
// shown, nor "{?} == {?}".
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

std::string describe(const FailedAssertion& failure) {
    // If several messages name expected values, the last counts: the others
    // belong to earlier assertions.
    const auto expects = [](const std::string& message) {
        return message.find("expected ") != std::string::npos;
    };
    const auto& messages = failure.messages;
    const auto last = std::find_if(messages.rbegin(), messages.rend(), expects);
    std::string text;
    for (const std::string& message : messages)
        if (!expects(message) || &message == &*last) text += wrapped(readable(message), "    ");
    if (!failure.expression.empty() && failure.expression != "FAIL" && !is_unknown(failure)) {
        text += wrapped("checked: " + failure.expression, "    ");
        if (says_more(failure)) text += wrapped("actual: " + readable(failure.expanded), "    ");
    }
    if (!failure.exception.empty()) text += wrapped("it threw: " + failure.exception, "    ");
    return text;
}

// The first failure of a test case that has something to show.
std::string describe_all(const TestCase& test) {
    for (const FailedAssertion& failure : test.failures)
        if (const std::string text = describe(failure); !text.empty()) return text;
    return "";
}

// What failed before a program crashed or was stopped.
std::string before_that(const std::string& failing) {
    return failing.empty() ? "" : "\nBefore that, this failed:\n" + failing;
}

// The test cases that fail, those of the core before the stars: the first one with everything that
// is known, the others by name.
std::string failing_cases(const Checked& checked) {
    std::string text, others;
    std::vector<TestCase> tests = checked.tests;
    std::stable_partition(tests.begin(), tests.end(),
                          [](const TestCase& test) { return !test.hard; });
    for (const TestCase& test : tests) {
        if (test.passed || !missing_exercise(test).empty()) continue;
        const bool crashed = !test.ended || !test.crash.empty();
        if (crashed && describe_all(test).empty()) continue;  // the crash is described elsewhere
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
    return checked.warning.empty()
               ? ""
               : "\n  " + yellow("The compiler warned:") + '\n' + wrapped(checked.warning, "    ") +
                     in_plain_words(checked.warning);
}

std::string what_it_looks_like(const Course& course, const Checked& checked) {
    std::string text;
    const Signature signature = signature_of(checked.tests);
    if (signature.where.empty()) return "";
    for (const LookAlikes& alike :
         recognize(signatures_of(course, checked.exercise), checked.exercise.id, signature))
        for (const std::string& name : alike) {
            const Mistake mistake = read_mistake(course, checked.exercise.chapter, name);
            const char* const start = text.empty()            ? "This looks like: "
                                      : name == alike.front() ? "and like: "
                                                              : "or like: ";
            text += "\n  " + yellow(start + mistake.title) + '\n' +
                    wrapped(mistake.explanation, "    ");
        }
    return text;
}

}  // namespace

std::string summary_line(const Checked& checked) {
    return "  " + symbol_of(checked) + ' ' + checked.exercise.id + "  " +
           padded(checked.exercise.title, 36) + ' ' + verdict_text(checked) + '\n';
}

std::string float_lines(const Course& course, std::vector<Checked>& all) {
    if (check_in_float(course, all) == 0) return "";
    std::string lines;
    for (const Checked& checked : all) {
        const auto& open = checked.open_stars;
        if (checked.in_float || std::any_of(open.begin(), open.end(),
                                            [](const OpenStar& star) { return star.in_float; }))
            lines += summary_line(checked);
    }
    return lines;
}

std::string details(const Course& course, const Checked& checked) {
    const Exercise& exercise = checked.exercise;
    if (checked.verdict == Verdict::no_file) return red(checked.trouble) + '\n';
    std::string text = bold(exercise.id + ' ' + exercise.title) + ", " + files_of(exercise) + "\n";
    // The test case in which it crashed or did not end.
    std::string where;
    for (const TestCase& test : checked.tests)
        if (!test.ended || !test.crash.empty()) where = test.name;
    if (!where.empty()) where = " in the test case\n  " + bold(where);
    switch (checked.verdict) {
        case Verdict::not_compiled:
            text += "It does not compile" + std::string{checked.in_float ? " in float" : ""} +
                    ". The first error:\n\n" + checked.trouble + '\n' +
                    in_plain_words(checked.trouble);
            break;
        case Verdict::crashed:
            text += "It crashes" + where + '\n' + wrapped(checked.trouble + '.', "  ") +
                    warned(checked) + "\n  To find the line:  ./course check " + exercise.id +
                    " --sanitize\n" + before_that(failing_cases(checked));
            break;
        case Verdict::endless:
            text += "It was stopped: " + checked.trouble + where +
                    "\n  Which loop or recursion never ends?\n" + warned(checked) +
                    before_that(failing_cases(checked));
            break;
        case Verdict::waiting:
            text += "It calls your code of exercise " + checked.missing + ": write that first.\n";
            break;
        case Verdict::to_write:
            text += "It is still to be written: replace the lines with rt::todo.\n" +
                    (checked.trouble.empty() ? "" : '\n' + wrapped(checked.trouble, "  "));
            break;
        case Verdict::failing:
            if (checked.in_float && checked.warning.empty())
                text +=
                    "\nIt passes in double and fails in float (rt::Real is float): does a constant "
                    "or a tolerance\nfit double only?\n";
            text += '\n' +
                    (checked.trouble.empty() ? failing_cases(checked)
                                             : wrapped(checked.trouble, "  ")) +
                    warned(checked);
            break;
        case Verdict::no_file:
        case Verdict::passed:
            break;
    }
    if (checked.verdict != Verdict::passed) {
        text += what_it_looks_like(course, checked);
        text += "\n  Read " + exercise.section() + ". Stuck? ./course hint " + exercise.id + '\n';
    }
    return text;
}

std::string open_stars(const Course& course, const Checked& checked, bool all) {
    std::string text;
    for (const OpenStar& star : checked.open_stars) {
        text += (text.empty() ? "" : "\n") + yellow("Star: ") + bold(star.test.name) +
                (star.in_float ? ", in float" : "") + '\n';
        if (!star.trouble.empty()) text += wrapped(star.trouble + '.', "    ");
        text += describe_all(star.test);
        if (!all) break;
    }
    if (text.empty()) return "";
    text += what_it_looks_like(course, checked);
    const std::string& id = checked.exercise.id;
    const auto left = static_cast<int>(checked.open_stars.size()) - 1;
    if (!all && left > 0)
        text += "\n  " + std::to_string(left) + " more: ./course check " + id + " --stars\n";
    return text + "\n  Read " + checked.exercise.section() +
           ", now or later. Stuck? ./course hint " + id + '\n';
}

std::string stars_open(int count) {
    return std::to_string(count) + (count == 1 ? " star open" : " stars open");
}

// The electives that are not finished, one line each.
std::string electives_left(const Course& course) {
    const State state = read_state(course);
    std::string text;
    for (const Chapter& chapter : chapters(course)) {
        if (chapter.core || !first_open(course, state, exercises(course, chapter))) continue;
        text += "Beyond the course, an elective: " + bold(chapter.number() + ' ' + chapter.title) +
                ", about " + std::to_string(chapter.minutes) + " minutes\n  read   " +
                chapter.text.string() + "\n  check  ./course watch " + chapter.number() + '\n';
    }
    return text;
}

// The next step when every exercise passes: the chapter of rungs, then the certificate.
std::string step_after_the_exercises(const Course& course) {
    const auto rungs = chapter_of_rungs(course);
    const OwnRecord own = read_state(course).own;
    if (!rungs || own_passes(own))
        return "The last step: ./course certify\n" + electives_left(course);
    const std::string folder = own.folder.empty() ? "FOLDER" : own.folder;
    return "Next: " + bold(rungs->number() + ' ' + rungs->title) + ", about " +
           std::to_string(rungs->minutes) + " minutes\n  read   " + rungs->text.string() + '\n' +
           (own.folder.empty() ? "  begin  ./course own new FOLDER\n" : "") +
           "  check  ./course own judge " + folder + '\n';
}

std::string next_step(const Course& course, const Exercise* next) {
    if (!next)
        return (electives_left(course).empty() ? "Every exercise passes. "
                                               : "Every exercise of the core passes. ") +
               step_after_the_exercises(course);
    if (const std::string trouble = trouble_with_files(course, *next); !trouble.empty())
        return red(trouble) + '\n';
    return "Next: " + bold(next->id + ' ' + next->title) + ", about " +
           std::to_string(next->minutes) + " minutes" +
           (next->star_minutes > 0 ? " (its stars: " + std::to_string(next->star_minutes) + " more)"
                                   : "") +
           "\n  read   " + next->section() + "\n  write  " + files_of(*next) +
           "\n  check  ./course check " + next->id + '\n';
}

std::string chapter_done(const Chapter& chapter, int open_stars) {
    const std::string number = chapter.number();
    return (open_stars == 0
                ? green("Chapter " + number + " is done: every checkpoint passes.")
                : green("Chapter " + number + " is done: its core passes.") + ' ' +
                      yellow(stars_open(open_stars) + ": ./course check " + number + " --stars")) +
           "\n  Look at your picture:          ./course run " + number +
           "\n  Compare it with the solution:  ./course compare " + number +
           "\n  Answer its questions:          ./course ask " + number + '\n';
}

}  // namespace companion
