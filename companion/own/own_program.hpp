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

class OwnProgram {
  public:
    // Copies the folder's sources and runs `sh build.sh` in the copy with these
    // options for the compiler. The copy is removed with this object. Throws
    // app::Failure with the compiler's words.
    OwnProgram(const fs::path& folder, const std::vector<std::string>& options = {});
    // A program that already exists.
    struct Existing {};
    OwnProgram(Existing, const fs::path& program);

    struct Drawn {
        Result result;
        Picture picture;    // none if the program failed
        std::string bytes;  // of the file
    };
    // Draws a scene, given as its text, with this text in the file shape.obj beside it if it is not
    // empty. The result says how it ended; throws app::Failure only if it succeeded and yet wrote
    // no picture.
    Drawn draw(const std::string& scene, const std::vector<std::string>& options,
               const std::string& mesh = {}) const;
    // The same for a scene that it must draw: throws app::Failure if it does not.
    Drawn picture(const std::string& scene, const std::vector<std::string>& options,
                  const std::string& mesh = {}) const;
    // Calls it with any words. The folder that it runs in is empty. It may start no other process,
    // and write no file larger than 64 MB.
    Result call(const std::vector<std::string>& words) const;

    double patience = 60;                         // seconds that a call may take
    std::vector<std::string> before{};            // its name on the command line
    bool may_start_others = false;                // as sanitizers do
    int times_out() const { return times_out_; }  // how often it did not end

  private:
    ScratchFolder scratch_;  // for the copy, scenes and pictures
    fs::path work_;          // its path
    fs::path program_;
    mutable std::atomic<int> times_out_ = 0;
};

}  // namespace companion
