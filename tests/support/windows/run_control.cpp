#include "run_control.hpp"

#include <windows.h>

#include <psapi.h>

#include <algorithm>
#include <app/windows/processor_time.hpp>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <new>
#include <string>

namespace checkpoint {
namespace {

char word[64];
const bool is_taken = [] {
    const char* const name = "COURSE_EVENTS";
    ::GetEnvironmentVariableA(name, word, sizeof word);
    ::SetEnvironmentVariableA(name, nullptr);
    ::_putenv_s(name, "");
    return true;
}();

// Hands the program's operator new to the answer: see answer_memory.cpp.
const bool has_shared_memory = [] {
    HMODULE modules[256];
    DWORD bytes = 0;
    if (!::EnumProcessModules(::GetCurrentProcess(), modules, sizeof modules, &bytes)) return false;
    for (DWORD i = 0; i < std::min<DWORD>(bytes, sizeof modules) / sizeof(HMODULE); ++i)
        if (const auto address = ::GetProcAddress(modules[i], "course_take_memory")) {
            auto& take = *reinterpret_cast<void* (**)(std::size_t)>(
                reinterpret_cast<std::uintptr_t>(address));
            take = [](std::size_t size) { return ::operator new(size); };
        }
    return true;
}();

// What a thread tells that watches the others: their stack may be full.
struct Story {
    const char* signal = nullptr;
    const char* memory = "";
};
Story story;
HANDLE story_is_there = nullptr, story_is_told = nullptr;
Tell tell_crash = nullptr;

// Has it told, and ends the program with this code, even if the telling gets no further: the tested
// code may hold the lock of the memory.
[[noreturn]] void end_with(const char* signal, const char* memory, DWORD code) {
    static std::atomic_flag first = ATOMIC_FLAG_INIT;
    if (first.test_and_set()) ::Sleep(INFINITE);
    story = {signal, memory};
    if (story_is_there) {
        ::SetEvent(story_is_there);
        ::WaitForSingleObject(story_is_told, 1000);
    }
    ::TerminateProcess(::GetCurrentProcess(), code);
    for (;;) ::Sleep(INFINITE);
}

constexpr DWORD aborted = 0xc0000409, ended_from_outside = 0xc000013a;

const char* memory_at(std::uintptr_t address) {
    constexpr std::uintptr_t never_given = 0x10000, around = 1 << 17;
    if (address < never_given) return "null";
    ULONG_PTR low = 0, high = 0;
    ::GetCurrentThreadStackLimits(&low, &high);
    return address + around > low && address < low + around ? "stack" : "";
}

LONG CALLBACK on_exception(EXCEPTION_POINTERS* what) {
    const EXCEPTION_RECORD& record = *what->ExceptionRecord;
    switch (record.ExceptionCode) {
        case EXCEPTION_STACK_OVERFLOW:
            end_with("SIGSEGV", "stack", record.ExceptionCode);
        case EXCEPTION_ACCESS_VIOLATION:
            end_with("SIGSEGV", memory_at(record.ExceptionInformation[1]), record.ExceptionCode);
        case EXCEPTION_INT_DIVIDE_BY_ZERO:
        case EXCEPTION_INT_OVERFLOW:
            end_with("SIGFPE", "", record.ExceptionCode);
        case EXCEPTION_ILLEGAL_INSTRUCTION:
        case EXCEPTION_PRIV_INSTRUCTION:
            end_with("SIGILL", "", record.ExceptionCode);
        default:
            return EXCEPTION_CONTINUE_SEARCH;
    }
}

void on_abort(int) {
    end_with("SIGABRT", "", aborted);
}

DWORD WINAPI tell_story(void*) {
    ::WaitForSingleObject(story_is_there, INFINITE);
    tell_crash(story.signal, story.memory);
    ::SetEvent(story_is_told);
    return 0;
}

// The companion's wish at a time-out: the event has the name of this process.
DWORD WINAPI wait_for_companion(void* event) {
    ::WaitForSingleObject(event, INFINITE);
    end_with("SIGTERM", "", ended_from_outside);
}

void start(LPTHREAD_START_ROUTINE body, void* what) {
    ::CloseHandle(::CreateThread(nullptr, 0, body, what, 0, nullptr));
}

const volatile std::sig_atomic_t* watched = nullptr;
Stuck stuck;

double processor_seconds_of_all() {
    return app::processor_seconds(::GetProcessTimes, ::GetCurrentProcess());
}

DWORD WINAPI look(void*) {
    std::sig_atomic_t seen = *watched;
    double since = processor_seconds_of_all();
    for (;;) {
        ::Sleep(250);
        const double now = processor_seconds_of_all();
        if (*watched != seen) {
            seen = *watched;
            since = now;
        }
        if (now - since <= stuck.seconds) continue;
        write_line(stuck.file, stuck.computes, std::strlen(stuck.computes));
        end_with("SIGTERM", "", ended_from_outside);
    }
}

}  // namespace

const char* secret_word() {
    return word;
}

// Catch2 tells no crash on this system.
void tell_crashes(Tell tell, bool) {
    tell_crash = tell;
    story_is_there = ::CreateEventW(nullptr, FALSE, FALSE, nullptr);
    story_is_told = ::CreateEventW(nullptr, FALSE, FALSE, nullptr);
    start(tell_story, nullptr);
    const std::wstring name = L"Local\\course-end-" + std::to_wstring(::GetCurrentProcessId());
    if (const HANDLE wish = ::CreateEventW(nullptr, FALSE, FALSE, name.c_str()))
        start(wait_for_companion, wish);
    ULONG room = 1 << 15;  // for the handler, on a stack that is full
    ::SetThreadStackGuarantee(&room);
    ::SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);
    ::AddVectoredExceptionHandler(1, on_exception);
    std::signal(SIGABRT, on_abort);
}

void end_when_stuck(const volatile std::sig_atomic_t& step, const Stuck& when) {
    watched = &step;
    stuck = when;
    start(look, nullptr);
}

void at_exit(void (*call)()) {
    std::atexit(call);
}

// Without the libraries' last words: that of OpenMP may wait for a thread that has ended already.
int end_program(int code) {
    std::cout << std::flush;
    std::fflush(nullptr);
    ::TerminateProcess(::GetCurrentProcess(), static_cast<UINT>(code));
    return code;
}

}  // namespace checkpoint
