#include <sys/wait.h>
#include <unistd.h>

#include <app/errors.hpp>
#include <csignal>
#include <cstdio>
#include <rt/todo.hpp>
#include <thread>

#include "checkpoint.hpp"

namespace {

struct Outcome {
    int code;
    std::string said;  // on stderr
};

// Runs some work as a program of the course does, with stderr in a file.
Outcome outcome_of(const std::function<int()>& work) {
    std::FILE* const file = std::tmpfile();
    std::fflush(stderr);
    const int before = ::dup(STDERR_FILENO);
    ::dup2(::fileno(file), STDERR_FILENO);
    const int code = app::run_or_explain("program", work);
    std::fflush(stderr);
    ::dup2(before, STDERR_FILENO);
    ::close(before);
    std::rewind(file);
    std::string said(4096, '\0');
    said.resize(std::fread(said.data(), 1, said.size(), file));
    std::fclose(file);
    return {code, said};
}

template <class Error>
Outcome outcome_of_throwing(const Error& error) {
    return outcome_of([&]() -> int { throw error; });
}

}  // namespace

TEST_CASE("work that succeeds ends with its own code and says nothing", "[errors]") {
    for (const int code : {0, 1, 3}) {
        const auto [got, said] = outcome_of([=] { return code; });
        CHECK(got == code);
        CHECK(said.empty());
    }
}

TEST_CASE("every kind of error has its exit code and its line", "[errors]") {
    const auto check = [](const Outcome& outcome, int code, const std::string& line) {
        CHECK(outcome.code == code);
        CHECK(outcome.said == "program: " + line + '\n');
    };
    check(outcome_of_throwing(app::UsageError("wrong")), 2, "wrong");
    check(outcome_of_throwing(app::Failure("disk")), 1, "disk");
    check(outcome_of_throwing(std::logic_error("a bug")), 1, "a bug");
    check(outcome_of_throwing(std::bad_alloc()), 1, "not enough memory; ask for a smaller picture");
    const rt::NotImplemented todo("01.2", "exercises/01_vectors/rt/dot.hpp", 9);
    check(outcome_of_throwing(todo), 3, todo.what());
}

TEST_CASE("an error is one line, whatever names are in it", "[errors]") {
    const Outcome outcome = outcome_of_throwing(app::Failure("a\nb\rc\td\x1b[31me\x7f Ü"));
    CHECK(outcome.said == "program: a b c d [31me  Ü\n");
}

TEST_CASE("a stub that threads reach is named once; what else they throw is a crash", "[errors]") {
    const auto in_threads = [](const auto& work) {
        return outcome_of([&] {
            if (::fork() == 0) {
                std::signal(SIGABRT, SIG_DFL);  // without the test runner's report
                std::thread one{work}, another{work};
                one.join();
                another.join();
                std::_Exit(0);
            }
            int status = 0;
            ::wait(&status);
            return status;
        });
    };
    const rt::NotImplemented todo("01.2", "exercises/01_vectors/rt/dot.hpp", 9);
    const auto [code, said] = in_threads([&] { throw todo; });
    CHECK((WIFEXITED(code) && WEXITSTATUS(code) == app::still_to_write));
    CHECK(said == std::string{"program: "} + todo.what() + '\n');
    const int other = in_threads([] { throw std::logic_error("a bug"); }).code;
    CHECK((WIFSIGNALED(other) && WTERMSIG(other) == SIGABRT));
}
