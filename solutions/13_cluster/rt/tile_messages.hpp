#pragma once
#include <list>
#include <optional>
#include <rt/ranks.hpp>
#include <utility>
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

    // Begins to send the pixels of the tile with this number to rank 0, with the number as the
    // tag, and returns at once. Keeps the pixels in messages_ until they have been sent, and
    // forgets the messages that have been sent.
    void send(int tile, std::vector<Color> pixels) {
        std::erase_if(messages_, [](Message& message) {
            int is_sent = 0;
            MPI_Test(&message.request, &is_sent, MPI_STATUS_IGNORE);
            return is_sent != 0;
        });
        Message& message = messages_.emplace_back();
        message.pixels = std::move(pixels);
        MPI_Isend(message.pixels.data(), static_cast<int>(message.pixels.size()), mpi_color(), 0,
                  tile, ranks_, &message.request);
    }

    // Waits until all messages have been sent, and then forgets them.
    void finish() {
        for (Message& message : messages_) MPI_Wait(&message.request, MPI_STATUS_IGNORE);
        messages_.clear();
    }

    // The number of messages that it keeps (given).
    int kept() const { return static_cast<int>(messages_.size()); }

  private:
    struct Message {
        std::vector<Color> pixels;
        MPI_Request request = MPI_REQUEST_NULL;
    };
    MPI_Comm ranks_;
    std::list<Message> messages_;  // in a list, each stays where it is
};

// Only rank 0 calls this function. If the message of a tile has arrived, from any rank, begins to
// receive its pixels; otherwise returns none. It does not wait.
inline std::optional<ArrivingTile> receive_tile(MPI_Comm ranks) {
    int is_there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, ranks, &is_there, &status);
    if (!is_there) return {};
    int count = 0;
    MPI_Get_count(&status, mpi_color(), &count);
    ArrivingTile arriving;
    arriving.tile = status.MPI_TAG;
    arriving.from = status.MPI_SOURCE;
    arriving.pixels.resize(static_cast<std::size_t>(count));
    MPI_Irecv(arriving.pixels.data(), count, mpi_color(), arriving.from, arriving.tile, ranks,
              &arriving.request);
    return arriving;
}

}  // namespace rt
