#include <algorithm>
#include <app/errors.hpp>
#include <companion/model/exercise.hpp>
#include <companion/model/stubs.hpp>
#include <set>

#include "catch.hpp"

using namespace companion;

TEST_CASE("stubs survive the way into a text and back", "[exercises]") {
    const Stubs stubs{{"rt/a.hpp", "#pragma once\n\nint a;\n"}, {"rt/b.hpp", ""}};
    CHECK(stubs_from_text(to_text(stubs)) == stubs);
    CHECK(stubs_from_text("").empty());
    CHECK_THROWS_AS(stubs_from_text("no name\n"), app::Failure);
}

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
        INFO("exercise " << exercise.id << "; the target shipped_stubs keeps the stubs");
        CHECK(seen.insert(exercise.id).second);
        CHECK(exercise.minutes > 0);
        CHECK_FALSE(exercise.title.empty());
        CHECK_FALSE(exercise.files.empty());
        CHECK(exercise.shipped_todos >= 1);
        const Stubs stubs = shipped_stubs(here, exercise.chapter);
        std::vector<fs::path> files;  // that say todo("NN.k")
        for (const auto& [file, source] : stubs)
            if (count_todos(source, exercise.id) > 0)
                files.push_back(fs::path{"exercises"} / exercise.chapter.name / file);
        CHECK((exercise.files == files));
        CHECK(exercise.chapter.hours > 0);
    }
    CHECK(find_exercise(here, "1.1").id == "01.1");
    for (const char* const name : {"", "1", "01", "01.99", "99.1", "x", ".", "01.1 "})
        CHECK_THROWS_AS(find_exercise(here, name), app::UsageError);
}

// Only where nobody has written into the exercises.
TEST_CASE("the stubs that are kept are those that are shipped", "[stubs]") {
    const Course here = this_course();
    for (const Chapter& chapter : chapters(here)) {
        INFO(chapter.name << ": cmake --build build --target shipped_stubs");
        CHECK((shipped_stubs(here, chapter) == present_stubs(here, chapter)));
    }
}
