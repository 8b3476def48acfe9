#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>
#include <windows.h>

#include <algorithm>
#include <app/cores.hpp>
#include <app/platform.hpp>
#include <app/signals.hpp>
#include <app/windows/held.hpp>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

namespace app {

namespace fs = std::filesystem;

// SIGBREAK is the signal of Ctrl-Break, and of closing the window.
const std::initializer_list<int> ending_signals{SIGINT, SIGTERM, SIGBREAK};

namespace {

constexpr int aborted = 134;  // the code that other systems' shells report

extern "C" void end_aborted(int) {
    std::_Exit(aborted);  // abort() itself ends with 3
}

// A crash ends the program with the exception's own code, even if the C library would use another
// one.
LONG CALLBACK end_at_crash(EXCEPTION_POINTERS* what) {
    const DWORD code = what->ExceptionRecord->ExceptionCode;
    switch (code) {
        case EXCEPTION_ACCESS_VIOLATION:
        case EXCEPTION_STACK_OVERFLOW:
        case EXCEPTION_INT_DIVIDE_BY_ZERO:
        case EXCEPTION_ILLEGAL_INSTRUCTION:
            ::TerminateProcess(::GetCurrentProcess(), code);
    }
    return EXCEPTION_CONTINUE_SEARCH;
}

bool is_console(HANDLE handle) {
    DWORD mode = 0;
    return ::GetConsoleMode(handle, &mode) != 0;
}

// The terminal windows of MSYS2 and Git are not consoles. In them, a program's output goes to a
// pipe with a name such as \msys-dd50a72ab4668b33-pty0-to-master.
bool is_pipe_of_terminal(HANDLE handle) {
    if (::GetFileType(handle) != FILE_TYPE_PIPE) return false;
    union {
        FILE_NAME_INFO info;
        wchar_t room[sizeof(FILE_NAME_INFO) / sizeof(wchar_t) + MAX_PATH];
    } name{};
    if (!::GetFileInformationByHandleEx(handle, FileNameInfo, &name, sizeof name)) return false;
    const std::wstring_view text{name.info.FileName, name.info.FileNameLength / sizeof(wchar_t)};
    return (text.rfind(L"\\msys-", 0) == 0 || text.rfind(L"\\cygwin-", 0) == 0) &&
           text.find(L"-pty") != text.npos;
}

}  // namespace

void prepare_process() {
    ::SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX | SEM_NOOPENFILEERRORBOX);
    ::AddVectoredExceptionHandler(1, end_at_crash);
    std::signal(SIGABRT, end_aborted);
    for (std::FILE* const file : {stdout, stderr}) ::_setmode(::_fileno(file), _O_BINARY);
    const HANDLE out = ::GetStdHandle(STD_OUTPUT_HANDLE);
    DWORD mode = 0;
    if (!::GetConsoleMode(out, &mode)) return;
    static const UINT before = ::GetConsoleOutputCP();  // which other programs may need later
    std::atexit([] { ::SetConsoleOutputCP(before); });
    ::SetConsoleOutputCP(CP_UTF8);
    // Makes the console understand the codes for colors and for writing over a line.
    ::SetConsoleMode(out, mode | ENABLE_PROCESSED_OUTPUT | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

void end_by(int signal) {
    std::_Exit(128 + signal);  // raise() would end it with 3
}

SignalHandler handler_of(int signal) {
    // The handler can be read only by setting another one.
    const SignalHandler now = std::signal(signal, SIG_IGN);
    std::signal(signal, now);
    return now;
}

std::FILE* open_for_reading(const fs::path& path) {
    std::FILE* file = nullptr;
    until_released([&] {
        file = ::_wfopen(path.c_str(), L"rb");
        return file || errno != EACCES || !fs::is_regular_file(path);
    });
    return file;
}

std::FILE* open_for_writing(const fs::path& path, bool only_new) {
    const int descriptor = ::_wopen(
        path.c_str(),
        _O_WRONLY | _O_CREAT | _O_TRUNC | _O_BINARY | _O_NOINHERIT | (only_new ? _O_EXCL : 0),
        _S_IREAD | _S_IWRITE);
    return descriptor < 0 ? nullptr : ::_fdopen(descriptor, "wb");
}

void rename_over(const fs::path& from, const fs::path& to) {
    DWORD error = 0;
    until_released([&] {
        const bool is_renamed = ::MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING);
        error = is_renamed ? 0 : ::GetLastError();
        return !is_held(error) || fs::is_directory(to);
    });
    if (error != 0)
        throw fs::filesystem_error(
            "cannot rename", from, to,
            std::error_code{static_cast<int>(error), std::system_category()});
}

void remove_now(const wchar_t* path) {
    ::DeleteFileW(path);
}

bool is_writable(const fs::path& path) {
    constexpr int to_write = 2;
    return ::_waccess(path.c_str(), to_write) == 0;
}

bool is_terminal(std::FILE* file) {
    const auto handle = reinterpret_cast<HANDLE>(::_get_osfhandle(::_fileno(file)));
    return handle != INVALID_HANDLE_VALUE && (is_console(handle) || is_pipe_of_terminal(handle));
}

int physical_cores() {
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    DWORD size = 0;
    ::GetLogicalProcessorInformationEx(RelationProcessorCore, nullptr, &size);
    std::vector<std::byte> records(size);  // one for each core, of various lengths
    const auto record = [&](DWORD at) {
        return reinterpret_cast<SYSTEM_LOGICAL_PROCESSOR_INFORMATION_EX*>(records.data() + at);
    };
    int cores = 0;
    if (size > 0 && ::GetLogicalProcessorInformationEx(RelationProcessorCore, record(0), &size))
        for (DWORD at = 0; at < size; at += record(at)->Size) ++cores;
    return cores == 0 ? threads : std::min(threads, cores);
}

}  // namespace app
