// The entry point of every program of test cases, and the reporter that the companion reads. With
// `-r events` every event is a line of JSON, written whole and at once: a crash leaves only whole
// lines behind.
//
// For the companion they go to the descriptor 3, each after a secret word, which COURSE_EVENTS
// holds: so the tested code cannot write events of its own.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <string>
#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_session.hpp>
#include <catch2/catch_test_case_info.hpp>
#include <catch2/interfaces/catch_interfaces_capture.hpp>
#include <catch2/interfaces/catch_interfaces_registry_hub.hpp>
#include <catch2/interfaces/catch_interfaces_testcase.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
#include <catch2/reporters/catch_reporter_streaming_base.hpp>
#else
#define CATCH_CONFIG_RUNNER
#define CATCH_CONFIG_NO_POSIX_SIGNALS  // ours know more
#endif
#include <nlohmann/json.hpp>
#include <rt/todo.hpp>
#include "catch.hpp"
#include "run_control.hpp"

using nlohmann::json;

int checkpoint::unfinished_passes = 0;

void checkpoint::write_line(int file, const char* line, std::size_t size) {
    for (std::size_t done = 0; done < size;) {
        const auto count = ::write(file, line + done, static_cast<unsigned>(size - done));
        if (count <= 0) return;
        done += static_cast<std::size_t>(count);
    }
}

namespace {

// The forbidden memory whose use ended the program.
const char* forbidden_memory = "";

#ifndef RT_SANITIZED  // sanitizers tell more about a crash
#ifdef CATCH_CONFIG_RUNNER
constexpr bool catch_tells_signals = false;
#else
constexpr bool catch_tells_signals = true;
#endif
// Does what Catch2 does at such a signal, and also notes the memory.
void tell_crash(const char* signal, const char* memory) {
    forbidden_memory = memory;
    Catch::getResultCapture().handleFatalErrorCondition(signal);
}
const bool tells_crashes = (checkpoint::tell_crashes(tell_crash, catch_tells_signals), true);
#endif

// Each step of the test cases. Without one, the tested code is stuck.
volatile std::sig_atomic_t step = 0;
void note_progress() {
    step = step + 1;
}

void end_when_stuck() {
#ifndef RT_SANITIZED  // where everything takes many times as long
    static char computes[128], waits[128];
    constexpr int seconds = 3;
    const bool is_secret = *checkpoint::secret_word();
    const auto write = [&](char(&event)[128], const char* name) {
        std::snprintf(event, sizeof event, "\n%s%s{\"event\":\"%s\",\"seconds\":%d}\n",
                      checkpoint::secret_word(), is_secret ? " " : "", name, seconds);
    };
    write(computes, "computes");
    write(waits, "waits");
    const int file = is_secret ? checkpoint::events_file : checkpoint::standard_output;
    checkpoint::end_when_stuck(step, {file, seconds, computes, waits});
#endif
}

// The exercise whose rt::todo threw the exception that is being handled; empty for
// any other exception.
std::string missing_exercise() {
    try {
        throw;
    } catch (const rt::NotImplemented& todo) {
        return todo.exercise();
    } catch (...) {
        return "";
    }
}

// A message without the marks of catch.hpp, and what these mark.
json fields_of(const std::string& message) {
    std::string text, expected, actual, counts, rest, *field = &rest;
    bool is_for_crash = false;
    for (const char c : message) {
        if (c == checkpoint::end_mark || c == '\n') field = &rest;
        if (c == checkpoint::expected_mark) {
            field = &expected;
        } else if (c == checkpoint::actual_mark) {
            field = &actual;
        } else if (c == checkpoint::counts_mark) {
            field = &counts;
        } else if (c == checkpoint::crash_mark) {
            is_for_crash = true;
        } else if (field == &counts) {
            counts += c;
        } else if (c != checkpoint::end_mark) {
            text += c;
            *field += c;
        }
    }
    return {{"text", text},
            {"expected", expected},
            {"actual", actual},
            {"counts", counts},
            {"if_it_crashes", is_for_crash}};
}

json failure(const Catch::AssertionStats& stats) {
    using Catch::ResultWas;
    const Catch::AssertionResult& result = stats.assertionResult;
    json messages = json::array();
    for (const Catch::MessageInfo& info : stats.infoMessages)
        if (info.type == ResultWas::Info || info.type == ResultWas::ExplicitFailure)
            messages.push_back(fields_of(info.message));
    json event{{"event", "failed"}, {"messages", messages}};
    if (result.hasExpression()) {
        event["macro"] = std::string{result.getTestMacroName()};
        event["expression"] = result.getExpression();
        event["expanded"] = result.getExpandedExpression();
    }
    if (result.getResultType() == ResultWas::ThrewException) {
        event["exception"] = std::string{result.getMessage()};
        event["missing"] = missing_exercise();
    }
    return event;
}

#ifdef CATCH_CONFIG_RUNNER
class EventReporter : public Catch::StreamingReporterBase<EventReporter> {
  public:
    explicit EventReporter(const Catch::ReporterConfig& config) : StreamingReporterBase{config} {
        m_reporterPrefs.shouldRedirectStdOut = true;
        watch_exit();
        end_when_stuck();
    }
    void assertionStarting(const Catch::AssertionInfo&) override { note_progress(); }
    bool assertionEnded(const Catch::AssertionStats& stats) override {
        report(stats);
        return true;
    }
    std::ostream& out() { return stream; }
#else
class EventReporter : public Catch::StreamingReporterBase {
  public:
    explicit EventReporter(Catch::ReporterConfig&& config)
        : StreamingReporterBase{std::move(config)} {
        m_preferences.shouldRedirectStdOut = true;
        watch_exit();
        end_when_stuck();
    }
    void assertionStarting(const Catch::AssertionInfo&) override { note_progress(); }
    void assertionEnded(const Catch::AssertionStats& stats) override { report(stats); }
    std::ostream& out() { return m_stream; }
#endif
    static std::string getDescription() {
        return "a line of JSON an event, for ./course";
    }

    void testRunStarting(const Catch::TestRunInfo& run) override {
        StreamingReporterBase::testRunStarting(run);
        json cases = json::array();
        for (const auto& test : Catch::getRegistryHub().getTestCaseRegistry().getAllTests())
            if (!is_hidden(test)) cases.push_back(described(test));
        write({{"event", "cases"}, {"cases", cases}});
        running = this;
    }
    void testRunEnded(const Catch::TestRunStats& stats) override {
        running = nullptr;
        StreamingReporterBase::testRunEnded(stats);
    }
    void testCaseStarting(const Catch::TestCaseInfo& test) override {
        StreamingReporterBase::testCaseStarting(test);
        note_progress();
        checkpoint::unfinished_passes = 0;
        json event = described(test);
        event["event"] = "begins";
        write(event);
    }
    void testCaseEnded(const Catch::TestCaseStats& stats) override {
        StreamingReporterBase::testCaseEnded(stats);
        const Catch::Counts& assertions = stats.totals.assertions;
        bool passed = assertions.allOk();
        if (passed && (assertions.total() == 0 || checkpoint::unfinished_passes != 0)) {
            passed = false;
            write({{"event", "failed"},
                   {"messages",
                    json::array({fields_of(
                        "Your code ended the test case before all of it was checked.")})}});
        }
        write({{"event", "ends"}, {"passed", passed}, {"output", stats.stdOut}});
    }

  private:
    static bool is_hidden(const Catch::TestCaseInfo& test) {
        return test.isHidden();
    }
    static json described(const Catch::TestCaseInfo& test) {
        const bool hard = test.tagsAsString().find("[hard]") != std::string::npos;
        return {{"name", test.name}, {"hard", hard}};
    }
#ifndef CATCH_CONFIG_RUNNER
    static bool is_hidden(const Catch::TestCaseHandle& test) {
        return test.getTestCaseInfo().isHidden();
    }
    static json described(const Catch::TestCaseHandle& test) {
        return described(test.getTestCaseInfo());
    }
#endif

    // What calls exit() in a test case does not run the destructors of what the test case uses.
    void watch_exit() {
        checkpoint::at_exit([] {
            if (!running) return;
            running->write({{"event", "exits"}});
            std::_Exit(1);
        });
    }
    static inline EventReporter* running = nullptr;

    void report(const Catch::AssertionStats& stats) {
        const Catch::AssertionResult& result = stats.assertionResult;
        const bool crashes = result.getResultType() == Catch::ResultWas::FatalErrorCondition;
        // There is no more to say about a crash before the first assertion, unless a hint is there.
        if (!result.isOk() && (!crashes || result.hasExpression() || !stats.infoMessages.empty()))
            write(failure(stats));
        if (crashes)
            write({{"event", "crashes"},
                   {"cause", std::string{result.getMessage()}},
                   {"memory", forbidden_memory}});
    }

    // On a line of its own, whatever the tested code has printed before.
    void write(const json& event) {
        const std::string secret = checkpoint::secret_word(),
                          text = event.dump(-1, ' ', false, json::error_handler_t::replace);
        if (secret.empty()) {
            out() << '\n' << text << std::endl;
            return;
        }
        const std::string line = '\n' + secret + ' ' + text + '\n';
        checkpoint::write_line(checkpoint::events_file, line.data(), line.size());
    }
};

}  // namespace

CATCH_REGISTER_REPORTER("events", EventReporter)

int main(int argc, char** argv) {
    return checkpoint::end_program(Catch::Session{}.run(argc, argv));
}
