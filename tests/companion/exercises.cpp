#include <algorithm>
#include <app/errors.hpp>
#include <atomic>
#include <companion/model/exercise.hpp>
#include <companion/model/source.hpp>
#include <companion/model/stubs.hpp>
#include <companion/system/files.hpp>
#include <set>
#include <thread>

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
        CHECK(find_exercise(here, (folder / "exercises/01_vectors/rt/dot.hpp").string()).id ==
              "01.2");
    for (const char* const name :
         {"", "1", "01", "01.99", "99.1", "x", ".", "01.1 ", "exercises/none.hpp"})
        CHECK_THROWS_AS(find_exercise(here, name), app::UsageError);
}

TEST_CASE("a file may go, and come back, while it is read", "[exercises]") {
    const TemporaryFolder folder;
    const fs::path file = folder / "one.hpp";
    CHECK(text_if_there(file).empty());
    const std::string text = "one\n";
    std::atomic<bool> ends{false};
    std::thread editor{[&] {
        while (!ends) {
            write_file(file, text);
            fs::remove(file);
        }
    }};
    bool is_right = true;
    for (int i = 0; i < 20'000 && is_right; ++i)
        CHECK_NOTHROW(is_right = text.rfind(text_if_there(file), 0) == 0);
    CHECK(is_right);
    ends = true;
    editor.join();
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
