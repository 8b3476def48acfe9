#include <app/errors.hpp>
#include <companion/model/mistakes.hpp>
#include <companion/model/source.hpp>
#include <companion/system/files.hpp>
#include <temporary_folder.hpp>

#include "catch.hpp"

using namespace companion;

namespace {

const std::string solution = "int f() {\n    return 1;\n}\nint g() {\n    return 1;\n}\n";

const std::string edit = "```diff rt/f.hpp\n-int f() {\n+int f(int) {\n```\n";

const std::string keys = "title: takes a number\ncaught by: 01.1 f takes nothing\n";

std::string with_heading(const std::string& mistake) {
    return "# Mistakes of 01.1\n\n## 01.1_takes\n" + mistake;
}

// The mistakes of a file with this text, and its folder, which has the solution too.
struct Written {
    explicit Written(const std::string& text) {
        checkpoint::write_file(folder / "rt/f.hpp", solution);
        checkpoint::write_file(folder / "01.1.md", text);
    }
    std::vector<Mistake> read() const { return read_mistakes(folder / "01.1.md"); }
    std::map<std::string, std::string> edited() const {
        return edited_files(read().at(0), folder.path());
    }

    checkpoint::TemporaryFolder folder;
};

// What is said of a mistake, without the folder's name.
std::string error(const std::string& text) {
    const Written written{text};
    try {
        written.edited();
    } catch (const app::Failure& failure) {
        std::string words = failure.what();
        const std::string folder = written.folder.path().generic_string() + '/';
        for (auto at = words.find(folder); at != std::string::npos; at = words.find(folder))
            words.erase(at, folder.size());
        return words;
    }
    return "no error";
}

std::string error_of_edit(const std::string& replaced, const std::string& in = "rt/f.hpp") {
    return error(with_heading(keys + "\nWords.\n\n```diff " + in + '\n' + replaced + "```\n"));
}

}  // namespace

TEST_CASE("a mistake has words for the learner and edits of the solution", "[mistakes]") {
    const Written written{with_heading(keys + "changes picture: yes\n\nIt takes\na number.\n\n" +
                                       edit + "\n## 01.1_other\n" + keys + "\nWords.\n\n" + edit)};
    const auto mistakes = written.read();
    REQUIRE(mistakes.size() == 2);
    CHECK(mistakes[0].name == "01.1_takes");
    CHECK(mistakes[0].title == "takes a number");
    CHECK(mistakes[0].caught_by == "01.1 f takes nothing");
    CHECK(mistakes[0].explanation == "It takes a number.");
    CHECK(mistakes[0].remarks == std::map<std::string, std::string>{{"changes picture", "yes"}});
    CHECK(mistakes[1].name == "01.1_other");
    CHECK(mistakes[1].remarks.empty());
    const auto files = written.edited();
    REQUIRE(files.size() == 1);
    CHECK(files.at("rt/f.hpp") == "int f(int) {\n    return 1;\n}\nint g() {\n    return 1;\n}\n");
}

TEST_CASE("an edit starts from what the one before has made", "[mistakes]") {
    const Written written{with_heading(
        keys + "\nWords.\n\n" + edit +
        "\n```diff rt/f.hpp\n int f(int) {\n-    return 1;\n@@\n }\n+\n int g() {\n```\n")};
    CHECK(written.edited().at("rt/f.hpp") == "int f(int) {\n}\n\nint g() {\n    return 1;\n}\n");
}

TEST_CASE("an edit that does not match exactly once is an error", "[mistakes]") {
    CHECK(error_of_edit("-int f() {\n") == "no error");
    CHECK(
        error_of_edit("-    return 1;\n") ==
        "01.1.md:10: these lines appear 2 times in rt/f.hpp; add a line before or after that tells "
        "them apart");
    const std::string never =
        "01.1.md:10: these lines are not in rt/f.hpp; copy whole lines from there exactly, as "
        "they are after the earlier edits";
    CHECK(error_of_edit("-    return 2;\n") == never);
    CHECK(error_of_edit("-f() {\n") == never);  // not a whole line
    CHECK(error_of_edit("-int f() {\n", "rt/g.hpp") == "01.1.md:10: there is no rt/g.hpp");
    CHECK(error_of_edit("") == "01.1.md:10: expected lines to replace, actual: none");
    CHECK(error_of_edit(" int f() {\n") == "01.1.md:10: this edit changes nothing");
}

TEST_CASE("what is wrong with a mistake is said with file and line", "[mistakes]") {
    const std::string words = "\nWords.\n\n";
    CHECK(error(with_heading("title: x\n" + words + edit)) ==
          "01.1.md:5: 01.1_takes needs a line 'caught by: ...' here");
    CHECK(error(with_heading("caught by: x\n" + words + edit)) ==
          "01.1.md:5: 01.1_takes needs a line 'title: ...' here");
    CHECK(error(with_heading("titel: x\n" + keys + words + edit)) ==
          "01.1.md:4: 'titel' is not a known key; see companion/model/mistakes.cpp");
    CHECK(error(with_heading(keys + "title: y\n" + words + edit)) ==
          "01.1.md:6: 'title' appears twice");
    CHECK(error(with_heading(keys + "Words.\n\n" + edit)) ==
          "01.1.md:6: expected 'key: value' or an empty line, actual: 'Words.'");
    CHECK(error(with_heading(keys + "\n" + edit)) ==
          "01.1.md:7: 01.1_takes needs words for the learner here");
    CHECK(error(with_heading(keys + words)) ==
          "01.1.md:8: 01.1_takes needs an edit here: '```diff rt/file.hpp'");
    CHECK(error(with_heading(keys + words + "```cpp\n")) ==
          "01.1.md:9: expected '```diff rt/file.hpp', actual: '```cpp'");
    CHECK(error(with_heading(keys + words + "```diff rt/f.hpp\n-int f() {\n")) ==
          "01.1.md:10: expected the line '```', actual: the end of the file");
    CHECK(error(with_heading(keys + words + "```diff rt/f.hpp\nint f() {\n")) ==
          "01.1.md:10: expected a line that begins with ' ', '-' or '+', actual: 'int f() {'");
    CHECK(error("# Mistakes of 01.1\n\n## 01.2_takes\n" + keys + words + edit) ==
          "01.1.md:3: expected a heading '## 01.1_name', actual: '## 01.2_takes'");
    CHECK(error("# Mistakes\n") ==
          "01.1.md:1: expected the line '# Mistakes of 01.1', actual: '# Mistakes'");
    CHECK(error(with_heading(keys + words + edit + "\n## 01.1_takes\n" + keys + words + edit)) ==
          "01.1.md:14: another mistake is called 01.1_takes; each needs a name of its own");
    CHECK(error(with_heading(keys + "changes picture: no\n" + words + edit)) ==
          "01.1.md:6: expected 'changes picture: yes' or no such line, actual: 'changes picture: "
          "no'");
    CHECK(error(with_heading(keys + "edits: stub\n" + words + edit)) ==
          "01.1.md:6: expected 'edits: plain answer' or no such line, actual: 'edits: stub'");
}

TEST_CASE("a mistake is made from the solution or from the plain answer", "[mistakes]") {
    const Written written{with_heading(keys + "\nWords.\n\n" + edit + "\n## 01.1_plain\n" + keys +
                                       "edits: plain answer\n\nWords.\n\n" + edit)};
    const fs::path root = written.folder.path();
    checkpoint::write_file(root / "solutions/01_x/rt/f.hpp", solution);
    checkpoint::write_file(root / "tests/plain/01_x/rt/f.hpp", "int f() {\n}\n");
    const auto made = [&](std::size_t i) {
        return edited_files({root, root}, "01_x", written.read().at(i)).at("rt/f.hpp");
    };
    CHECK(made(0) == written.edited().at("rt/f.hpp"));
    CHECK(made(1) == "int f(int) {\n}\n");
}

TEST_CASE("a mistake in code that the answer does not have is no guess", "[mistakes]") {
    Mistake mistake;
    CHECK(may_be(mistake, ""));
    mistake.remarks["only if the answer has"] = "shadow|light";
    CHECK(may_be(mistake, "bool shadow = false;"));
    CHECK_FALSE(may_be(mistake, "double t = hit(sphere, eye, direction);"));
    mistake.remarks["unless the answer has"] = "to_light";
    CHECK(may_be(mistake, "bool shadow = false;"));
    CHECK_FALSE(may_be(mistake, "bool shadow = hits(to_light);"));
}

TEST_CASE("each mistake may be in the answer that contains it", "[mistakes]") {
    const Course course = this_course();
    for (const Chapter& chapter : chapters(course))
        for (const Mistake& mistake : read_mistakes(course, chapter)) {
            if (chapter.number() == "09") continue;  // a program of its own
            INFO(mistake.name);
            std::string code;
            for (const auto& [file, text] : edited_files(course, chapter.name, mistake))
                code += code_of(text);
            CHECK(may_be(mistake, code));
        }
}

TEST_CASE("a mistake is no guess where its test case passes or its step is not reached",
          "[mistakes]") {
    Mistake mistake;
    mistake.caught_by = "01.1 two";
    CHECK_FALSE(is_refuted(mistake, {"01.1 one", "01.1 two"}, {"01.1 three"}));
    CHECK_FALSE(is_refuted(mistake, {"01.1 one"}, {"01.1 three"}));  // a crash came before it
    CHECK(is_refuted(mistake, {"01.1 one"}, {"01.1 two"}));
    mistake.caught_by = "00.1 step 3 light";
    CHECK(is_refuted(mistake, {"00.1 step 2 disk", "00.1 step 3 light"}, {"00.1 step 1 sky"}));
    CHECK_FALSE(is_refuted(mistake, {"00.1 step 3 light", "00.1 step 4 ground"}, {}));
    CHECK_FALSE(is_refuted(mistake, {"00.1 all", "00.1 step 3 light"}, {}));
}
