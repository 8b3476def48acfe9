#include <algorithm>
#include <app/platform.hpp>
#include <app/signals.hpp>
#include <array>
#include <atomic>
#include <cerrno>
#include <mutex>

namespace app {
namespace {

// The actions of each signal, the oldest first; null where there is none.
using Actions = std::array<std::atomic<OnSignal::Action>, 8>;
Actions actions[NSIG];
static_assert(Actions::value_type::is_always_lock_free, "a handler must not wait for a lock");
std::mutex changing;

extern "C" void act(int signal) {
    const int error = errno;
    std::signal(signal, act);  // again, because Windows resets it before the call
    for (const auto& action : actions[signal])
        if (const OnSignal::Action call = action; call && call(signal)) {
            errno = error;
            return;
        }
    end_by(signal);
}

}  // namespace

OnSignal::OnSignal(std::initializer_list<int> signals, Action action)
    : signals_{signals}, action_{action} {
    const std::lock_guard lock{changing};
    for (const int signal : signals_) {
        auto& all = actions[signal];
        const auto free = std::find(all.begin(), all.end(), nullptr);
        if (free != all.end()) *free = action;
        if (handler_of(signal) == SIG_DFL) std::signal(signal, act);
    }
}

OnSignal::~OnSignal() {
    const std::lock_guard lock{changing};
    for (const int signal : signals_) {
        auto& all = actions[signal];
        const auto mine = std::find(all.rbegin(), all.rend(), action_);
        if (mine != all.rend()) *mine = nullptr;
        const bool is_last = std::count(all.begin(), all.end(), nullptr) == std::ssize(all);
        if (is_last && handler_of(signal) == act) std::signal(signal, SIG_DFL);
    }
}

}  // namespace app
