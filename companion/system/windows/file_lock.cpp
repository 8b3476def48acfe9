#include <windows.h>

#include <app/errors.hpp>
#include <companion/system/file_lock.hpp>
#include <companion/system/windows/wide.hpp>

namespace companion {

FileLock::FileLock(const std::filesystem::path& path, Hold hold,
                   const std::function<bool()>& waits) {
    const HANDLE file = ::CreateFileW(path.c_str(), GENERIC_READ | GENERIC_WRITE,
                                      FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                                      nullptr, OPEN_ALWAYS, FILE_ATTRIBUTE_NORMAL, nullptr);
    if (file == INVALID_HANDLE_VALUE)
        throw app::Failure("cannot write " + path.string() + ": " + last_error());
    OVERLAPPED from_start{};
    file_ = reinterpret_cast<std::intptr_t>(file);
    const DWORD kind = hold == Hold::alone ? LOCKFILE_EXCLUSIVE_LOCK : 0;
    if (::LockFileEx(file, kind | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &from_start)) return;
    is_held_ = waits();
    if (is_held_) ::LockFileEx(file, kind, 0, 1, 0, &from_start);
}

FileLock::~FileLock() {
    ::CloseHandle(reinterpret_cast<HANDLE>(file_));
}

}  // namespace companion
