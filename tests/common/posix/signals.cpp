#include <sys/wait.h>
#include <unistd.h>

#include <app/signals.hpp>
#include <functional>

#include "catch.hpp"

namespace {

// What the actions write, one after the other.
int written[2];

template <char name>
bool write_name(int) {
    const char letter = name;
    return ::write(written[1], &letter, 1) != 1;
}

bool go_on(int) {
    return true;
}

// What a process of its own writes, and the signal that ends it: "ab 15"; 0 where none does.
std::string ended_by(const std::function<void()>& work) {
    REQUIRE(::pipe(written) == 0);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        for (const int signal : app::ending_signals) std::signal(signal, SIG_DFL);
        work();
        ::_exit(0);
    }
    ::close(written[1]);
    std::string names;
    for (char name; ::read(written[0], &name, 1) == 1;) names += name;
    ::close(written[0]);
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    return names + ' ' + std::to_string(WIFSIGNALED(status) ? WTERMSIG(status) : 0);
}

}  // namespace

TEST_CASE("a signal calls all actions and then ends the program", "[signals]") {
    for (const int signal : app::ending_signals)
        CHECK(ended_by([&] {
                  const app::OnSignal a{app::ending_signals, write_name<'a'>};
                  const app::OnSignal b{{signal}, write_name<'b'>};
                  std::raise(signal);
              }) == "ab " + std::to_string(signal));
}

TEST_CASE("an action may let the program go on", "[signals]") {
    CHECK(ended_by([] {
              const app::OnSignal first{{SIGTERM}, go_on};
              const app::OnSignal second{{SIGTERM}, write_name<'x'>};
              std::raise(SIGTERM);
              write_name<'y'>(0);
          }) == "y 0");
}

TEST_CASE("a signal that nobody waits for does what it did before", "[signals]") {
    CHECK(ended_by([] {
              std::signal(SIGHUP, SIG_IGN);
              const app::OnSignal kept{{SIGHUP}, write_name<'i'>};
              { const app::OnSignal gone{{SIGTERM}, write_name<'g'>}; }
              std::raise(SIGHUP);
              std::raise(SIGTERM);
          }) == " 15");
}
