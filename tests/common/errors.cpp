#include <app/errors.hpp>
#include <rt/todo.hpp>

#include "checkpoint.hpp"
#include "outcome.hpp"

namespace {

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
