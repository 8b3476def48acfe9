#pragma once
// Stopping a long render early without losing what is done.

#include <app/signals.hpp>
#include <rt/image.hpp>

namespace app {

// Why a picture is not finished, and how much of it is.
struct Stopped {
    int signal = 0;
    double share_done = 0;  // 0 to 1
};

// While one lives, the first Ctrl-C (SIGINT) or SIGTERM does not end the program: it is noted here,
// and whoever works looks from time to time. The next one ends the program as usual. Who chose to
// ignore a signal (nohup) still does. There may be one at a time.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    // The signal that came, 0 before any. May be called from any thread, and costs next to nothing.
    static int signal();

  private:
    OnSignal on_signal_;
};

// Of the picture nothing is done yet: the dark checkerboard that stands for what is missing.
void draw_unfinished(rt::Image& image);

}  // namespace app
