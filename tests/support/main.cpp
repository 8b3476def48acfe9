// The entry point of every program of test cases, and the reporter that the companion reads. With
// `-r events` every event is a line of JSON, written whole and at once: a crash leaves only whole
// lines behind. Catch2 3 brings its own main().
//
// For the companion they go to the descriptor 3, each after a secret word, which COURSE_EVENTS
// holds: so the tested code cannot write events of its own.
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_test_case_info.hpp>
#include <catch2/interfaces/catch_interfaces_registry_hub.hpp>
#include <catch2/interfaces/catch_interfaces_testcase.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
#include <catch2/reporters/catch_reporter_streaming_base.hpp>
#else
#define CATCH_CONFIG_MAIN
#define CATCH_CONFIG_NO_POSIX_SIGNALS  // ours know more
#endif
#include <nlohmann/json.hpp>
#include <rt/todo.hpp>
#include "catch.hpp"

using nlohmann::json;

int checkpoint::unfinished_passes = 0;

extern char** environ;

namespace {

// The secret word of this run, and what is left of it in the environment: nothing.
class Secret {
  public:
    // Calls nothing of the C library, which is not ready where the system is Linux.
    static void take(char** environment) {
        for (; environment && *environment; ++environment) {
            const char* name = "COURSE_EVENTS=";
            char* at = *environment;
            while (*name && *at == *name) ++at, ++name;
            if (*name) continue;
            std::size_t length = 0;
            for (; *at && length + 1 < sizeof word_; ++at) {
                word_[length++] = *at;
                *at = '-';
            }
        }
    }
    static const char* word() { return word_; }

  private:
    static inline char word_[64]{};
};

#if defined(__GLIBC__) && !defined(RT_SANITIZED)
// Before any code of a library, and so before the answer's.
[[gnu::used, gnu::section(".preinit_array")]] void (*const before_libraries)(int, char**, char**) =
    [](int, char**, char** environment) { Secret::take(environment); };
#else
const bool is_taken = (Secret::take(environ), true);
#endif

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

// Writes all of it, whatever the file takes at once.
void write_line(int file, const char* line, std::size_t size) {
    for (std::size_t done = 0; done < size;) {
        const ssize_t count = ::write(file, line + done, size - done);
        if (count <= 0) return;
        done += static_cast<std::size_t>(count);
    }
}

// Ends the program when it gets no further: the tested code is in an endless loop. What counts is
// the processor time of all threads, so a busy machine does not matter.
class Watch {
  public:
    static void begin() {
#ifndef RT_SANITIZED  // where everything takes many times as long
        const bool is_secret = *Secret::word();
        std::snprintf(event_, sizeof event_, "\n%s%s{\"event\":\"computes\",\"seconds\":%d}\n",
                      Secret::word(), is_secret ? " " : "", most_seconds);
        file_ = is_secret ? 3 : STDOUT_FILENO;
        struct sigaction action {};
        action.sa_handler = look;
        action.sa_flags = SA_RESTART;
        sigaction(SIGPROF, &action, nullptr);
        const itimerval often{{0, 1'000'000 / looks_a_second}, {0, 1'000'000 / looks_a_second}};
        setitimer(ITIMER_PROF, &often, nullptr);
#endif
    }
    static void note_progress() {
        step_ = step_ + 1;
    }

  private:
    static constexpr int most_seconds = 3, looks_a_second = 4;

    static void look(int) {
        idle_looks_ = step_ == seen_ ? idle_looks_ + 1 : 0;
        seen_ = step_;
        // The first look may come right after the last step.
        if (idle_looks_ <= most_seconds * looks_a_second) return;
        write_line(file_, event_, std::strlen(event_));
        std::signal(SIGPROF, SIG_IGN);
        // The rest allocates memory. If the tested code was doing that, it never ends, either.
        std::signal(SIGALRM, SIG_DFL);
        ::alarm(1);
        std::raise(SIGTERM);  // which is told with the hints of the test case
    }

    static inline char event_[128]{};
    static inline int file_ = 0, idle_looks_ = 0;
    static inline volatile std::sig_atomic_t step_ = 0, seen_ = 0;
};

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
        watch_exit();
        Watch::begin();
    }
    void assertionStarting(const Catch::AssertionInfo&) override { Watch::note_progress(); }
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
        Watch::begin();
    }
    void assertionStarting(const Catch::AssertionInfo&) override { Watch::note_progress(); }
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
        Watch::note_progress();
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
                   {"messages", {"Your code ended the test case before all of it was checked."}}});
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
#ifndef CATCH_CONFIG_MAIN
    static bool is_hidden(const Catch::TestCaseHandle& test) {
        return test.getTestCaseInfo().isHidden();
    }
    static json described(const Catch::TestCaseHandle& test) {
        return described(test.getTestCaseInfo());
    }
#endif

    // What calls exit() in a test case does not run the destructors of what the test case uses.
    void watch_exit() {
        process = ::getpid();
        std::atexit([] {
            if (!running || ::getpid() != process) return;
            running->write({{"event", "exits"}});
            ::_exit(1);
        });
    }
    static inline EventReporter* running = nullptr;
    static inline pid_t process = 0;

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
        const std::string secret = Secret::word(),
                          text = event.dump(-1, ' ', false, json::error_handler_t::replace);
        if (secret.empty()) {
            out() << '\n' << text << std::endl;
            return;
        }
        const std::string line = '\n' + secret + ' ' + text + '\n';
        write_line(3, line.data(), line.size());
    }
};

}  // namespace

CATCH_REGISTER_REPORTER("events", EventReporter)
