#pragma once
// Stopping a long render early without losing what is done.

#include <app/signals.hpp>
#include <rt/image.hpp>

namespace app {

// Why a picture is unfinished, and how much of it is done.
struct Stopped {
    int signal = 0;
    double share_done = 0;  // 0 to 1
};

// While an Interruption exists, the first Ctrl-C (SIGINT) or SIGTERM does not end the program: it
// is recorded here, and the workers check for it from time to time. The next one ends the program
// as usual. A signal that is ignored when the program starts (nohup) stays ignored. Only one
// Interruption may exist at a time.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    // The number of the signal that was received, or 0 if none has been. May be called from any
    // thread, and costs next to nothing.
    static int signal();

  private:
    OnSignal on_signal_;
};

// Fills a new image with the dark checkerboard that marks what has not been drawn.
void draw_unfinished(rt::Image& image);

}  // namespace app
