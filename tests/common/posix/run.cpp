#include <sys/wait.h>
#include <unistd.h>

#include <app/interrupt.hpp>
#include <csignal>

#include "checkpoint.hpp"

TEST_CASE("the second signal ends the program", "[run]") {
    for (const int second : {SIGINT, SIGTERM}) {
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            std::signal(SIGINT, SIG_DFL);
            std::signal(SIGTERM, SIG_DFL);
            const app::Interruption interruption;
            std::raise(SIGTERM);
            if (app::Interruption::signal() == SIGTERM) std::raise(second);
            ::_exit(0);
        }
        int status = 0;
        REQUIRE(::waitpid(child, &status, 0) == child);
        CHECK(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == second);
    }
}
