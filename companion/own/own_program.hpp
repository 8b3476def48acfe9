#pragma once
// A ray tracer of the learner's own, from outside: built by its own command, run as a program.

#include <companion/compare/picture.hpp>
#include <companion/system/process.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace companion {

namespace fs = std::filesystem;

class OwnProgram {
  public:
    // Copies the folder and runs `sh build.sh` with these options for the compiler in the copy,
    // which goes away with this object. Throws app::Failure with the compiler's words.
    OwnProgram(const fs::path& folder, const std::vector<std::string>& options = {});
    // A program that is there already.
    static OwnProgram existing(const fs::path& program) { return OwnProgram{program, Existing{}}; }
    ~OwnProgram();
    OwnProgram(const OwnProgram&) = delete;
    OwnProgram& operator=(const OwnProgram&) = delete;

    struct Drawn {
        Result result;
        Picture picture;    // none where the program failed
        std::string bytes;  // of the file
    };
    // Draws a scene, given as its text. How it ended stands in the result; throws app::Failure only
    // where the file that it wrote is no picture.
    Drawn draw(const std::string& scene, const std::vector<std::string>& options,
               double timeout = 120) const;

  private:
    struct Existing {};
    OwnProgram(fs::path program, Existing);
    fs::path work_;  // for the copy, scenes and pictures
    fs::path program_;
};

}  // namespace companion
