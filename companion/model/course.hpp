#pragma once
// Where the parts of the course are.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace companion {

namespace fs = std::filesystem;

// A copy of the course and its build folder.
struct Course {
    fs::path root;
    fs::path build;
    double patience = 20;  // seconds after which an exercise's checkpoints are stopped

    fs::path program(const std::string& name) const;  // of the build
    fs::path out() const { return root / "out"; }
    // A path relative to the root, with slashes on all systems.
    std::string relative(const fs::path& path) const {
        return path.lexically_relative(root).generic_string();
    }
};

// The copy of the course that this program was built from.
Course this_course();

// A graft, the end of a chapter: what it changes in the learner's own program,
// exercises/tracer/tracer.cpp.
struct Graft {
    std::string title = {};  // "Any scene"
    int minutes = 0;
    std::vector<std::string> headers = {};  // which it must use, such as "nearest_sphere.hpp"
    // The arguments of the program: none; a position of the eye; or a scene file and a picture
    // file.
    enum class Reads { nothing, eye, scene } reads = Reads::scene;
    bool still = false;           // its pictures have no noise
    std::vector<int> steps = {};  // of chapter 09; the program must draw their scenes
};

// A chapter as course.json describes it. Paths are relative to the course. A chapter of exercises
// has hints. A chapter with a task has a scene instead: the learner writes a whole program for it,
// in a separate folder.
struct Chapter {
    std::string name = {};   // "03_sphere"
    std::string title = {};  // "The sphere"
    bool core = true;        // if not, it is an elective
    int reading = 0;         // minutes for the text
    int minutes = 0;         // for the core, including the reading
    int star_minutes = 0;    // for the stars, in addition
    int study_seconds = 1;   // how long its study takes, in both precisions
    fs::path text = {}, hints = {};
    std::string caption = {};  // what its picture shows
    bool uses_real = true;     // whether its exercises use rt::Real and are checked in float, too
    fs::path scene = {};       // the scene that its picture shows, in the build folder

    std::optional<Graft> graft = {};

    std::string needs = {};  // what it cannot be built without, such as "MPI"; empty if nothing

    bool has_exercises() const { return scene.empty(); }
    // Whether the chapter was not built because something that it needs is missing.
    bool is_left_out() const;

    std::string number() const { return name.substr(0, name.find('_')); }  // "03"
    std::string picture() const { return name + ".png"; }
    std::string table() const { return name + ".csv"; }
};

// All chapters in their order.
std::vector<Chapter> every_chapter(const Course& course);

// The chapters of exercises, without those that are left out.
std::vector<Chapter> chapters(const Course& course);

// The chapters of exercises that belong to the core, not the electives.
std::vector<Chapter> core_chapters(const Course& course);

// The chapter with a task; null if the course has none.
std::optional<Chapter> chapter_of_task(const Course& course);

// The chapter of exercises (with `task_too`, of steps as well) that "3", "03", "03_sphere" or
// "sphere" means. Throws app::UsageError, which lists the chapters, or says what the chapter needs.
Chapter find_chapter(const Course& course, const std::string& name, bool task_too = false);

// The folders, relative to the course, in whose rt/ a chapter's given headers are: its own or, if
// there are several kinds of headers, some in it.
std::vector<fs::path> given_folders(const Course& course, const Chapter& chapter);

// Throws app::UsageError if the chapter is left out, and says what it needs.
void check_is_built(const Chapter& chapter);

}  // namespace companion
