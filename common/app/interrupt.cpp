#include <app/interrupt.hpp>
#include <atomic>

namespace app {
namespace {

std::atomic<int> came = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler must not wait for a lock");

// Only the first signal is recorded.
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

void draw_unfinished(rt::Image& image) {
    constexpr int side = 8;  // pixels
    const rt::Color dark = rt::from_hex(0x1c1c22), light = rt::from_hex(0x2a2a33);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image.at(x, y) = (x / side + y / side) % 2 == 0 ? dark : light;
}

}  // namespace app
