#pragma once
#include <list>
#include <optional>
#include <rt/ranks.hpp>
#include <utility>
#include <vector>

namespace rt {

// A tile that has arrived at rank 0.
struct ArrivedTile {
    int tile = 0, from = 0;  // its number, and the rank that drew it
    std::vector<Color> pixels;
};

// Sends tiles to rank 0 without waiting until they are there.
class TileSender {
  public:
    explicit TileSender(MPI_Comm ranks) : ranks_{ranks} {}
    TileSender(const TileSender&) = delete;
    TileSender& operator=(const TileSender&) = delete;

    // Begins to send the pixels of the tile with this number, and returns at once. The message
    // keeps them until it has been sent. Messages that have been sent are forgotten.
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

    // Returns when all of them have been sent.
    void finish() {
        for (Message& message : messages_) MPI_Wait(&message.request, MPI_STATUS_IGNORE);
        messages_.clear();
    }

    // How many messages it keeps (given).
    int kept() const { return static_cast<int>(messages_.size()); }

  private:
    struct Message {
        std::vector<Color> pixels;
        MPI_Request request = MPI_REQUEST_NULL;
    };
    MPI_Comm ranks_;
    std::list<Message> messages_;  // in a list, each stays where it is
};

// Rank 0 calls it: a tile that has arrived, whoever sent it. If there is none, it does not wait.
inline std::optional<ArrivedTile> receive_tile(MPI_Comm ranks) {
    int is_there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, ranks, &is_there, &status);
    if (!is_there) return {};
    int count = 0;
    MPI_Get_count(&status, mpi_color(), &count);
    ArrivedTile arrived{status.MPI_TAG, status.MPI_SOURCE, {}};
    arrived.pixels.resize(static_cast<std::size_t>(count));
    MPI_Recv(arrived.pixels.data(), count, mpi_color(), arrived.from, arrived.tile, ranks,
             MPI_STATUS_IGNORE);
    return arrived;
}

}  // namespace rt
