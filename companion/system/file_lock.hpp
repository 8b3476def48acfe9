#pragma once
#include <cstdint>
#include <filesystem>

namespace companion {

// While a FileLock exists, no other process holds the lock of this file. The file is created if it
// is missing, and is never removed. Throws app::Failure if the file cannot be created.
class FileLock {
  public:
    explicit FileLock(const std::filesystem::path& path);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

  private:
    std::intptr_t file_;  // the system's handle for it
};

}  // namespace companion
