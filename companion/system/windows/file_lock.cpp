#include <windows.h>

#include <app/errors.hpp>
#include <companion/system/file_lock.hpp>
#include <companion/system/windows/wide.hpp>

namespace companion {

FileLock::FileLock(const std::filesystem::path& path) {
    const HANDLE file = ::CreateFileW(path.c_str(), GENERIC_READ | GENERIC_WRITE,
                                      FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                                      nullptr, OPEN_ALWAYS, FILE_ATTRIBUTE_NORMAL, nullptr);
    if (file == INVALID_HANDLE_VALUE)
        throw app::Failure("cannot write " + path.string() + ": " + last_error());
    OVERLAPPED from_start{};
    ::LockFileEx(file, LOCKFILE_EXCLUSIVE_LOCK, 0, 1, 0, &from_start);
    file_ = reinterpret_cast<std::intptr_t>(file);
}

FileLock::~FileLock() {
    ::CloseHandle(reinterpret_cast<HANDLE>(file_));
}

}  // namespace companion
