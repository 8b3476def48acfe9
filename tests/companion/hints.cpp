#include <companion/model/hints.hpp>
#include <companion/pages/plain_text.hpp>
#include <sstream>

#include "catch.hpp"
#include "temporary_folder.hpp"

using namespace companion;

TEST_CASE("every exercise has three hints", "[hints]") {
    const Course here = this_course();
    for (const Exercise& exercise : exercises(here)) {
        INFO("exercise " << exercise.id << " in " << exercise.chapter.hints);
        const auto all = hints(here, exercise);
        CHECK(all.size() == 3);
        for (const std::string& hint : all) {
            CHECK(hint.size() > 20);
            // Nothing of a formula may be left over on a terminal. Code may have anything.
            std::istringstream lines{plain_text(hint)};
            for (std::string line; std::getline(lines, line);)
                if (line.rfind("    ", 0) != 0) CHECK(line.find_first_of("$\\") == line.npos);
        }
    }
}

TEST_CASE("hints are the items of the exercise's own list", "[hints]") {
    const checkpoint::TemporaryFolder folder;
    checkpoint::write_file(folder / "docs/hints/01-x.md",
                           "# H\n\ntext\n\n## 01.1\n\n1. one\n   more\n2. two:\n\n       code;\n"
                           "         deep;\n3. three\n\n## 01.10\n\n1. other\n");
    const Course course{folder.path(), folder / "build"};
    Exercise exercise;
    exercise.chapter = {.name = "01_x", .hints = "docs/hints/01-x.md"};
    exercise.id = "01.1";
    CHECK(hints(course, exercise) ==
          std::vector<std::string>{"one\nmore", "two:\n\n    code;\n      deep;", "three"});
    exercise.id = "01.2";
    CHECK(hints(course, exercise).empty());
}

TEST_CASE("a formula is readable on a terminal", "[hints]") {
    CHECK(plain_text("$\\mathbf a\\cdot\\mathbf b \\le \\sqrt{1 - x}$ of `dot`") ==
          "a·b ≤ √(1 - x) of dot\n");
    CHECK(plain_text("$\\tfrac12$ and $\\frac{a+b}{2}$") == "1/2 and (a+b)/2\n");
    CHECK(plain_text("$\\max(0, \\text{least})$") == "max(0, least)\n");
    CHECK(plain_text("a $ alone\n\n    `code` $x$\n") == "a $ alone\n\n    `code` $x$\n");
    for (const char* const broken : {"$\\", "$\\frac$", "$\\frac{", "${$", "$\\sqrt{a$", "$$"})
        CHECK_NOTHROW(plain_text(broken));
}
