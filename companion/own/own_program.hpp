#pragma once
// A ray tracer of the learner's own, seen from outside: built by its own command, run as a program.

#include <atomic>
#include <companion/compare/picture.hpp>
#include <companion/system/process.hpp>
#include <companion/system/scratch_folder.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace companion {

namespace fs = std::filesystem;

// The largest file that such a program may write, in bytes.
inline constexpr std::size_t most_picture = std::size_t{64} << 20;

// How a program is called to draw a scene.
struct HowCalled {
    bool options_first = false;  // before the names of the files
    Output output = Output::captured;
};

class OwnProgram {
  public:
    // Copies the folder's sources and runs `sh build.sh` in the copy, with these options for the
    // compiler. The copy is removed when this object is destroyed. Throws app::Failure with the
    // compiler's message.
    OwnProgram(const fs::path& folder, const std::vector<std::string>& options = {});
    // A program that already exists.
    struct Existing {};
    OwnProgram(Existing, const fs::path& program);

    struct Drawn {
        Result result;
        Picture picture;    // none if the program failed
        std::string bytes;  // of the picture's file
    };
    // Draws a scene, given as its text. If `mesh` is not empty, it is the text of the file
    // shape.obj beside the scene. The result says how the program ended. Throws app::Failure only
    // if the program succeeded but wrote no picture.
    Drawn draw(const std::string& scene, const std::vector<std::string>& options,
               const std::string& mesh = {}, const HowCalled& how = {}) const;
    // The same for a scene that the program must be able to draw: throws app::Failure if it cannot.
    Drawn picture(const std::string& scene, const std::vector<std::string>& options,
                  const std::string& mesh = {}, const HowCalled& how = {}) const;
    // Calls the program with any arguments, in an empty folder. It may not start other processes,
    // nor write a file larger than 64 MB.
    Result call(const std::vector<std::string>& words, Output output = Output::captured) const;

    double patience = 60;                             // seconds that a call may take
    std::vector<std::string> before{};                // words before its name on the command line
    bool may_start_others = false;                    // as sanitizers do
    const fs::path& folder() const { return work_; }  // in which it runs
    int times_out() const { return times_out_; }      // how often a call did not end

  private:
    ScratchFolder scratch_;  // for the copy, the scenes and the pictures
    fs::path work_;          // the folder's path
    fs::path program_;
    mutable std::atomic<int> times_out_ = 0;
};

}  // namespace companion
