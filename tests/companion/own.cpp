// Judging a ray tracer of the learner's own: what is made up, what is read, what is remembered.
// tests/support/own_mistakes.cpp tests that wrong programs are stopped.

#include <app/errors.hpp>
#include <companion/own/accuracy.hpp>
#include <companion/own/judge.hpp>
#include <companion/own/own_program.hpp>
#include <companion/own/scenes.hpp>
#include <companion/own/standing.hpp>

#include "catch.hpp"
#include "temporary_folder.hpp"

using namespace companion;
using checkpoint::TemporaryFolder;
using checkpoint::write_file;

namespace {

fs::path our_program() {
    return this_course().program("09_own_solution");
}

// The same scene in a picture of a few pixels.
std::string small(const std::string& scene) {
    return scene + "picture 4 3 1 50\n";  // the last picture line counts
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("every scene that is made up is a scene", "[own]") {
    const OwnProgram ours{OwnProgram::Existing{}, our_program()};
    for (const std::uint64_t seed : {1, 2}) {
        std::vector<OwnScene> scenes = hard_scenes(seed);
        for (const TaskStep& step : task_steps(seed))
            scenes.insert(scenes.end(), step.scenes.begin(), step.scenes.end());
        scenes.push_back(shared_corner(seed));
        scenes.push_back(fine_mesh(seed, 64));
        scenes.push_back({"twins", crowd_with_twins(seed, 8, 8), ""});
        scenes.push_back({"accuracy", accuracy_scene(seed), ""});
        scenes.push_back({"some of all", some_of_all(seed), ""});
        for (const OwnScene& scene : scenes) {
            INFO(scene.name << ", seed " << seed);
            const auto drawn = ours.draw(small(scene.text), {}, scene.mesh);
            INFO(drawn.result.output);
            CHECK(drawn.result.ok());
            CHECK(drawn.picture.width == 4);
            CHECK(drawn.picture.height == 3);
        }
    }
}

TEST_CASE("our program refuses what is broken", "[own]") {
    const OwnProgram ours{OwnProgram::Existing{}, our_program()};
    for (const OwnScene& scene : broken_scenes()) {
        INFO(scene.name);
        CHECK(ours.draw(scene.text, {}).result.exit_code == 1);
    }
    for (const OwnScene& scene : broken_meshes()) {
        INFO(scene.name);
        CHECK(ours.draw(scene.text, {}, scene.mesh).result.exit_code == 1);
    }
    for (const Limits& limits : broken_limits())
        for (const std::string& text : limits.scenes) {
            INFO(text);
            CHECK(ours.draw(text, {}).result.exit_code == 1);
        }
    for (const BrokenCall& call : broken_calls()) {
        INFO(call.name);
        CHECK(ours.call(call.words).exit_code == 1);
    }
}

TEST_CASE("the same seed makes the same scenes, another seed makes others", "[own]") {
    const auto text = [](std::uint64_t seed) { return task_steps(seed)[2].scenes[0].text; };
    CHECK(text(5) == text(5));
    CHECK(text(5) != text(6));
    CHECK(task_steps(1).size() == 10);
    CHECK(crowd(1, 8, 8).find("nan") == std::string::npos);
}

TEST_CASE("the page on accuracy is read", "[own]") {
    const auto choices = accuracy_choices(
        "# Title\noption:\ntime:\n\noption: -ffast-math\ntime: 0.9 of it\nerror: 1e-4\n"
        "option: -DSCHLICK\n  time: soon\nerror:\n");
    REQUIRE(choices.size() == 2);
    CHECK(choices[0].option == "-ffast-math");
    CHECK(choices[0].time == 0.9);
    CHECK(choices[0].error == 1e-4);
    CHECK(choices[1].option == "-DSCHLICK");
    CHECK_FALSE(choices[1].time);
    CHECK_FALSE(choices[1].error);
    const Course here = this_course();
    CHECK(accuracy_choices(checkpoint::read_file(here.root / "chapters/09_own/start/accuracy.md"))
              .empty());
    CHECK(accuracy_choices(checkpoint::read_file(here.root / "solutions/09_own/accuracy.md"))
              .size() >= 2);
}

TEST_CASE("files that a compiler or a shell cannot read are named", "[own]") {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& name, const std::string& text) {
        write_file(folder / "build.sh", "true\n");
        write_file(folder / name, text);
        std::string why = "taken";
        try {
            const OwnProgram own{folder.path()};
        } catch (const app::Failure& failure) {
            why = failure.what();
        }
        fs::remove(folder / name);
        return why;
    };
    CHECK(holds(refused("main.cpp", std::string{"\xff\xfei\0n\0t\0", 8}), "main.cpp is in UTF-16"));
    CHECK(holds(refused(".main.cpp", "int main() {}\n"), ".main.cpp is hidden"));
    CHECK(holds(refused("build.sh", "g++ main.cpp -o own\r\n"), "line ends of Windows"));
    CHECK(holds(refused("main.cpp", "int main() {}\n"), "did not make a program"));
}

TEST_CASE("a verdict holds until the sources change", "[own]") {
    const TemporaryFolder folder;
    write_file(folder / "main.cpp", "int main() {}\n");
    write_file(folder / "src/vec3.hpp", "struct Vec3 {};\n");
    const std::string hash = hash_of_own(folder.path());
    const OwnRecord passed{folder.path().string(), hash, 40, 40, 1, true};
    CHECK(own_passes(passed));
    CHECK(own_stars_pass(passed));
    CHECK(standing_of(passed) == "your own ray tracer passes");
    // Pictures, what was built, hidden files and what a tool makes do not count.
    write_file(folder / "one.ppm", "P3\n");
    write_file(folder / "own", "a program");
    write_file(folder / "main.o", std::string("\0\1", 2));
    write_file(folder / ".git/HEAD", "main\n");
    write_file(folder / "build/cache.txt", "x\n");
    CHECK(own_passes(passed));
    CHECK(own_sources(folder.path()) == std::vector<fs::path>{"main.cpp", "src/vec3.hpp"});
    write_file(folder / "src/vec3.hpp", "struct Vec3 { double x; };\n");
    CHECK_FALSE(own_passes(passed));
    CHECK(standing_of(passed) == "changed since it was judged");
    OwnRecord most{folder.path().string(), hash_of_own(folder.path()), 40, 39};
    CHECK(standing_of(most) == "39 of 40 lines pass");
    CHECK_FALSE(own_passes(most));
    most.core = true;
    CHECK(standing_of(most) == "core passes, 39 of 40 lines pass");
    CHECK(own_passes(most));
    CHECK_FALSE(own_stars_pass(most));
    CHECK(standing_of({}) == "not judged yet");
    for (const fs::path& unjudged : {folder.path(), folder / "gone"}) {
        const OwnRecord no_hash{unjudged.string(), "", 40, 40, 1, true};
        CHECK(standing_of(no_hash) == "not judged yet");
        CHECK_FALSE(own_passes(no_hash));
        CHECK_FALSE(own_stars_pass(no_hash));
    }
    CHECK_FALSE(own_passes({(folder / "gone").string(), hash, 40, 40, 1, true}));
}

TEST_CASE("a folder that is not that of one program is not read whole", "[own]") {
    const TemporaryFolder folder;
    write_file(folder / "main.cpp", "int main() {}\n");
    write_file(folder / "picture.exr", std::string((1 << 20) + 1, 'x'));
    CHECK(own_sources(folder.path()) == std::vector<fs::path>{"main.cpp"});
    for (int i = 0; i < 10'000; ++i) write_file(folder / std::to_string(i), "");
    CHECK_THROWS_AS(own_sources(folder.path()), app::Failure);
    CHECK(hash_of_own(folder.path()) == "");
    write_file(folder / "build.sh", "true\n");
    std::vector<JudgedLine> lines;
    judge({folder.path(), our_program()}, [&](const JudgedLine& line) { lines.push_back(line); });
    REQUIRE(lines.size() == 1);
    CHECK(holds(lines[0].actual, "holds too much for one program"));
}

TEST_CASE("the core of chapter 09 is steps 1 to 6", "[own]") {
    const auto is_core_line = [](const char* name) {
        JudgedLine line;
        line.what = name;
        return is_core(line);
    };
    for (const char* name : {"step 1: a sky", "step 6: a glass ball"}) CHECK(is_core_line(name));
    for (const char* name : {"step 7: a lens", "hard: far away", "build.sh", "step 10: more"})
        CHECK_FALSE(is_core_line(name));
}

TEST_CASE("the verdict on the learner's own program is remembered", "[own]") {
    const TemporaryFolder folder;
    const Course course{folder.path(), folder / "build"};
    CHECK(read_state(course).own.lines == 0);
    change_state(course, [](State& state) { state.own = {"/a b", "hash", 40, 39}; });
    const OwnRecord own = read_state(course).own;
    CHECK(own.folder == "/a b");
    CHECK(own.hash == "hash");
    CHECK(own.lines == 40);
    CHECK(own.passed == 39);
}
