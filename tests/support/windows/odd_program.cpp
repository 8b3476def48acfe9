// odd_program DOES WORDS...: what a program may do, for the tests of running programs.
#include <io.h>
#include <windows.h>
#undef near  // which stands for nothing there

#include <app/errors.hpp>
#include <app/interrupt.hpp>
#include <app/platform.hpp>
#include <app/signals.hpp>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <rt/todo.hpp>
#include <string>
#include <thread>

namespace {

int depth(int from) {
    volatile char much[4096]{};
    return from == 0 ? 0 : 1 + depth(from + 1) + much[0];
}

int crash(const std::string& how) {
    if (how == "null") *static_cast<volatile int*>(nullptr) = 1;
    if (how == "stack") return depth(1);
    volatile int zero = 0;
    if (how == "divide") return 7 / zero;
    RaiseException(0xc000001d, EXCEPTION_NONCONTINUABLE, 0, nullptr);
    return 0;
}

template <char name>
bool say(int) {
    std::cout << name << std::flush;
    return false;
}

// A signal comes, and two actions want to hear of it.
void raise_with_actions(int signal) {
    const app::OnSignal first{app::ending_signals, say<'a'>}, second{{signal}, say<'b'>};
    std::raise(signal);
}

// Two signals come, of which the first only asks for the end.
void raise_twice(int second) {
    const app::Interruption interruption;
    std::raise(SIGTERM);
    if (app::Interruption::signal() == SIGTERM) std::raise(second);
}

int throw_in_thread() {
    std::thread{[] { rt::todo("01.2"); }}.join();
    return 0;
}

// Starts this program once more, and does not wait for it.
bool start(int argc, char** argv) {
    std::string line = '"' + std::string{argv[0]} + '"';
    for (int i = 2; i < argc; ++i) line += " \"" + std::string{argv[i]} + '"';
    STARTUPINFOA how{};
    how.cb = sizeof how;
    PROCESS_INFORMATION made{};
    return CreateProcessA(nullptr, line.data(), nullptr, nullptr, TRUE, 0, nullptr, nullptr, &how,
                          &made);
}

}  // namespace

int main(int argc, char** argv) {
    app::prepare_process();
    const std::string does = argc > 1 ? argv[1] : "", word = argc > 2 ? argv[2] : "";
    if (does == "print")
        for (int i = 2; i < argc; ++i) std::cout << argv[i] << '|';
    if (does == "exit") return std::atoi(word.c_str());
    if (does == "crash") return crash(word);
    if (does == "count")
        for (int i = 0; i < std::atoi(word.c_str()); ++i) std::cout << i << '\n';
    if (does == "both") {
        std::cout << "one\n" << std::flush;
        std::cerr << "two\n" << std::flush;
        std::cout << "three\n";
    }
    if (does == "event") return _write(3, "event\n", 6) != 6;
    if (does == "variable") std::cout << std::getenv(word.c_str());
    if (does == "read") std::cout << std::string{std::istreambuf_iterator<char>{std::cin}, {}};
    if (does == "write") std::ofstream{word, std::ios::binary} << "x\n";
    if (does == "late") {
        Sleep(1000);
        std::ofstream{word} << 'x';
    }
    if (does == "start") return !start(argc, argv);
    if (does == "start_and_wait") {
        std::cout << "before\n" << std::flush;
        start(argc, argv);
        Sleep(20'000);
    }
    if (does == "raise") raise_with_actions(std::atoi(word.c_str()));
    if (does == "raise twice") raise_twice(std::atoi(word.c_str()));
    if (does == "todo") return app::run_or_explain("odd_program", throw_in_thread);
    if (does == "loop")
        for (volatile int i = 0;;) {
            const int next = i;
            i = next;
        }
}
