#include <app/errors.hpp>
#include <app/platform.hpp>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <mutex>
#include <new>
#include <rt/todo.hpp>

namespace app {
namespace {

// The text as one line. The text may contain anything, such as a file name with line breaks.
std::string one_line(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
    return text;
}

std::string running;  // the program's name

ExitCode fail(const std::string& what, ExitCode code) {
    std::fprintf(stderr, "%s: %s\n", running.c_str(), one_line(what).c_str());
    return code;
}

const std::terminate_handler usual_end = std::get_terminate();

// If a thread reaches an exercise's stub, the stub is named as usual, and only once. Any other
// crash stays as it would be without this function.
[[noreturn]] void name_the_stub() {
    static std::mutex first;
    first.lock();
    if (const std::exception_ptr thrown = std::current_exception()) try {
            std::rethrow_exception(thrown);
        } catch (const rt::NotImplemented& error) {
            std::_Exit(fail(error.what(), still_to_write));
        } catch (...) {
        }
    usual_end();
    std::abort();
}

}  // namespace

int run_or_explain(const std::string& program, const std::function<int()>& work) {
    prepare_process();
    running = program;
    std::set_terminate(name_the_stub);
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
