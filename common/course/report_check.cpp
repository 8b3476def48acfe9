#include <algorithm>
#include <course/mistakes.hpp>
#include <course/report_check.hpp>
#include <course/terminal.hpp>
#include <sstream>

namespace course {
namespace {

// A string that fills this many columns.
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

std::string verdict_text(const Checked& checked) {
    const int all = static_cast<int>(checked.tests.size()), passed = passed_cases(checked);
    switch (checked.verdict) {
        case Verdict::passed:
            return green("done");
        case Verdict::failing:
            return red("failing: " + std::to_string(all - passed) + " of " + cases(all));
        case Verdict::to_write:
            return all == 0 ? dim("to be written")
                            : yellow("begun: " + std::to_string(passed) + " of " + cases(all) +
                                     " pass, the rest is to be written");
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

std::string symbol_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::passed:
            return green("+");
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
    std::istringstream in{text};
    std::string kept, line;
    for (int i = 0; i < count && std::getline(in, line); ++i) kept += line + '\n';
    if (std::getline(in, line)) kept += "...\n";
    return kept;
}

std::string describe(const FailedAssertion& failure) {
    std::string text;
    if (!failure.messages.empty()) text += wrapped(failure.messages, "    ");
    if (!failure.expression.empty() && failure.expression != "FAIL") {
        text += wrapped("checked: " + failure.expression, "    ");
        const bool says_more = failure.expanded != "false" && !failure.expanded.empty() &&
                               failure.expression.find(failure.expanded) == std::string::npos;
        if (says_more) text += wrapped("came as: " + failure.expanded, "    ");
    }
    if (!failure.exception.empty()) text += wrapped("it threw: " + failure.exception, "    ");
    return text;
}

// The test cases that fail: the first with all that is known, the others by name.
std::string failing_cases(const Checked& checked) {
    std::string text, others;
    for (const TestCase& test : checked.tests) {
        if (test.passed || !missing_exercise(test).empty()) continue;
        if (!text.empty()) {
            others += "    " + test.name + '\n';
            continue;
        }
        text += "  " + bold(test.name) + '\n';
        if (!test.failures.empty()) text += describe(test.failures.front());
        if (!test.output.empty())
            text += "    your code printed:\n" + wrapped(first_lines(test.output, 10), "      ");
    }
    if (!others.empty()) text += "\n  Also failing:\n" + others;
    return text;
}

std::string what_it_looks_like(const Course& course, const Checked& checked) {
    std::string text;
    for (const LookAlikes& alike : checked.mistakes)
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
    return "  " + symbol_of(checked.verdict) + ' ' + checked.exercise.id + "  " +
           padded(checked.exercise.title, 36) + ' ' + verdict_text(checked) + '\n';
}

std::string details(const Course& course, const Checked& checked) {
    const Exercise& exercise = checked.exercise;
    std::string text = bold(exercise.id + ' ' + exercise.title) + ", " + files_of(exercise) + "\n";
    // The test case in which it crashed or did not end.
    std::string where;
    for (const TestCase& test : checked.tests)
        if (!test.ended || !test.crash.empty()) where = test.name;
    if (!where.empty()) where = " in the test case\n  " + bold(where);
    switch (checked.verdict) {
        case Verdict::not_compiled:
            text += "It does not compile. The first error:\n\n" + checked.trouble + '\n';
            break;
        case Verdict::crashed:
            text += "It crashes (" + checked.trouble + ")" + where +
                    "\n  An index out of range, a pointer to nothing, or a function that calls "
                    "itself for ever?\n";
            break;
        case Verdict::endless:
            text += "It was stopped, " + checked.trouble + "," + where +
                    "\n  Which loop or recursion never ends?\n";
            break;
        case Verdict::waiting:
            text +=
                "It calls what exercise " + checked.missing + " asks for: write that one first.\n";
            break;
        case Verdict::to_write:
            text += "It is still to be written: replace the lines that say rt::todo.\n";
            break;
        case Verdict::failing:
            text += '\n' + failing_cases(checked);
            break;
        case Verdict::passed:
            break;
    }
    if (checked.verdict != Verdict::passed) {
        text += what_it_looks_like(course, checked);
        text += "\n  Read " + exercise.section() + ". Stuck? ./course hint " + exercise.id + '\n';
    }
    return text;
}

std::string next_step(const Course&, const Exercise* next) {
    if (!next) return "All exercises are done. The last step: ./course certify\n";
    return "Next: " + bold(next->id + ' ' + next->title) + ", about " +
           std::to_string(next->minutes) + " minutes\n  read   " + next->section() + "\n  write  " +
           files_of(*next) + "\n  check  ./course check " + next->id + '\n';
}

std::string chapter_done(const Chapter& chapter) {
    const std::string number = chapter.number();
    return green("Chapter " + number + " is done: every checkpoint passes.") +
           "\n  Look at your picture:          ./course run " + number +
           "\n  Compare it with the solution:  ./course compare " + number + '\n';
}

}  // namespace course
