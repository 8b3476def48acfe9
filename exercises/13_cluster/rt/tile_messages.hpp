#pragma once
#include <list>
#include <optional>
#include <rt/ranks.hpp>
#include <rt/todo.hpp>
#include <vector>

namespace rt {

// A tile that is arriving at rank 0.
struct ArrivingTile {
    int tile = 0, from = 0;  // the number of the tile, and the rank that drew it
    std::vector<Color> pixels;
    MPI_Request request = MPI_REQUEST_NULL;  // when it is done, all pixels are here
};

// Sends tiles to rank 0 without waiting until they have arrived.
class TileSender {
  public:
    explicit TileSender(MPI_Comm ranks) : ranks_{ranks} {}
    TileSender(const TileSender&) = delete;
    TileSender& operator=(const TileSender&) = delete;

    // Exercise 13.3. Begins to send the pixels of the tile with this number to rank 0, with the
    // number as the tag, and returns at once. Keeps the pixels in messages_ until they have been
    // sent.
    // Star: forget the messages that have been sent.
    void send(int tile, std::vector<Color> pixels) { rt::todo("13.3", tile, pixels, ranks_); }

    // Exercise 13.3. Waits until all messages have been sent, and then forgets them.
    void finish() { rt::todo("13.3"); }

    // The number of messages that the sender keeps (given).
    int kept() const { return static_cast<int>(messages_.size()); }

  private:
    struct Message {
        std::vector<Color> pixels;
        MPI_Request request = MPI_REQUEST_NULL;
    };
    MPI_Comm ranks_;
    std::list<Message> messages_;  // in a list, each stays where it is
};

// Exercise 13.3. Called by rank 0. If the message of a tile has arrived, from any rank, begins to
// receive its pixels; otherwise returns none. It does not wait.
inline std::optional<ArrivingTile> receive_tile(MPI_Comm ranks) {
    return rt::todo("13.3", ranks);
}

}  // namespace rt
