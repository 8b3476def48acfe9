#include <answer.hpp>
#include <rt/tile_messages.hpp>

#include "types.hpp"

namespace {

struct Own : answer::Sender {
    explicit Own(MPI_Comm ranks) : sender{ranks} {}
    void send(int tile, std::vector<rt::Color> pixels) override {
        sender.send(tile, std::move(pixels));
    }
    void finish() override { sender.finish(); }
    int kept() const override { return sender.kept(); }

    rt::TileSender sender;
};

}  // namespace

namespace answer EXPORTED {

std::unique_ptr<Sender> make_sender(MPI_Comm ranks) {
    return std::make_unique<Own>(ranks);
}

std::optional<Arriving> receive_tile(MPI_Comm ranks) {
    auto arriving = rt::receive_tile(ranks);
    if (!arriving) return {};
    return Arriving{arriving->tile, arriving->from, std::move(arriving->pixels), arriving->request};
}

}  // namespace EXPORTED
