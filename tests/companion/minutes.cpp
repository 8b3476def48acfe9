// The model of how long the core takes, and what it says of the course's texts and answers. It is
// stated in docs/hours.md.

#include <algorithm>
#include <cmath>
#include <companion/model/exercise.hpp>
#include <companion/model/route.hpp>
#include <companion/model/source.hpp>
#include <companion/system/files.hpp>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "catch.hpp"

using namespace companion;

namespace {

// The model, in minutes.
constexpr double words_a_minute = 130, a_formula = 0.5, a_figure = 0.5;
constexpr double a_stub = 3, a_compiler = 10, a_failed_check = 5;
constexpr double an_invented_line = 1.5, a_copied_line = 0.6, a_line_again = 1, a_design = 15;
constexpr int lines_a_failed_check = 10, steps_of_the_core = 6;

// Formulas on lines of their own, or within a line where they say that things are equal or how they
// compare; a single symbol within a line is read like a word.
struct Reading {
    int words = 0, formulas = 0, figures = 0;

    double minutes() const {
        return words / words_a_minute + formulas * a_formula + figures * a_figure;
    }
};

// What folds is for the stars.
std::string without_folds(std::string text) {
    for (auto begin = text.find("<details>"); begin != std::string::npos;
         begin = text.find("<details>"))
        text.erase(begin, text.find("</details>", begin) - begin + 10);
    return text;
}

Reading reading_of(const std::string& markdown) {
    Reading found;
    // What is not shown is not read.
    std::istringstream lines{
        std::regex_replace(without_folds(markdown), std::regex{"<!--[^>]*-->"}, "")};
    bool in_formula = false;
    for (std::string line; std::getline(lines, line);) {
        const bool is_mark = line.rfind("$$", 0) == 0;
        if (is_mark && line.find("$$", 2) != std::string::npos) {  // all of it on this line
            ++found.formulas;
            continue;
        }
        if (is_mark || (in_formula && line.find("$$") != std::string::npos)) {
            found.formulas += !in_formula;
            in_formula = !in_formula;
            continue;
        }
        if (in_formula) continue;
        for (auto at = line.find("!["); at != std::string::npos; at = line.find("![", at + 2))
            ++found.figures;
        for (auto open = line.find('$'); open != std::string::npos;
             open = line.find('$', open + 1)) {
            const auto close = line.find('$', open + 1);
            if (close == std::string::npos) break;
            const std::string inner = line.substr(open + 1, close - open - 1);
            for (const char* const relation : {"=", "<", ">", "\\le", "\\ge", "\\approx"})
                if (inner.find(relation) != std::string::npos) {
                    ++found.formulas;
                    break;
                }
            line.replace(open, close + 1 - open, "x");
        }
        std::istringstream words{line};
        for (std::string word; words >> word;) ++found.words;
    }
    return found;
}

// Lines of code of the answer that are not in the stub; braces alone do not count.
int lines_to_write(const std::string& stub, const std::string& answer) {
    const auto lines_of = [](const std::string& source) {
        std::multiset<std::string> lines;
        std::istringstream code{code_of(source, true)};
        for (std::string line; std::getline(code >> std::ws, line);)
            if (line != "}" && line.rfind("#include", 0) != 0) lines.insert(line);
        return lines;
    };
    const auto had = lines_of(stub), has = lines_of(answer);
    std::vector<std::string> written;
    std::set_difference(has.begin(), has.end(), had.begin(), had.end(),
                        std::back_inserter(written));
    return static_cast<int>(written.size());
}

// Lines that blocks of ```diff add.
int lines_typed(const std::string& markdown) {
    int count = 0;
    bool in_block = false;
    std::istringstream lines{markdown};
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("```", 0) == 0) in_block = line == "```diff";
        count += in_block && line.rfind('+', 0) == 0;
    }
    return count;
}

// The README is read before the first chapter.
double read_minutes(const Course& course, const Chapter& chapter) {
    double minutes = reading_of(read_file(course.root / chapter.text)).minutes();
    if (chapter.name == every_chapter(course)[0].name)
        minutes += reading_of(read_file(course.root / "README.md")).minutes();
    return minutes;
}

// One check fails, and one more for each ten lines.
double failed_checks(int lines) {
    return a_failed_check * (1 + lines / lines_a_failed_check);
}

// The plain answer of tests/plain, or ours where it is plain itself.
fs::path core_answer(const Course& course, const fs::path& stub) {
    const fs::path name = stub.lexically_relative("exercises"),
                   plain = course.root / "tests/plain" / name;
    return fs::exists(plain) ? plain : course.root / "solutions" / name;
}

// Where the section of a step ends in its chapter's text.
std::size_t end_of_section(const std::string& text, const Step& step) {
    const auto begin =
        text.find(step.exercise ? "\n### " + step.exercise->id + ' ' : std::string{"\n## Graft"});
    INFO(step.chapter.text << " needs a section of " << step.id());
    REQUIRE(begin != std::string::npos);
    return std::min({text.size(), text.find("\n## ", begin + 1), text.find("\n### ", begin + 1)});
}

// Lines that a text has one type into one's own tracer, with an exercise's idea or after the
// exercise. In chapter 00, they are the exercise.
int lines_for_the_tracer(const Course& course, const Step& step) {
    if (step.chapter.number() == "00") return 0;
    const std::string text = without_folds(read_file(course.root / step.chapter.text));
    // From the end of the exercise before it in the text: the idea belongs to the exercise.
    const std::size_t end = end_of_section(text, step);
    std::size_t begin = 0;
    for (const Step& other : route(course))
        if (other.exercise && other.chapter.name == step.chapter.name)
            if (const std::size_t its = end_of_section(text, other); its < end)
                begin = std::max(begin, its);
    return lines_typed(text.substr(begin, end - begin));
}

double written_minutes(const Course& course, const Step& step) {
    if (!step.exercise) {
        const fs::path answers = course.root / "solutions/tracer";
        const std::string number = step.chapter.number();
        const fs::path before =
            number == "01" ? course.root / "solutions/00_toolchain/first.cpp"
                           : answers / ("0" + std::to_string(std::stoi(number) - 1) + ".cpp");
        const int lines = lines_to_write(read_file(before), read_file(answers / (number + ".cpp")));
        return failed_checks(0) + lines * a_copied_line;
    }
    int lines = 0;
    for (const fs::path& stub : step.exercise->files)
        lines +=
            lines_to_write(read_file(course.root / stub), read_file(core_answer(course, stub)));
    // 00.1 is copied from its text, and has no stub.
    if (step.id() == "00.1") return a_compiler + failed_checks(lines) + lines * a_copied_line;
    const double design = step.id() == "05.6" ? a_design : 0;  // only rules, and no formula
    return a_stub + design + failed_checks(lines) + lines * an_invented_line +
           lines_for_the_tracer(course, step) * a_copied_line;
}

// The chapter with a task: its text, the task, and the whole program once more.
double minutes_of_task(const Course& course, const Chapter& chapter) {
    const auto read = [&](const fs::path& text) {
        return reading_of(read_file(course.root / text)).minutes();
    };
    const int lines =
        lines_to_write("", read_file(course.root / "tests/plain" / chapter.name / "main.cpp"));
    return read(chapter.text) + read("chapters/" + chapter.name + "/start/TASK.md") +
           lines * a_line_again + steps_of_the_core * a_failed_check;
}

// What stands on the way from step to step, in the route's order.
struct Stop {
    Step step;
    double minutes = 0;  // from the course's first line on, with this step
};

// The README is read first. A text is read from its beginning, in parts: up to the end of a step's
// section before that step, and its last part after the chapter's last step.
std::vector<Stop> stops(const Course& course) {
    std::map<std::string, std::size_t> read;  // of each chapter's text, so many bytes
    std::map<std::string, std::string> last_step;
    const std::vector<Step> steps = route(course);
    for (const Step& step : steps) last_step[step.chapter.name] = step.id();
    std::vector<Stop> all;
    double minutes = reading_of(read_file(course.root / "README.md")).minutes();
    for (const Step& step : steps) {
        const std::string text = read_file(course.root / step.chapter.text);
        std::size_t& begin = read[step.chapter.name];
        const std::size_t end = end_of_section(text, step);
        INFO(step.chapter.text << ": the section of " << step.id()
                               << " stands before that of an earlier step of the route");
        CHECK(end > begin);
        minutes += reading_of(text.substr(begin, end - begin)).minutes() +
                   (step.exercise ? step.exercise->minutes : step.chapter.graft->minutes);
        begin = end;
        all.push_back({step, minutes});
        if (step.id() == last_step[step.chapter.name])
            minutes += reading_of(text.substr(end)).minutes();
    }
    return all;
}

}  // namespace

TEST_CASE("reading is counted in words, formulas and figures", "[minutes]") {
    const Reading some = reading_of(
        "Two <!-- no --> words, $x$ and $a = b$.\n$$c$$\n<details>\na star\n</details>"
        "\n$$\nd\n+ e\n$$\nend $5\n![](a.svg)");
    CHECK(some.words == 8);
    CHECK(some.formulas == 3);
    CHECK(some.figures == 1);
}

TEST_CASE("lines to write are those of code that the stub lacks", "[minutes]") {
    CHECK(lines_to_write(
              "#include <a>\nint f() {\n    return todo();\n}\n",
              "#include <b>\nint f() {\n    // a word\n    int a = 1;\n\n    return a;\n}\n") == 2);
    CHECK(lines_to_write("", "a\na\n}\n") == 2);
}

TEST_CASE("lines for the tracer are those that a text adds to it", "[minutes]") {
    CHECK(lines_typed("+1\n```diff\n a\n-b\n+c\n+d\n```\n+ e\n```cpp\n+f\n```\n") == 2);
}

TEST_CASE("the minutes for reading are those of the text", "[minutes]") {
    const Course here = this_course();
    for (const Chapter& chapter : every_chapter(here)) {
        if (!chapter.has_exercises()) continue;
        const double counted = read_minutes(here, chapter);
        INFO(chapter.name << ": reading should be " << 5 * std::lround(counted / 5)
                          << " minutes in course.json");
        // Rounding to 5 minutes, and 10 percent.
        CHECK(std::abs(chapter.reading - counted) <= 2.5 + 0.1 * counted);
    }
}

// What course.json says may be a quarter and five minutes more than the model counts: some lines
// take more thought than others.
TEST_CASE("the minutes for writing are those of the plain answers", "[stubs]") {
    const Course here = this_course();
    for (const Step& step : route(here)) {
        const double counted = written_minutes(here, step);
        const int stated = step.exercise ? step.exercise->minutes : step.chapter.graft->minutes;
        INFO(step.id() << ": " << stated << " minutes in course.json, " << counted
                       << " by the model");
        CHECK(stated >= 0.9 * counted - 2.5);
        CHECK(stated <= 1.25 * counted + 5);
    }
    const auto own = chapter_of_task(here);
    REQUIRE(own);
    const double counted = minutes_of_task(here, *own);
    INFO(own->name << ": " << own->minutes << " minutes in course.json, " << counted
                   << " by the model");
    CHECK(own->minutes >= 0.9 * counted - 2.5);
    CHECK(own->minutes <= 1.25 * counted + 5);
}

TEST_CASE("the core of the course takes at most 35 hours", "[minutes]") {
    const Course here = this_course();
    int stated = 0;
    for (const Chapter& chapter : every_chapter(here))
        if (chapter.core) stated += chapter.minutes;
    INFO(stated << " minutes in course.json");
    CHECK(stated <= 35 * 60);
}

TEST_CASE("the model, too, says at most 35 hours", "[stubs]") {
    const Course here = this_course();
    double counted = 0;
    for (const Chapter& chapter : core_chapters(here)) counted += read_minutes(here, chapter);
    for (const Step& step : route(here)) counted += written_minutes(here, step);
    counted += minutes_of_task(here, *chapter_of_task(here));
    INFO(counted << " minutes by the model");
    CHECK(counted <= 35 * 60);
}

// The graft of 01 draws the picture of 00.1 once more; each one after it draws a new picture.
TEST_CASE("the second picture of one's own comes within five hours and then one a chapter",
          "[minutes]") {
    const Course here = this_course();
    std::vector<std::string> grafts;
    double second = 0;
    for (const Stop& stop : stops(here)) {
        if (stop.step.exercise || stop.step.chapter.graft->reads == Graft::Reads::nothing) continue;
        if (grafts.empty()) second = stop.minutes;
        grafts.push_back(stop.step.chapter.name);
    }
    INFO(second << " minutes");
    CHECK(second > 0);
    CHECK(second <= 300);
    std::vector<std::string> expected;
    for (const Chapter& chapter : core_chapters(here))
        if (chapter.number() >= "02") expected.push_back(chapter.name);
    CHECK(grafts == expected);
}
