#pragma once
// Where the parts of the course are.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace companion {

namespace fs = std::filesystem;

// A copy of the course and the folder that it was built in.
struct Course {
    fs::path root;
    fs::path build;
    double patience = 20;  // seconds after which an exercise's checkpoints are stopped

    fs::path program(const std::string& name) const;  // of the build
    fs::path out() const { return root / "out"; }
    // A path from the root, with slashes on all systems.
    std::string relative(const fs::path& path) const {
        return path.lexically_relative(root).generic_string();
    }
};

// The copy of the course that this program was built from.
Course this_course();

// What a chapter's end changes in the learner's own program, exercises/tracer/tracer.cpp.
struct Graft {
    std::string title = {};  // "Any scene"
    int minutes = 0;
    std::vector<std::string> headers = {};  // that it must use, such as "nearest_sphere.hpp"
    // What the program is called with: nothing; a position of the eye; a scene and a picture file.
    enum class Reads { nothing, eye, scene } reads = Reads::scene;
    bool still = false;           // its pictures have no noise
    std::vector<int> rungs = {};  // of chapter 09, whose scenes it must draw
};

// A chapter as course.json describes it. Paths are within the course. A chapter of
// exercises has hints; one of rungs has a scene instead: there the learner writes a whole
// program, in a folder of their own.
struct Chapter {
    std::string name = {};   // "03_sphere"
    std::string title = {};  // "The sphere"
    bool core = true;        // if not, it is an elective
    int reading = 0;         // minutes for the text
    int minutes = 0;         // for the core, with reading
    int star_minutes = 0;    // beyond that
    int study_seconds = 1;   // how long its study takes, in both precisions
    fs::path text = {}, hints = {};
    std::string caption = {};  // what its picture shows
    bool uses_real = true;     // it uses rt::Real, so its exercises are checked in float, too
    fs::path scene = {};       // the scene that its picture shows, in the build folder

    std::optional<Graft> graft = {};

    std::string needs = {};  // what it cannot be built without: "MPI"; empty if nothing

    bool has_exercises() const { return scene.empty(); }
    // What it needs is missing, so that it was not built.
    bool is_left_out() const;

    std::string number() const { return name.substr(0, name.find('_')); }  // "03"
    std::string picture() const { return name + ".png"; }
    std::string table() const { return name + ".csv"; }
};

// All chapters in their order.
std::vector<Chapter> every_chapter(const Course& course);

// The chapters of exercises, without those that are left out.
std::vector<Chapter> chapters(const Course& course);

// Those among them that belong to the 35 hours: no electives.
std::vector<Chapter> core_chapters(const Course& course);

// The chapter of rungs; null if the course has none.
std::optional<Chapter> chapter_of_rungs(const Course& course);

// The chapter of exercises (or of rungs, too) that is meant by "3", "03", "03_sphere" or "sphere".
// Throws app::UsageError, which lists the chapters, or says what the chapter needs.
Chapter find_chapter(const Course& course, const std::string& name, bool rungs_too = false);

// Throws app::UsageError if the chapter is left out, and says what it needs.
void check_is_built(const Chapter& chapter);

}  // namespace companion
