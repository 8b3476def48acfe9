#include <windows.h>

#include <algorithm>
#include <app/platform.hpp>
#include <app/signals.hpp>
#include <app/windows/held.hpp>
#include <app/windows/processor_time.hpp>
#include <atomic>
#include <chrono>
#include <companion/system/process.hpp>
#include <companion/system/terminal.hpp>
#include <companion/system/windows/wide.hpp>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace companion {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// The numbers that Linux gives to signals that this system does not have.
constexpr int too_much_time = 24, not_allowed = 31;

[[noreturn]] void fail(const char* what) {
    throw std::system_error(static_cast<int>(::GetLastError()), std::system_category(), what);
}

// A handle, which is closed when this object is destroyed.
class Handle {
  public:
    Handle() = default;
    explicit Handle(HANDLE value) : value_{value} {}
    Handle(Handle&& other) noexcept : value_{std::exchange(other.value_, nullptr)} {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(value_, other.value_);
        return *this;
    }
    ~Handle() { close(); }
    void close() {
        if (*this) ::CloseHandle(value_);
        value_ = nullptr;
    }
    HANDLE get() const { return value_; }
    HANDLE* address() { return &value_; }
    explicit operator bool() const { return value_ && value_ != INVALID_HANDLE_VALUE; }

  private:
    HANDLE value_ = nullptr;
};

// How many running programs handle Ctrl-C themselves. They are on the same console, so they receive
// it.
std::atomic<int> listening = 0;
std::atomic<int> passed_on = 0;

bool leave_it_to_programs(int signal) {
    if (listening == 0 || (signal != SIGINT && signal != SIGTERM)) return false;
    passed_on = signal;
    return true;
}

// While one of these exists, Ctrl-C does not end the companion.
class Listening {
  public:
    Listening() {
        static const app::OnSignal on_signal{app::ending_signals, leave_it_to_programs};
        ++listening;
    }
    ~Listening() { --listening; }
    Listening(const Listening&) = delete;
    Listening& operator=(const Listening&) = delete;
};

// Appends a word, quoted so that the usual C library reads the same word.
void add_word(std::wstring& line, const std::wstring& word) {
    if (!line.empty()) line += L' ';
    if (!word.empty() && word.find_first_of(L" \t\n\v\"") == word.npos) {
        line += word;
        return;
    }
    line += L'"';
    std::size_t backslashes = 0;  // those before a quotation mark are doubled
    for (const wchar_t c : word) {
        if (c == L'\\') {
            ++backslashes;
        } else {
            if (c == L'"') line.append(backslashes + 1, L'\\');
            backslashes = 0;
        }
        line += c;
    }
    line.append(backslashes, L'\\');
    line += L'"';
}

bool is_file(const fs::path& path) {
    std::error_code none;
    return fs::is_regular_file(path, none);
}

// The file of a program, with .exe added if necessary; empty if there is none.
fs::path with_end(const fs::path& path) {
    if (is_file(path)) return path;
    fs::path longer = path;
    longer += ".exe";
    return is_file(longer) ? longer : fs::path{};
}

fs::path find_in_path(const std::string& name) {
    const wchar_t* const path = ::_wgetenv(L"PATH");
    std::wistringstream folders{path ? path : L""};
    for (std::wstring folder; std::getline(folders, folder, L';');)
        if (const fs::path found = with_end(fs::path{folder} / name);
            !folder.empty() && found.extension() == ".exe")
            return found;
    return {};
}

fs::path find_program(const std::string& name, const fs::path& folder) {
    if (name.find_first_of("/\\") == std::string::npos) return find_in_path(name);
    const fs::path path{name};
    return with_end(fs::absolute(path.has_root_directory() ? path : folder / path));
}

// The environment for a program: this program's, with changes, in the form that the system expects.
std::wstring environment_with(const std::vector<std::string>& changes) {
    const auto less = [](const std::wstring& a, const std::wstring& b) {
        return ::CompareStringOrdinal(a.data(), static_cast<int>(a.size()), b.data(),
                                      static_cast<int>(b.size()), TRUE) == CSTR_LESS_THAN;
    };
    std::map<std::wstring, std::wstring, decltype(less)> all{less};
    const auto add = [&](const std::wstring& variable) {
        const auto equals = variable.find(L'=', 1);  // a drive's variable starts with one
        if (equals != variable.npos) all[variable.substr(0, equals)] = variable.substr(equals + 1);
    };
    wchar_t* const mine = ::GetEnvironmentStringsW();
    for (const wchar_t* one = mine; one && *one; one += std::wcslen(one) + 1) add(one);
    ::FreeEnvironmentStringsW(mine);
    for (const std::string& change : changes) add(wide(change));
    std::wstring block;
    for (const auto& [name, value] : all) block += name + L'=' + value + L'\0';
    return block + L'\0';
}

// A pipe: this program reads from one end, and programs that it starts inherit the other.
struct Pipe {
    Handle from, into;
};

Pipe make_pipe() {
    Pipe pipe;
    SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
    if (!::CreatePipe(pipe.from.address(), pipe.into.address(), &inherited, 0)) fail("pipe");
    ::SetHandleInformation(pipe.from.get(), HANDLE_FLAG_INHERIT, 0);
    return pipe;
}

Handle nothing(DWORD access) {
    SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
    return Handle{::CreateFileW(L"NUL", access, FILE_SHARE_READ | FILE_SHARE_WRITE, &inherited,
                                OPEN_EXISTING, 0, nullptr)};
}

Handle inherited(HANDLE of_this_program) {
    HANDLE copy = nullptr;
    const HANDLE here = ::GetCurrentProcess();
    if (!::DuplicateHandle(here, of_this_program, here, &copy, 0, TRUE, DUPLICATE_SAME_ACCESS))
        return nothing(GENERIC_WRITE);
    return Handle{copy};
}

// The descriptors that a program's C library reads when it starts; descriptor 3 is this pipe.
std::string descriptors(HANDLE events) {
    constexpr unsigned char is_open = 0x01, is_pipe = 0x08;
    const std::int32_t count = 4;
    const unsigned char flags[count]{0, 0, 0, is_open | is_pipe};
    const HANDLE handles[count]{INVALID_HANDLE_VALUE, INVALID_HANDLE_VALUE, INVALID_HANDLE_VALUE,
                                events};
    std::string bytes(sizeof count + sizeof flags + sizeof handles, '\0');
    std::memcpy(bytes.data(), &count, sizeof count);
    std::memcpy(bytes.data() + sizeof count, flags, sizeof flags);
    std::memcpy(bytes.data() + sizeof count + sizeof flags, handles, sizeof handles);
    return bytes;
}

// All that a program starts belongs to the program's job. When the last handle of the job is
// closed, for example because this program was killed, the whole job ends.
class Job {
  public:
    explicit Job(const Run& run)
        : job_{::CreateJobObjectW(nullptr, nullptr)},
          port_{::CreateIoCompletionPort(INVALID_HANDLE_VALUE, nullptr, 0, 1)} {
        if (!job_ || !port_) fail("job");
        JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
        DWORD& which = limits.BasicLimitInformation.LimitFlags;
        which = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE | JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION;
        if (run.most_memory > 0) {
            which |= JOB_OBJECT_LIMIT_PROCESS_MEMORY;
            limits.ProcessMemoryLimit = run.most_memory;
        }
        if (!run.may_start_others) {
            which |= JOB_OBJECT_LIMIT_ACTIVE_PROCESS;
            limits.BasicLimitInformation.ActiveProcessLimit = 1;
        }
        ::SetInformationJobObject(job_.get(), JobObjectExtendedLimitInformation, &limits,
                                  sizeof limits);
        JOBOBJECT_ASSOCIATE_COMPLETION_PORT port{job_.get(), port_.get()};
        ::SetInformationJobObject(job_.get(), JobObjectAssociateCompletionPortInformation, &port,
                                  sizeof port);
    }

    HANDLE get() const { return job_.get(); }

    void end() { ::TerminateJobObject(job_.get(), static_cast<UINT>(STATUS_CONTROL_C_EXIT)); }

    // Whether a program tried to start more processes than it may.
    bool reached_limit() {
        DWORD message = 0;
        ULONG_PTR key = 0;
        OVERLAPPED* about = nullptr;
        while (::GetQueuedCompletionStatus(port_.get(), &message, &key, &about, 0))
            if (message == JOB_OBJECT_MSG_ACTIVE_PROCESS_LIMIT) reached_ = true;
        return reached_;
    }

    double cpu_seconds() const {
        JOBOBJECT_BASIC_ACCOUNTING_INFORMATION used{};
        ::QueryInformationJobObject(job_.get(), JobObjectBasicAccountingInformation, &used,
                                    sizeof used, nullptr);
        return 1e-7 *
               static_cast<double>(used.TotalUserTime.QuadPart + used.TotalKernelTime.QuadPart);
    }

  private:
    Handle job_, port_;
    bool reached_ = false;
};

// Collects what comes out of a pipe, in a thread of its own.
class Reader {
  public:
    Reader(Handle from, std::size_t most, Shown* shown)
        : from_{std::move(from)}, most_{most}, shown_{shown} {
        if (from_) thread_ = std::thread{[this] { read(); }};
    }
    ~Reader() { join(); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    std::size_t size() const { return size_; }

    // All that came, once the other end is closed.
    std::string text() {
        join();
        return std::move(text_);
    }

  private:
    void join() {
        if (thread_.joinable()) thread_.join();
    }
    void read() {
        char bytes[65536];
        for (DWORD count = 0;
             ::ReadFile(from_.get(), bytes, sizeof bytes, &count, nullptr) && count > 0;) {
            if (shown_)
                shown_->add(bytes, count);
            else if (most_ == 0 || text_.size() <= most_)
                text_.append(bytes, count);
            if (!shown_) size_ += count;
        }
    }

    Handle from_;
    std::size_t most_;
    Shown* shown_;
    std::string text_;
    std::atomic<std::size_t> size_ = 0;
    std::thread thread_;
};

// The signal that a crash like this would raise on other systems; 0 if the program ended by itself.
int signal_of(DWORD code) {
    switch (code) {
        case EXCEPTION_ACCESS_VIOLATION:
        case EXCEPTION_STACK_OVERFLOW:
        case EXCEPTION_IN_PAGE_ERROR:
        case EXCEPTION_DATATYPE_MISALIGNMENT:
            return SIGSEGV;
        case EXCEPTION_INT_DIVIDE_BY_ZERO:
        case EXCEPTION_INT_OVERFLOW:
            return SIGFPE;
        case EXCEPTION_ILLEGAL_INSTRUCTION:
        case EXCEPTION_PRIV_INSTRUCTION:
            return SIGILL;
        case 0xc0000374:  // heap corruption
        case 0xc0000409:  // a check of the C library failed
            return SIGABRT;
        case static_cast<DWORD>(STATUS_CONTROL_C_EXIT):
            return SIGINT;
        default:
            return 0;
    }
}

// An attribute for a new process: it inherits these handles and no others. So threads may start
// programs at the same time.
class Attributes {
  public:
    explicit Attributes(std::vector<HANDLE> handles) : handles_{std::move(handles)} {
        SIZE_T size = 0;
        ::InitializeProcThreadAttributeList(nullptr, 1, 0, &size);
        room_.resize(size);
        if (!::InitializeProcThreadAttributeList(list(), 1, 0, &size) ||
            !::UpdateProcThreadAttribute(list(), 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST,
                                         handles_.data(), handles_.size() * sizeof(HANDLE), nullptr,
                                         nullptr))
            fail("process");
    }
    ~Attributes() { ::DeleteProcThreadAttributeList(list()); }
    Attributes(const Attributes&) = delete;
    Attributes& operator=(const Attributes&) = delete;

    LPPROC_THREAD_ATTRIBUTE_LIST list() {
        return reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(room_.data());
    }

  private:
    std::vector<HANDLE> handles_;
    std::string room_;
};

// Asks a test program to say what it was doing: see tests/support/windows. True if the program
// listens for that.
bool ask_to_end(DWORD process) {
    const std::wstring name = L"Local\\course-end-" + std::to_wstring(process);
    const Handle event{::OpenEventW(EVENT_MODIFY_STATE, FALSE, name.c_str())};
    return event && ::SetEvent(event.get());
}

// A program's words, and the variables that stand before them.
struct Command {
    std::vector<std::string> variables, words;
};

Command taken_apart(const std::vector<std::string>& command) {
    if (command[0] != "env") return {{}, command};
    const auto is_variable = [](const std::string& word) { return word.find('=') != word.npos; };
    const auto end = std::find_if_not(command.begin() + 1, command.end(), is_variable);
    return {{command.begin() + 1, end}, {end, command.end()}};
}

// What a program reads and writes.
struct Streams {
    Pipe out, events;
    Handle in, other_out, other_err;  // the others where it is not `out`
};

Streams make_streams(const Run& run, bool is_shown) {
    Streams streams;
    streams.in = nothing(GENERIC_READ);
    if (!is_shown && (run.output == Output::shown || run.output == Output::printable))
        streams.other_out = inherited(::GetStdHandle(STD_OUTPUT_HANDLE));
    else
        streams.out = make_pipe();
    if (run.output == Output::errors_only) streams.other_out = nothing(GENERIC_WRITE);
    if (run.output == Output::errors_hidden)
        streams.other_err = nothing(GENERIC_WRITE);
    else if (run.output != Output::captured && run.output != Output::errors_only)
        streams.other_err = inherited(::GetStdHandle(STD_ERROR_HANDLE));
    if (run.has_events) streams.events = make_pipe();
    return streams;
}

// Why Windows did not start a program, and what can be done about it.
std::string why_not_started() {
    const DWORD error = ::GetLastError();
    std::string words = last_error();
    while (!words.empty() && (words.back() == '\n' || words.back() == '\r')) words.pop_back();
    constexpr DWORD by_integrity_policy = 4551;  // of newer systems
    if (error == ERROR_ACCESS_DISABLED_BY_POLICY || error == by_integrity_policy)
        words +=
            " Windows blocks programs that nobody has signed, such as those that you compile: turn "
            "off Smart App Control (Windows Security, App & browser control), or work in WSL";
    return words;
}

// Starts a program, all of which belongs to the job. An empty handle if that fails; then `why` says
// why.
Handle start(const fs::path& program, const Command& command, const fs::path& folder,
             const Streams& streams, const Job& job, std::string& why) {
    STARTUPINFOEXW how{};
    STARTUPINFOW& info = how.StartupInfo;
    info.cb = sizeof how;
    info.dwFlags = STARTF_USESTDHANDLES;
    info.hStdInput = streams.in.get();
    info.hStdOutput = (streams.other_out ? streams.other_out : streams.out.into).get();
    info.hStdError = (streams.other_err ? streams.other_err : streams.out.into).get();
    std::vector<HANDLE> handles{info.hStdInput, info.hStdOutput};
    if (streams.other_err) handles.push_back(info.hStdError);
    std::string third;
    if (streams.events.into) {
        handles.push_back(streams.events.into.get());
        third = descriptors(streams.events.into.get());
        info.cbReserved2 = static_cast<WORD>(third.size());
        info.lpReserved2 = reinterpret_cast<BYTE*>(third.data());
    }
    Attributes attributes{std::move(handles)};
    how.lpAttributeList = attributes.list();
    std::wstring line, environment = environment_with(command.variables);
    for (const std::string& word : command.words) add_word(line, wide(word));
    PROCESS_INFORMATION made{};
    bool is_started = false;
    app::until_released([&] {       // a virus scanner may hold what has just been compiled
        std::wstring words = line;  // which the call may change
        is_started = ::CreateProcessW(
            program.c_str(), words.data(), nullptr, nullptr, TRUE,
            CREATE_SUSPENDED | CREATE_UNICODE_ENVIRONMENT | EXTENDED_STARTUPINFO_PRESENT |
                (RunsAside::exists() ? BELOW_NORMAL_PRIORITY_CLASS : 0),
            environment.data(), fs::absolute(folder).c_str(), &info, &made);
        return is_started || !app::is_held(::GetLastError());
    });
    if (!is_started) {
        why = why_not_started();
        return {};
    }
    const Handle thread{made.hThread};
    ::AssignProcessToJobObject(job.get(), made.hProcess);
    ::ResumeThread(made.hThread);
    return Handle{made.hProcess};
}

// A running program, and what it prints.
class Child {
  public:
    Child(Handle process, Job& job, Streams streams, const Run& run, bool is_shown)
        : process_{std::move(process)},
          job_{job},
          run_{run},
          is_shown_{is_shown},
          output_{std::move(streams.out.from), run.most_output, is_shown ? &shown_ : nullptr},
          events_{std::move(streams.events.from), run.most_output, nullptr} {}

    // Waits until it ends or goes too far, and ends all that it started.
    Result wait() {
        Result result;
        const bool is_watched = run_.most_output > 0 || run_.most_cpu > 0 || !run_.may_start_others;
        const double until_look = is_watched           ? 20
                                  : EndsRuns::exists() ? 100
                                                       : 1000;  // milliseconds
        double left = until_look;
        do {
            if (run_.timeout > 0) left = 1000 * (run_.timeout - seconds());
        } while (!has_ended(std::clamp(left, 0.0, until_look)) && !goes_too_far(result));
        DWORD code = 0;
        const bool ended = has_ended(0) && ::GetExitCodeProcess(process_.get(), &code);
        job_.end();
        has_ended(INFINITE);
        result.seconds = seconds();
        result.cpu_seconds = std::max(job_.cpu_seconds(), cpu_seconds());
        result.output = output_.text();
        result.events = events_.text();
        if (is_shown_) shown_.end();
        result.started_other = started_other();
        if (result.started_other) result.signal = not_allowed;
        if (result.signal == 0) result.signal = ended ? signal_of(code) : SIGTERM;
        if (result.signal == 0) result.exit_code = static_cast<int>(code);
        return result;
    }

  private:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    double cpu_seconds() const { return app::processor_seconds(::GetProcessTimes, process_.get()); }
    bool started_other() { return !run_.may_start_others && job_.reached_limit(); }

    // Whether the program ends within this many milliseconds.
    bool has_ended(double milliseconds) const {
        return ::WaitForSingleObject(process_.get(), static_cast<DWORD>(milliseconds)) ==
               WAIT_OBJECT_0;
    }

    // Whether it has to be ended, and notes why.
    bool goes_too_far(Result& result) {
        result.timed_out = run_.timeout > 0 && seconds() >= run_.timeout;
        result.too_much =
            run_.most_output > 0 && output_.size() + events_.size() > run_.most_output;
        if (run_.most_cpu > 0 && cpu_seconds() > run_.most_cpu) result.signal = too_much_time;
        const bool ends = result.timed_out || EndsRuns::is_over();
        if (ends && ask_to_end(::GetProcessId(process_.get()))) has_ended(500);
        return ends || result.too_much || result.signal != 0 || started_other();
    }

    Handle process_;
    Job& job_;
    const Run& run_;
    bool is_shown_;
    Shown shown_;
    Reader output_, events_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace

Result run_process(const Run& run) {
    Result not_started;
    not_started.exit_code = 127;
    const Command command = taken_apart(run.command);
    const fs::path program = find_program(command.words[0], run.folder);
    std::error_code none;
    if (program.empty() || !fs::is_directory(run.folder, none)) return not_started;

    const bool is_shown = run.output == Output::printable && app::is_terminal(stdout);
    Streams streams = make_streams(run, is_shown);
    Job job{run};
    std::fflush(nullptr);  // otherwise parts of the output would swap positions
    if (run.passes_signals) passed_on = 0;
    std::optional<Listening> listens;
    if (run.passes_signals) listens.emplace();
    Handle process = start(program, command, run.folder, streams, job, not_started.why_not_started);
    if (!process) return not_started;
    // From here on, these ends are open in the program alone, and what is read ends with it.
    streams.out.into.close();
    streams.events.into.close();
    Result result = Child{std::move(process), job, std::move(streams), run, is_shown}.wait();
    if (run.passes_signals) result.passed_on = passed_on;
    return result;
}

std::size_t memory_of_machine() {
    MEMORYSTATUSEX memory{};
    memory.dwLength = sizeof memory;
    return ::GlobalMemoryStatusEx(&memory) ? static_cast<std::size_t>(memory.ullTotalPhys) : 0;
}

std::string name_of_signal(int signal) {
    switch (signal) {
        case SIGSEGV:
            return "access violation";
        case SIGFPE:
            return "integer division by zero";
        case SIGABRT:
            return "aborted";
        case SIGILL:
            return "illegal instruction";
        case SIGINT:
            return "Ctrl-C";
        case too_much_time:
            return "too much processor time";
        default:
            return "ended from outside";
    }
}

bool is_installed(const std::string& program) {
    return !find_in_path(program).empty();
}

}  // namespace companion
