#include <algorithm>
#include <app/errors.hpp>
#include <companion/dev/new_exercise.hpp>
#include <companion/dev/parts.hpp>
#include <companion/system/process.hpp>

#include "catch.hpp"
#include "temporary_folder.hpp"

using namespace companion;
using checkpoint::read_file, checkpoint::TemporaryFolder, checkpoint::write_file;

namespace {

// A course of one exercise, which has none of its parts.
class Small {
  public:
    Small() {
        fs::create_directories(folder_ / "companion/dev");
        fs::copy_file(this_course().root / "companion/dev/exercise.txt",
                      folder_ / "companion/dev/exercise.txt");
        fs::copy_file(this_course().root / ".clang-format", folder_ / ".clang-format");
        write_file(
            folder_ / "course.json",
            R"({"chapters": [{"name": "01_tiny", "core": true, "uses_real": true, "title": "Tiny",
    "reading": 5, "text": "docs/01.md", "hints": "docs/hints/01.md", "caption": "Nothing.",
    "exercises": [
      {"id": "01.1", "title": "One", "minutes": 5, "files": ["rt/one.hpp"]}
    ]}]}
)");
        write_file(
            folder_ / "docs/01.md",
            "# Tiny\n\n### 01.1 One (about 5 minutes)\n\n```sh\n# no heading\n```\n\n## After\n");
        write_file(folder_ / "docs/hints/01.md", "# Hints\n\n## 01.1\n\n1. a\n2. b\n3. c\n");
    }

    Course course() const { return {folder_.path(), folder_ / "build"}; }
    fs::path path(const std::string& file) const { return folder_ / file; }
    std::string text(const fs::path& file) const { return read_file(folder_ / file); }
    void replace(const std::string& file, const std::string& what, const std::string& with) {
        std::string all = text(file);
        REQUIRE(all.find(what) != std::string::npos);
        all.replace(all.find(what), what.size(), with);
        write_file(folder_ / file, all);
    }
    // What is wrong with 01.2, but for the marks.
    std::vector<std::string> wrong() const {
        auto lines = wrong_parts(course(), find_exercise(course(), "01.2"));
        std::erase_if(lines, [](const std::string& line) {
            return line.find(" is still UNWRITTEN") != std::string::npos;
        });
        return lines;
    }

  private:
    TemporaryFolder folder_;
};

bool has(const std::vector<std::string>& lines, const std::string& part) {
    return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
        return line.find(part) != std::string::npos;
    });
}

const std::string stub = "exercises/01_tiny/rt/two.hpp",
                  mistakes = "tests/mistakes/01_tiny/01.2.md";

}  // namespace

TEST_CASE("a new exercise has all of its parts, some of them to be written", "[dev]") {
    Small small;
    const auto made = begin_exercise(small.course(), "01.2", "two");
    CHECK(made.size() == 7);
    CHECK(small.text("course.json").find("[\"rt/one.hpp\"]},\n      {\"id\": \"01.2\", ") !=
          std::string::npos);
    CHECK(small.text("docs/01.md").find("# no heading\n```\n\n### 01.2 UNWRITTEN") !=
          std::string::npos);
    CHECK(small.text("docs/01.md").find("\n\n## After\n") != std::string::npos);
    CHECK(small.text("docs/hints/01.md").find("3. c\n\n## 01.2\n\n1. UNWRITTEN") !=
          std::string::npos);
    for (const fs::path& file : made)
        for (const char* const placeholder : {"NN", "NAME", "\n== "}) {
            INFO(file << " has " << placeholder);
            CHECK(small.text(file).find(placeholder) == std::string::npos);
        }
    CHECK(small.wrong() ==
          std::vector<std::string>{mistakes + " needs at least three known mistakes, but has 1"});
    const auto all = wrong_parts(small.course(), find_exercise(small.course(), "01.2"));
    for (const fs::path& file : made)
        if (small.text(file).find(unwritten) != std::string::npos)
            CHECK(has(all, file.generic_string() + ':'));
    CHECK(has(all, "docs/01.md:9 is still UNWRITTEN"));
}

TEST_CASE("each chapter can have another exercise", "[dev]") {
    const Course here = this_course();
    for (const Chapter& chapter : chapters(here)) {
        const TemporaryFolder folder;
        const Course copy{folder.path(), folder / "build"};
        for (const fs::path& file :
             {fs::path{".clang-format"}, fs::path{"course.json"},
              fs::path{"companion/dev/exercise.txt"}, chapter.text, chapter.hints})
            write_file(folder.path() / file, read_file(here.root / file));
        const auto last = exercises(here, chapter).back();
        const std::string id = chapter.number() + '.' + std::to_string(last.id.back() - '0' + 1);
        INFO(id);
        begin_exercise(copy, id, "newest");
        const auto wrong = wrong_parts(copy, find_exercise(copy, id));
        CHECK(std::all_of(wrong.begin(), wrong.end(), [](const std::string& line) {
            return line.find("UNWRITTEN") != std::string::npos ||
                   line.find("known mistakes") != std::string::npos;
        }));
    }
}

TEST_CASE("a new exercise changes nothing where its number or its name is taken", "[dev]") {
    Small small;
    for (const char* const id : {"01.1", "01.3", "02.1", "1.2", "01", "x", ""})
        CHECK_THROWS_AS(begin_exercise(small.course(), id, "two"), app::UsageError);
    for (const char* const name :
         {"", "Two", "2", "a b", "a/b", "two.hpp", "two__", "alignas", "new", "xor", "xor_eq"})
        CHECK_THROWS_AS(begin_exercise(small.course(), "01.2", name), app::UsageError);
    write_file(small.path("common/rt/vec3.hpp"), "");
    CHECK_THROWS_AS(begin_exercise(small.course(), "01.2", "vec3"), app::UsageError);
    write_file(small.path(mistakes), "mine");
    CHECK_THROWS_AS(begin_exercise(small.course(), "01.2", "two"), app::UsageError);
    CHECK(small.text(mistakes) == "mine");
    CHECK_FALSE(fs::exists(small.path(stub)));
}

TEST_CASE("what is wrong with an exercise is said, with what would be right", "[dev]") {
    Small small;
    begin_exercise(small.course(), "01.2", "two");
    small.replace(stub, "two(Real x)", "two(int  x)");
    if (is_installed("clang-format"))
        CHECK(has(small.wrong(), stub + ":10 is not formatted; run: clang-format -i " + stub));
    small.replace(stub, "two(int  x)", "two(int x)");
    CHECK(has(small.wrong(),
              stub + " has 'Real two(int x)', which solutions/01_tiny/rt/two.hpp has not"));
    small.replace(stub, "return rt::todo(\"01.2\", x)", "return x");
    CHECK(has(small.wrong(), stub + " calls no rt::todo(\"01.2\")"));
    small.replace(stub, "Exercise 01.2.", "Two.");
    CHECK(has(small.wrong(), "its comment begins with 'Exercise 01.2'"));
    small.replace(stub, "Star: ", "");
    CHECK(has(small.wrong(), stub + " has no line that begins with '// Star:'"));
    small.replace("docs/hints/01.md", "3. UNWRITTEN", "x. UNWRITTEN");
    CHECK(has(small.wrong(), "docs/hints/01.md has 2 hints below '## 01.2': three are needed"));
    small.replace("docs/01.md", "(about 10", "(about 20");
    CHECK(has(small.wrong(), "should say 10 minutes"));
    small.replace("docs/01.md", "### 01.2", "### 1.2");
    CHECK(has(small.wrong(), "docs/01.md needs a section '### 01.2 TITLE (about N minutes)'"));
    small.replace(mistakes, "    return x;", "    return y;");
    CHECK(has(small.wrong(), mistakes + ":11: these lines are not in "));
    small.replace(mistakes, "title: ", "titel: ");
    CHECK(has(small.wrong(), mistakes + ":4: 'titel' is not a known key"));
    for (const std::string& file : {stub, mistakes, std::string{"tests/01_tiny/01.2_two.cpp"}})
        fs::remove(small.path(file));
    const auto missing = missing_files(small.course(), find_exercise(small.course(), "01.2"));
    CHECK(missing.size() == 3);
    CHECK(has(missing, "tests/01_tiny/01.2_NAME.cpp is missing: its test cases"));
}
