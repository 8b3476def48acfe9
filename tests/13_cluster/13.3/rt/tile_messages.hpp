#pragma once
#include "../types.hpp"

namespace rt {

using answer::receive_tile;
using ArrivingTile = answer::Arriving;

class TileSender {
  public:
    explicit TileSender(MPI_Comm ranks) : own_{answer::make_sender(ranks)} {}
    void send(int tile, std::vector<Color> pixels) { own_->send(tile, std::move(pixels)); }
    void finish() { own_->finish(); }
    int kept() const { return own_->kept(); }

  private:
    std::unique_ptr<answer::Sender> own_;
};

}  // namespace rt
