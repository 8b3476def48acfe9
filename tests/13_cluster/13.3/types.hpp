#pragma once
// What both sides know.

#include <memory>
#include <optional>
#include <rt/ranks.hpp>
#include <vector>

namespace answer {

struct Arriving {
    int tile = 0, from = 0;
    std::vector<rt::Color> pixels;
    MPI_Request request = MPI_REQUEST_NULL;
};

struct Sender {
    virtual ~Sender() = default;
    virtual void send(int tile, std::vector<rt::Color> pixels) = 0;
    virtual void finish() = 0;
    virtual int kept() const = 0;
};
std::unique_ptr<Sender> make_sender(MPI_Comm ranks);
std::optional<Arriving> receive_tile(MPI_Comm ranks);

}  // namespace answer
