#include "own_process.hpp"

#include <windows.h>

#include <app/windows/processor_time.hpp>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>
#include <vector>

#include "catch.hpp"
#include "processor_time.hpp"
#if __has_include(<catch2/interfaces/catch_interfaces_capture.hpp>)
#include <catch2/interfaces/catch_interfaces_capture.hpp>
#endif

namespace checkpoint {
namespace {

struct Limits {
    double seconds, computing;  // of wall time and of processor time
    std::size_t output;         // bytes
};

struct Ended {
    std::string output;
    bool started = false, waited = false, computed = false, printed = false;  // too long, too much
    DWORD code = 0;
};

// Runs a command within limits, without input, and takes what it prints to its standard output.
Ended run(std::string command, const Limits& limits) {
    Ended ended;
    SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
    HANDLE from = nullptr, into = nullptr;
    if (!::CreatePipe(&from, &into, &inherited, 0)) return ended;
    ::SetHandleInformation(from, HANDLE_FLAG_INHERIT, 0);
    const HANDLE nothing =
        ::CreateFileW(L"NUL", GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE,
                      &inherited, OPEN_EXISTING, 0, nullptr);
    STARTUPINFOA start{};
    start.cb = sizeof start;
    start.dwFlags = STARTF_USESTDHANDLES;
    start.hStdInput = start.hStdError = nothing;
    start.hStdOutput = into;
    PROCESS_INFORMATION made{};
    ended.started = ::CreateProcessA(nullptr, command.data(), nullptr, nullptr, TRUE, 0, nullptr,
                                     nullptr, &start, &made);
    ::CloseHandle(into);
    ::CloseHandle(nothing);
    if (!ended.started) {
        ::CloseHandle(from);
        return ended;
    }
    std::atomic<bool> too_much = false;
    std::thread reader{[&] {
        char bytes[1 << 16];
        for (DWORD count = 0;
             !too_much && ::ReadFile(from, bytes, sizeof bytes, &count, nullptr) && count > 0;) {
            ended.output.append(bytes, count);
            too_much = ended.output.size() > limits.output;
        }
    }};
    const auto begin = std::chrono::steady_clock::now();
    while (::WaitForSingleObject(made.hProcess, 20) != WAIT_OBJECT_0) {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
        ended.waited = passed.count() > limits.seconds;
        ended.computed =
            app::processor_seconds(::GetProcessTimes, made.hProcess) > limits.computing;
        if (ended.waited || ended.computed || too_much) {
            ::TerminateProcess(made.hProcess, 1);
            break;
        }
    }
    ::WaitForSingleObject(made.hProcess, INFINITE);
    ::GetExitCodeProcess(made.hProcess, &ended.code);
    reader.join();
    ended.printed = too_much;
    for (const HANDLE handle : {from, made.hProcess, made.hThread}) ::CloseHandle(handle);
    return ended;
}

constexpr char separator = '\x1f', mark = '\x1e';
constexpr const char* results_name = "COURSE_OWN_PROCESS";

// There is no fork: the test program is started once more with the same test case, in which all
// earlier calls return what they returned here. In this variable it finds these results.
const std::vector<std::string>* results_from_parent() {
    static const auto* const results = []() -> const std::vector<std::string>* {
        const char* const text = std::getenv(results_name);
        if (!text) return nullptr;
        static std::vector<std::string> all;
        std::string one;
        for (const char* c = text + 1; *c; ++c) {
            if (*c != separator) {
                one += *c;
                continue;
            }
            all.push_back(one);
            one.clear();
        }
        return &all;
    }();
    return results;
}

// Does the work in a thread with this much stack, tells the parent its result, and ends.
[[noreturn]] void work_for_parent(const std::function<std::string()>& work, std::size_t stack) {
    std::set_terminate([] { ::TerminateProcess(::GetCurrentProcess(), 3); });
    const auto body = [](void* what) -> DWORD {
        std::string result = "an exception";
        try {
            result = (*static_cast<const std::function<std::string()>*>(what))();
        } catch (...) {
        }
        result = mark + result + mark;
        DWORD count = 0;
        ::WriteFile(::GetStdHandle(STD_OUTPUT_HANDLE), result.data(),
                    static_cast<DWORD>(result.size()), &count, nullptr);
        ::TerminateProcess(::GetCurrentProcess(), 0);
        return 0;
    };
    ::CreateThread(nullptr, stack, body, const_cast<std::function<std::string()>*>(&work),
                   STACK_SIZE_PARAM_IS_A_RESERVATION, nullptr);
    for (;;) ::Sleep(INFINITE);
}

}  // namespace

std::string in_own_process(const std::function<std::string()>& work, unsigned seconds,
                           std::size_t stack) {
    static std::string test_case;
    static std::vector<std::string> results;  // of earlier calls in this test case
    const std::string now = Catch::getResultCapture().getCurrentTestName();
    if (now != test_case) results.clear();
    test_case = now;
    if (const auto* const known = results_from_parent()) {
        if (results.size() == known->size()) work_for_parent(work, stack);
        results.push_back((*known)[results.size()]);
        return results.back();
    }
    std::string earlier(1, separator);  // so that the variable is never empty
    for (const std::string& result : results) earlier += result + separator;
    char program[MAX_PATH]{};
    ::GetModuleFileNameA(nullptr, program, sizeof program);
    ::SetEnvironmentVariableA(results_name, earlier.c_str());
    const Ended ended = run('"' + std::string{program} + "\" \"" + test_case + '"',
                            {static_cast<double>(seconds), 1e9, 1 << 20});
    ::SetEnvironmentVariableA(results_name, nullptr);
    const auto begin = ended.output.find(mark), end = ended.output.rfind(mark);
    results.push_back(begin == std::string::npos || begin == end
                          ? "the program ended"
                          : ended.output.substr(begin + 1, end - begin - 1));
    return results.back();
}

bool leave_room_for_few_threads() {
    return false;
}

Printed run_program(const std::string& program) {
    const Ended ended = run('"' + program + ".exe\"", {10, 3, std::size_t{64} << 20});
    Printed printed{ended.output, ""};
    char code[16];
    std::snprintf(code, sizeof code, "%#lx", ended.code);
    if (!ended.started)
        printed.trouble = trouble::not_started;
    else if (ended.printed)
        printed.trouble = trouble::too_much;
    else if (ended.computed)
        printed.trouble = trouble::endless;
    else if (ended.waited)
        printed.trouble = trouble::waits;
    else if (ended.code >= 0xc0000000)
        printed.trouble = trouble::crashed(code);
    return printed;
}

double processor_seconds() {
    return app::processor_seconds(::GetThreadTimes, ::GetCurrentThread());
}

}  // namespace checkpoint
