#include <app/errors.hpp>
#include <companion/model/course_file.hpp>
#include <companion/model/route.hpp>

#include "catch.hpp"
#include "temporary_folder.hpp"

using checkpoint::TemporaryFolder;
using checkpoint::write_file;
using companion::Chapter;

TEST_CASE("a chapter's name tells where its parts are", "[course]") {
    const Chapter chapter{"04_normals_aa"};
    CHECK(chapter.number() == "04");
    CHECK(chapter.picture() == "04_normals_aa.png");
    CHECK(chapter.table() == "04_normals_aa.csv");
}

namespace {

const std::string exercise =
    R"({"id": "01.1", "title": "Dot", "minutes": 10, "star_minutes": 3, "files": ["rt/dot.hpp", "rt/b.cpp"]})";

std::string chapter_with(const std::string& exercises) {
    return R"({"chapters": [{"name": "01_vectors", "core": true, "uses_real": true, "title": "Vectors", "reading": 5,
        "text": "docs/01-vectors.md", "hints": "docs/hints/01.md", "caption": "Balls.",
        "exercises": )" +
           exercises + "}]}";
}

// What is wrong with a course.json of this text.
std::string refusal(const std::string& text) {
    const TemporaryFolder folder;
    write_file(folder / "course.json", text);
    try {
        companion::read_course_file({folder.path(), folder.path()});
    } catch (const app::UsageError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("the chapters and exercises are those of course.json", "[course]") {
    const TemporaryFolder folder;
    const companion::Course here{folder.path(), folder / "build"};
    CHECK_THROWS_AS(companion::chapters(here), app::Failure);
    write_file(folder / "course.json", chapter_with('[' + exercise + ']'));
    const auto all = companion::chapters(here);
    REQUIRE(all.size() == 1);
    CHECK(all[0].name == "01_vectors");
    CHECK(all[0].title == "Vectors");
    CHECK(all[0].core);
    CHECK(all[0].uses_real);
    CHECK(all[0].reading == 5);
    CHECK(all[0].hints == "docs/hints/01.md");
    CHECK(all[0].caption == "Balls.");
    const auto exercises = companion::read_course_file(here).exercises;
    REQUIRE(exercises.size() == 1);
    CHECK(exercises[0].id == "01.1");
    CHECK(exercises[0].title == "Dot");
    CHECK(exercises[0].minutes == 10);
    CHECK(exercises[0].star_minutes == 3);
    CHECK(exercises[0].chapter.minutes == 15);
    CHECK(exercises[0].chapter.star_minutes == 3);
    CHECK(exercises[0].section() == "docs/01-vectors.md, section 01.1");
    CHECK(exercises[0].files == std::vector<companion::fs::path>{"exercises/01_vectors/rt/dot.hpp",
                                                                 "exercises/01_vectors/rt/b.cpp"});
}

TEST_CASE("the route has each exercise of the core and each graft once", "[course]") {
    const auto with_route = [](const std::string& route) {
        std::string text = chapter_with('[' + exercise + ']');
        text.insert(1, "\"route\": " + route + ", ");
        return refusal(text);
    };
    CHECK(with_route(R"(["01.1"])").empty());
    CHECK(with_route(R"(["01.2"])").find("must be an exercise of the core or a graft") !=
          std::string::npos);
    CHECK(with_route(R"(["01.1", "01.1"])").find("each of them once") != std::string::npos);
    CHECK(with_route(R"(["graft 01"])").find("must be an exercise") != std::string::npos);
    CHECK(with_route("[]").find("1 or more steps") != std::string::npos);
}

TEST_CASE("the next step is the first open one after the last that was done", "[course]") {
    const companion::Course here = companion::this_course();
    const std::vector<companion::Step> steps = companion::route(here);
    REQUIRE(steps.size() > 8);
    CHECK(steps[0].id() == "00.1");
    companion::State state;
    for (const companion::Step& step : steps)
        if (!step.exercise) {
            CHECK(companion::is_open(here, state, step));
            state.grafts[step.chapter.number()] = 1;
            CHECK_FALSE(companion::is_open(here, state, step));
        }
    CHECK(state.grafts.size() == 8);
}

TEST_CASE("a wrong course.json is refused with the place and what would be right", "[course]") {
    CHECK(refusal("") == "course.json is empty; expected a JSON object { ... }");
    CHECK(refusal("{\n 1}").rfind("course.json:2:2: ", 0) == 0);
    CHECK(refusal("{}") == "course.json: the top level needs \"chapters\"");
    CHECK(
        refusal("[]") ==
        "course.json: the top level must be an object { ... } with \"chapters\", not a list of 0");
    CHECK(refusal(chapter_with("[]")) ==
          "course.json: chapters[0].exercises must be a list [ ... ] of 1 or more exercises, not a "
          "list of 0");
    const auto with = [](const std::string& was, const std::string& is) {
        std::string wrong = exercise;
        wrong.replace(wrong.find(was), was.size(), is);
        return refusal(chapter_with('[' + wrong + ']'));
    };
    const std::string exercise_0 = "course.json: chapters[0].exercises[0]",
                      place = exercise_0 + '.';
    CHECK(with("\"id\"", "\"ID\"") == exercise_0 + " needs \"id\"");
    CHECK(with("01.1", "02.1") == place + "id must begin with 01.");
    CHECK(with("10", "1001") == place + "minutes must be a whole number from 0 to 1000, not 1001");
    CHECK(with("10", "1.5") == place + "minutes must be a whole number from 0 to 1000, not 1.5");
    CHECK(with(": 3", ": -1") ==
          place + "star_minutes must be a whole number from 0 to 1000, not -1");
    CHECK(with("\"Dot\"", "7") == place + "title must be a text in quotes, not 7");
    CHECK(with("\"Dot\"", "\"\"") == place + "title must be a text in quotes, not \"\"");
    CHECK(with("\"rt/b.cpp\"", "1") == place + "files[1] must be a text in quotes, not 1");
}

TEST_CASE("a chapter is found by whatever a person calls it", "[course]") {
    const companion::Course here = companion::this_course();
    for (const char* const name : {"2", "02", "02_camera", "camera"})
        CHECK(companion::find_chapter(here, name).name == "02_camera");
    CHECK(companion::find_chapter(here, "normals_aa").name == "04_normals_aa");
    for (const char* const name : {"", "99", "x", "2_camera", "../02_camera"})
        CHECK_THROWS_AS(companion::find_chapter(here, name), app::UsageError);
    // The chapter with a task has a command of its own.
    for (const char* const name : {"9", "09", "own"}) {
        std::string refusal;
        try {
            companion::find_chapter(here, name);
        } catch (const app::UsageError& error) {
            refusal = error.what();
        }
        CHECK(refusal.find("./course own judge") != std::string::npos);
    }
}

TEST_CASE("a chapter with a task has minutes and a scene in place of exercises", "[course]") {
    const companion::Course here = companion::this_course();
    const auto task = companion::chapter_of_task(here);
    REQUIRE(task);
    CHECK(task->name == "09_own");
    CHECK(task->minutes > 0);
    CHECK(companion::find_chapter(here, "09", true).name == task->name);
    CHECK(companion::fs::exists(here.build / task->scene));
    std::size_t without = 0;  // exercises; or left out, because what they need is missing
    for (const Chapter& chapter : companion::every_chapter(here))
        without += chapter.name == task->name || chapter.is_left_out();
    CHECK(companion::every_chapter(here).size() == companion::chapters(here).size() + without);
    for (const Chapter& chapter : companion::chapters(here)) CHECK(chapter.has_exercises());
}
