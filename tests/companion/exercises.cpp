#include <algorithm>
#include <app/errors.hpp>
#include <cmath>
#include <companion/model/exercise.hpp>
#include <companion/model/source.hpp>
#include <companion/model/stubs.hpp>
#include <companion/system/files.hpp>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "temporary_folder.hpp"

using namespace companion;
using checkpoint::TemporaryFolder, checkpoint::write_file;

TEST_CASE("a todo counts where it is code and of this exercise", "[exercises]") {
    CHECK(count_todos("return rt::todo(\"01.1\", a);", "01.1") == 1);
    CHECK(count_todos("return todo (\n  \"01.1\");", "01.1") == 1);
    CHECK(count_todos("rt::todo(\"01.1\"); rt::todo(\"01.1\");", "01.1") == 2);
    CHECK(count_todos("return rt::todo(\"01.12\", a);", "01.1") == 0);
    const std::string functions = R"(namespace rt {
inline Real length(Vec3 v) {
    if (v.x > 0) { return rt::todo("01.3", v); }
    return rt::todo("01.3", v);
}
class Canvas {
    Canvas(int width, int height) : w{width} { rt::todo("01.3"); }
    Pixel& at(int x, int y) { return rt::todo("01.4"); }
    ~Canvas() { rt::todo("01.3"); }
};)";
    using Names = std::vector<std::string>;
    CHECK(functions_to_write(functions, "01.3") == Names{"length", "Canvas", "~Canvas"});
    CHECK(functions_to_write(functions, "01.4") == Names{"at"});
    CHECK(functions_to_write(functions, "01.5").empty());
    CHECK(count_todos("// return rt::todo(\"01.1\", a);\nreturn 1;", "01.1") == 0);
    CHECK(count_todos("/* rt::todo(\"01.1\") */", "01.1") == 0);
    CHECK(count_todos("\"// \" rt::todo(\"01.1\")", "01.1") == 1);
    CHECK(count_todos("/* open", "01.1") == 0);
    CHECK(count_todos("todo", "01.1") == 0);
    CHECK(count_todos("rt::todo(\"01.1\"); rt::todo(\"01.2\", a);") == 2);
}

TEST_CASE("every function to write has a name", "[exercises]") {
    const Course here = this_course();
    for (const Exercise& exercise : exercises(here)) {
        const auto names = functions_left(here, exercise);
        std::string all;
        for (const std::string& name : names) all += name + ", ";
        INFO(exercise.id + ": " + all);
        CHECK(std::count(names.begin(), names.end(), "") == 0);
    }
}

TEST_CASE("every exercise has minutes and stubs that say so", "[exercises]") {
    const Course here = this_course();
    std::set<std::string> seen;
    for (const Exercise& exercise : exercises(here)) {
        INFO("exercise " << exercise.id);
        CHECK(seen.insert(exercise.id).second);
        CHECK(exercise.minutes >= 0);
        CHECK(exercise.star_minutes > 0);
        CHECK_FALSE(exercise.title.empty());
        CHECK_FALSE(exercise.files.empty());
    }
    CHECK(find_exercise(here, "1.2").id == "01.2");
    for (const fs::path& folder : {fs::path{}, here.root, fs::path{"docs/.."}})
        CHECK(find_exercise(here, folder / "exercises/01_vectors/rt/dot.hpp").id == "01.2");
    for (const char* const name :
         {"", "1", "01", "01.99", "99.1", "x", ".", "01.1 ", "exercises/none.hpp"})
        CHECK_THROWS_AS(find_exercise(here, name), app::UsageError);
}

namespace {

// Formulas on lines of their own, or within a line where they say that things are equal or how they
// compare; a single symbol within a line is read like a word.
struct Reading {
    int words = 0, formulas = 0, figures = 0;

    double minutes() const { return words / 130.0 + formulas / 2.0 + figures / 2.0; }
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

}  // namespace

TEST_CASE("reading is counted in words, formulas and figures", "[exercises]") {
    const Reading some = reading_of(
        "Two <!-- no --> words, $x$ and $a = b$.\n$$c$$\n<details>\na star\n</details>"
        "\n$$\nd\n+ e\n$$\nend $5\n![](a.svg)");
    CHECK(some.words == 8);
    CHECK(some.formulas == 3);
    CHECK(some.figures == 1);
}

TEST_CASE("the minutes for reading are those of the text", "[exercises]") {
    const Course here = this_course();
    for (const Chapter& chapter : every_chapter(here)) {
        const double counted = reading_of(read_file(here.root / chapter.text)).minutes();
        INFO(chapter.name << ": reading should be " << 5 * std::lround(counted / 5)
                          << " minutes in course.json");
        // Rounding to 5 minutes, and 10 percent.
        CHECK(std::abs(chapter.reading - counted) <= 2.5 + 0.1 * counted);
    }
}

// Eight minutes to read the stub, think and mend what a failed check shows, and one and a half for
// each line of the answer that the stub does not have. Some lines are easy, so the sum counts.
TEST_CASE("the minutes for writing are those of the answers", "[stubs]") {
    const Course here = this_course();
    double stated = 0, counted = 0;
    for (const Exercise& exercise : exercises(here)) {
        if (!exercise.chapter.core || exercise.is_star()) continue;
        stated += exercise.minutes;
        counted += 8;
        for (const fs::path& stub : exercise.files)
            counted += 1.5 * lines_to_write(read_file(here.root / stub),
                                            read_file(here.root / "solutions" /
                                                      stub.lexically_relative("exercises")));
    }
    INFO(stated << " minutes in course.json, " << counted << " by the lines");
    CHECK(std::abs(stated - counted) <= 0.1 * counted);
}

TEST_CASE("the core of the course takes at most 35 hours", "[exercises]") {
    int minutes = 0;
    for (const Chapter& chapter : every_chapter(this_course()))
        if (chapter.core) minutes += chapter.minutes;
    INFO(minutes << " minutes");
    CHECK(minutes <= 35 * 60);
}

// Only where nobody has written into the exercises.
TEST_CASE("every exercise has the stubs that say its number", "[stubs]") {
    const Course here = this_course();
    for (const Exercise& exercise : exercises(here)) {
        std::vector<fs::path> files;  // that say todo("NN.k")
        for (const fs::path& path : source_files(here.root / "exercises" / exercise.chapter.name))
            if (count_todos(read_file(path), exercise.id) > 0)
                files.push_back(path.lexically_relative(here.root));
        INFO("exercise " << exercise.id);
        CHECK((exercise.files == files));
    }
}

TEST_CASE("a stub is kept until it is written over", "[exercises]") {
    const TemporaryFolder folder;
    const Course course{folder.path(), folder / "build"};
    write_file(folder / "course.json", R"({"chapters": [{"name": "01_tiny", "core": true,
        "uses_real": true, "title": "Tiny", "reading": 30, "text": "docs/01-tiny.md",
        "hints": "docs/hints/01-tiny.md", "caption": "A ball.", "exercises": [
        {"id": "01.1", "title": "One", "minutes": 10, "files": ["rt/one.hpp"]}]}]})");
    const fs::path file = "exercises/01_tiny/rt/one.hpp";
    const auto becomes = [&](const std::string& text) {
        write_file(folder / file, text);
        keep_stubs(course);
        return shipped_stub(course, file);
    };
    const std::string stub = "rt::todo(\"01.1\"); rt::todo(\"01.1\");\n";
    CHECK(becomes("done\n").empty());
    CHECK(becomes(stub) == stub);
    CHECK_FALSE(is_begun(course, find_exercise(course, "01.1")));
    CHECK(becomes("half done: rt::todo(\"01.1\");\n") == stub);
    CHECK(is_begun(course, find_exercise(course, "01.1")));
    CHECK(becomes("done\n") == stub);
    CHECK(becomes("// a note of the learner's\n" + stub) == stub);
    CHECK(becomes(stub + stub) == stub + stub);
    fs::remove(folder / file);
    keep_stubs(course);
    CHECK(shipped_stub(course, file) == stub + stub);
}
