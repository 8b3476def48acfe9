#include <app/errors.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <rt/todo.hpp>

namespace app {
namespace {

// Text that may hold anything, such as a file name with line breaks, as one line.
std::string one_line(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
    return text;
}

}  // namespace

int run_or_explain(const std::string& program, const std::function<int()>& work) {
    std::signal(SIGXFSZ, SIG_IGN);
    const auto fail = [&](const std::string& what, ExitCode code) {
        std::fprintf(stderr, "%s: %s\n", program.c_str(), one_line(what).c_str());
        return code;
    };
    try {
        const int code = work();
        if (std::fflush(stdout) != 0)
            return fail(std::string{"cannot write to the standard output: "} + std::strerror(errno),
                        could_not);
        return code;
    } catch (const UsageError& error) {
        return fail(error.what(), bad_input);
    } catch (const rt::NotImplemented& error) {
        return fail(error.what(), still_to_write);
    } catch (const std::bad_alloc&) {
        return fail("not enough memory; ask for a smaller picture", could_not);
    } catch (const std::exception& error) {
        return fail(error.what(), could_not);
    }
}

}  // namespace app
