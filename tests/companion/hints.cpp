#include <companion/model/hints.hpp>
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
            const HintParts parts = parts_of(hint);
            INFO("what is for the stars is a paragraph of its own, after what is for the core");
            CHECK((exercise.is_star() || parts.core.size() > 20));
            CHECK(parts.core.find("★") == parts.core.npos);
            // A terminal shows it as it is: no formula needs a translator. Code may have anything.
            std::istringstream lines{hint};
            for (std::string line; std::getline(lines, line);)
                if (line.rfind("    ", 0) != 0) CHECK(line.find_first_of("$\\") == line.npos);
        }
    }
}

TEST_CASE("every graft has three hints", "[hints]") {
    const Course here = this_course();
    for (const Chapter& chapter : chapters(here)) {
        INFO("chapter " << chapter.name);
        CHECK(hints_of_graft(here, chapter).size() == (chapter.graft ? 3 : 0));
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

TEST_CASE("what is for the stars in a hint comes last", "[hints]") {
    const auto parts = [](const char* hint) {
        const HintParts found = parts_of(hint);
        return found.core + '|' + found.star;
    };
    CHECK(parts("a\nb") == "a\nb|");
    CHECK(parts("a\n\n    code;\n\n★ b\n\n    c;") == "a\n\n    code;|★ b\n\n    c;");
    CHECK(parts("★ a") == "|★ a");
}
