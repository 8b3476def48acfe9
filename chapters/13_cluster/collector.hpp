#pragma once
// The tiles of the picture, as they come to rank 0.

#include <app/run.hpp>
#include <deque>
#include <list>
#include <optional>
#include <rt/tile_messages.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tile_store.hpp"

namespace cluster {

using namespace rt;

// Collects the tiles of the picture at rank 0.
class Collector {
  public:
    // Calls put(tile, pixels) to put a tile into the picture. Finished tiles are kept in `store`;
    // if it is null, none are kept.
    Collector(int count, PutTile put, TileStore* store, app::Progress& progress)
        : put_{std::move(put)},
          drawn_by_(static_cast<std::size_t>(count), nobody),
          left_{count},
          store_{store},
          progress_{progress} {
        progress_.start(count);
    }

    // Adds a tile from an earlier run.
    void add_old(int tile, const std::vector<Color>& pixels) { put(tile, an_earlier_run, pixels); }

    // Adds a tile that `rank` has drawn, unless it has arrived before. If the store has no room for
    // it, error() says so. Nothing is thrown, because the ranks must end together.
    void add(int tile, int rank, const std::vector<Color>& pixels) {
        if (has_arrived(tile)) return;
        put(tile, rank, pixels);
        if (!store_ || !error_.empty()) return;
        try {
            store_->save(tile, pixels);
        } catch (const std::runtime_error&) {
            error_ = store_->file().string() + " cannot be written; free some space there";
        }
    }

    // Adds all tiles that have come from other ranks. Some may still be on their way.
    void receive() {
        while (std::optional<ArrivingTile> arriving = receive_tile(MPI_COMM_WORLD))
            arriving_.push_back(std::move(*arriving));
        std::erase_if(arriving_, [&](ArrivingTile& tile) {
            int is_here = 0;
            MPI_Test(&tile.request, &is_here, MPI_STATUS_IGNORE);
            if (is_here) add(tile.tile, tile.from, tile.pixels);
            return is_here != 0;
        });
    }

    // Called when all tiles are given out. Returns one that has not arrived, each time the next
    // one; none if all have arrived.
    std::optional<int> outstanding() {
        if (!outstanding_) {
            outstanding_.emplace();
            for (int tile = 0; tile < static_cast<int>(drawn_by_.size()); ++tile)
                if (!has_arrived(tile)) outstanding_->push_back(tile);
        }
        while (!outstanding_->empty()) {
            const int tile = outstanding_->front();
            outstanding_->pop_front();
            if (has_arrived(tile)) continue;
            outstanding_->push_back(tile);
            return tile;
        }
        return {};
    }

    // Whether all tiles are here, or no more can be kept.
    bool is_over() const { return left_ == 0 || !error_.empty(); }

    const std::string& error() const { return error_; }
    // The rank that drew each tile; less than 0 if none did in this run.
    const std::vector<int>& drawn_by() const { return drawn_by_; }

  private:
    static constexpr int nobody = -2, an_earlier_run = -1;

    bool has_arrived(int tile) const { return drawn_by_[static_cast<std::size_t>(tile)] != nobody; }
    void put(int tile, int rank, const std::vector<Color>& pixels) {
        put_(tile, pixels);
        drawn_by_[static_cast<std::size_t>(tile)] = rank;
        --left_;
        progress_.step();
    }

    PutTile put_;
    std::vector<int> drawn_by_;
    int left_;  // how many have not arrived
    std::list<ArrivingTile> arriving_;
    std::optional<std::deque<int>> outstanding_;
    TileStore* store_;
    app::Progress& progress_;
    std::string error_;
};

}  // namespace cluster
