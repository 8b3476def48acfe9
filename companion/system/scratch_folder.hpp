#pragma once
#include <sys/types.h>

#include <filesystem>
#include <string>

namespace companion {

// A new folder for files that nobody needs later, in the system's folder for such files. It is
// removed with this object, and also if the program ends in any other way: a process waits for
// that.
class ScratchFolder {
  public:
    // Throws app::Failure if it cannot be made.
    explicit ScratchFolder(const std::string& name);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    pid_t remover_ = -1;
    int pipe_ = -1;  // whose end the remover waits for
};

}  // namespace companion
