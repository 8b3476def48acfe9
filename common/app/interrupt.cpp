#include <app/interrupt.hpp>
#include <atomic>

namespace app {
namespace {

std::atomic<int> came = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler must not wait for a lock");

// Only the first one is noted.
bool note_signal(int signal) {
    int none = 0;
    return came.compare_exchange_strong(none, signal);
}

}  // namespace

Interruption::Interruption() : on_signal_{{SIGINT, SIGTERM}, note_signal} {}

Interruption::~Interruption() {
    came = 0;
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
