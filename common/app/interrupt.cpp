#include <app/interrupt.hpp>
#include <atomic>
#include <csignal>
#include <iterator>

namespace app {
namespace {

constexpr int signals[] = {SIGINT, SIGTERM};

std::atomic<int> came = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler must not wait for a lock");

// Those that are noted; the others were ignored before, and still are.
volatile std::sig_atomic_t taken[std::size(signals)];

extern "C" void note_signal(int signal) {
    came = signal;
    for (std::size_t i = 0; i < std::size(signals); ++i)
        if (taken[i]) std::signal(signals[i], SIG_DFL);
}

}  // namespace

Interruption::Interruption() {
    came = 0;
    for (std::size_t i = 0; i < std::size(signals); ++i) {
        before_[i] = std::signal(signals[i], SIG_IGN);
        taken[i] = before_[i] != SIG_IGN;
        if (taken[i]) std::signal(signals[i], note_signal);
    }
}

Interruption::~Interruption() {
    for (std::size_t i = 0; i < std::size(signals); ++i) std::signal(signals[i], before_[i]);
}

int Interruption::signal() {
    return came.load(std::memory_order_relaxed);
}

rt::Image unfinished_image(int width, int height) {
    constexpr int side = 8;  // pixels
    const rt::Color dark = rt::from_hex(0x1c1c22), light = rt::from_hex(0x2a2a33);
    return rt::make_image(
        width, height, [&](int x, int y) { return (x / side + y / side) % 2 == 0 ? dark : light; });
}

}  // namespace app
