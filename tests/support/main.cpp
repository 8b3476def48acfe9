// The entry point of every program of test cases, and the reporter that the companion reads. With
// `-r events` every event is a line of JSON, written whole and at once: a crash leaves only whole
// lines behind. Catch2 3 brings its own main().
#include <sys/resource.h>

#include <csignal>
#include <cstdint>
#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_test_case_info.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
#include <catch2/reporters/catch_reporter_streaming_base.hpp>
#else
#define CATCH_CONFIG_MAIN
#define CATCH_CONFIG_NO_POSIX_SIGNALS  // ours know more
#include "catch.hpp"
#endif
#include <nlohmann/json.hpp>
#include <rt/todo.hpp>

using nlohmann::json;

namespace {

// The forbidden memory whose use ended the program: that of a null pointer, or below a full stack.
const char* forbidden_memory = "";

#if defined(CATCH_CONFIG_MAIN) && !defined(RT_SANITIZED)  // sanitizers tell more about a crash
// Does what Catch2 does at such a signal, and also looks at the address.
class CrashHandler {
  public:
    CrashHandler() {
        static char stack[1 << 16];  // since a full stack leaves no room
        stack_t own{};
        own.ss_sp = stack;
        own.ss_size = sizeof stack;
        sigaltstack(&own, nullptr);
        for (const Crash& crash : crashes) {
            struct sigaction action {};
            action.sa_sigaction = report;
            action.sa_flags = SA_ONSTACK | SA_SIGINFO | SA_RESETHAND | SA_NODEFER;
            sigaction(crash.signal, &action, nullptr);
        }
        rlimit limit{};
        getrlimit(RLIMIT_STACK, &limit);
        char here = 0;
        if (limit.rlim_cur != RLIM_INFINITY)
            stack_end = reinterpret_cast<std::uintptr_t>(&here) - limit.rlim_cur;
    }

  private:
    struct Crash {
        int signal;
        const char* name;
    };
    static constexpr Crash crashes[]{
        {SIGSEGV, "SIGSEGV"}, {SIGBUS, "SIGBUS"},  {SIGFPE, "SIGFPE"}, {SIGILL, "SIGILL"},
        {SIGABRT, "SIGABRT"}, {SIGTERM, "SIGTERM"}};  // the companion's at a time-out
    static inline std::uintptr_t stack_end = 0;

    static void report(int signal, siginfo_t* info, void*) {
        constexpr std::uintptr_t page = 4096, near = 1 << 20;
        const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
        if ((signal == SIGSEGV || signal == SIGBUS) && info->si_code > 0) {
            if (address < page) forbidden_memory = "null";
            if (stack_end > 0 && address + near > stack_end && address < stack_end + near)
                forbidden_memory = "stack";
        }
        for (const Crash& crash : crashes)
            if (crash.signal == signal)
                Catch::getCurrentContext().getResultCapture()->handleFatalErrorCondition(
                    crash.name);
        std::raise(signal);
    }
};
const CrashHandler crash_handler;
#endif

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

json failure(const Catch::AssertionStats& stats) {
    using Catch::ResultWas;
    const Catch::AssertionResult& result = stats.assertionResult;
    json messages = json::array();
    for (const Catch::MessageInfo& info : stats.infoMessages)
        if (info.type == ResultWas::Info || info.type == ResultWas::ExplicitFailure)
            messages.push_back(info.message);
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

#ifdef CATCH_CONFIG_MAIN
class EventReporter : public Catch::StreamingReporterBase<EventReporter> {
  public:
    explicit EventReporter(const Catch::ReporterConfig& config) : StreamingReporterBase{config} {
        m_reporterPrefs.shouldRedirectStdOut = true;
    }
    void assertionStarting(const Catch::AssertionInfo&) override {}
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
    }
    void assertionEnded(const Catch::AssertionStats& stats) override { report(stats); }
    std::ostream& out() { return m_stream; }
#endif
    static std::string getDescription() {
        return "a line of JSON an event, for ./course";
    }

    void testCaseStarting(const Catch::TestCaseInfo& test) override {
        StreamingReporterBase::testCaseStarting(test);
        write({{"event", "begins"},
               {"name", test.name},
               {"hard", test.tagsAsString().find("[hard]") != std::string::npos}});
    }
    void testCaseEnded(const Catch::TestCaseStats& stats) override {
        StreamingReporterBase::testCaseEnded(stats);
        write({{"event", "ends"},
               {"passed", stats.totals.assertions.allOk()},
               {"output", stats.stdOut}});
    }

  private:
    void report(const Catch::AssertionStats& stats) {
        const Catch::AssertionResult& result = stats.assertionResult;
        const bool crashes = result.getResultType() == Catch::ResultWas::FatalErrorCondition;
        // There is no more to say about a crash before the first assertion.
        if (!result.isOk() && (!crashes || result.hasExpression())) write(failure(stats));
        if (crashes)
            write({{"event", "crashes"},
                   {"cause", std::string{result.getMessage()}},
                   {"memory", forbidden_memory}});
    }

    // On a line of its own, whatever the tested code has printed before.
    void write(const json& event) {
        out() << '\n' << event.dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
    }
};

}  // namespace

CATCH_REGISTER_REPORTER("events", EventReporter)
