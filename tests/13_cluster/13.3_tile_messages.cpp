#include <rt/tile_messages.hpp>

#include "on_ranks.hpp"

using namespace checkpoint;
using rt::ArrivingTile, rt::Color, rt::TileSender;

namespace {

using std::chrono::milliseconds;

// A message of this size is not sent before somebody receives it; a small one may be.
constexpr int large = 64 * 64, small = 4;

std::vector<Color> tile_of(int tile, int size) {
    std::vector<Color> pixels;
    for (int i = 0; i < size; ++i)
        pixels.push_back({static_cast<Real>(tile), static_cast<Real>(i), real(0.25)});
    return pixels;
}

// The sender of tiles 1 to 100; other tiles have none.
int from_rank_1(int tile) {
    return tile >= 1 && tile <= 100 ? 1 : 0;
}

// Receives so many tiles, each of which must be `tile_of` its number. `size_of` says how large it
// is, and `sender_of` which rank sends it: 0 if there is no such tile.
std::string receive(MPI_Comm ranks, int count, const std::function<int(int tile)>& size_of,
                    const std::function<int(int tile)>& sender_of) {
    std::set<int> known;
    double latest = MPI_Wtime();
    for (int i = 0; i < count;) {
        if (MPI_Wtime() - latest > 2)
            return "expected " + std::to_string(count) + " tiles, actual " + std::to_string(i) +
                   ", and then none for 2 s\nHint: receive_tile must find messages from any rank "
                   "with any tag";
        std::optional<ArrivingTile> arrived = rt::receive_tile(ranks);
        if (!arrived) {
            std::this_thread::sleep_for(milliseconds{1});
            continue;
        }
        MPI_Wait(&arrived->request, MPI_STATUS_IGNORE);
        ++i;
        latest = MPI_Wtime();
        const auto& [tile, from, pixels, request] = *arrived;
        const std::string name = "tile " + std::to_string(tile);
        if (sender_of(tile) == 0 || !known.insert(tile).second)
            return "a tile has the number " + std::to_string(tile) +
                   ", but no such tile was sent, or it has arrived before\nHint: the tag of a "
                   "message is the number of its tile";
        if (from != sender_of(tile))
            return name + ": expected from rank " + std::to_string(sender_of(tile)) +
                   ", actual from rank " + std::to_string(from) +
                   "\nHint: status.MPI_SOURCE is the sender, and the tag is the number of the tile";
        if (static_cast<int>(pixels.size()) != size_of(tile))
            return name + ": expected " + std::to_string(size_of(tile)) + " pixels, actual " +
                   std::to_string(pixels.size()) +
                   "\nHint: MPI_Get_count tells you how many there are";
        const std::vector<Color> expected = tile_of(tile, size_of(tile));
        for (std::size_t k = 0; k < pixels.size(); ++k) {
            if (pixels[k] == expected[k]) continue;
            const int red = static_cast<int>(pixels[k].r);  // whose tile is it?
            const bool is_of_other = red >= 0 && sender_of(red) != 0 && sender_of(red) != from;
            return name + ", pixel " + std::to_string(k) + ": expected red " + text(expected[k].r) +
                   " and green " + text(expected[k].g) + ", actual " + text(pixels[k].r) + " and " +
                   text(pixels[k].g) + "\nHint: " +
                   (is_of_other
                        ? "these are the pixels of tile " + std::to_string(red) +
                              ", from another rank. Receive the very message that you have found: "
                              "pass status.MPI_SOURCE and status.MPI_TAG to MPI_Irecv"
                        : "MPI reads the pixels until the message has been sent; until then, they "
                          "must neither be destroyed nor move");
        }
    }
    return {};
}

// Makes use of memory that has been given back.
void use_memory_again() {
    static std::vector<std::vector<Color>> kept;
    for (int i = 0; i < 20; ++i) {
        kept.emplace_back(large, Color{-7, -7, -7});
        kept.emplace_back(small, Color{-7, -7, -7});
    }
    kept.clear();
}

// Tells rank 0 how far another rank is. It has a group of its own, so that receive_tile does not
// find it.
class Signal {
  public:
    explicit Signal(MPI_Comm ranks) { MPI_Comm_dup(ranks, &group_); }
    void give() { MPI_Send(nullptr, 0, MPI_INT, 0, 0, group_); }
    // Waits for the signals of so many ranks, a second at most: wrong senders may never give one.
    bool await(int count) {
        for (int i = 0; i < 500 && count > 0; ++i) {
            int is_there = 0;
            MPI_Iprobe(MPI_ANY_SOURCE, 0, group_, &is_there, MPI_STATUS_IGNORE);
            if (is_there) {
                MPI_Recv(nullptr, 0, MPI_INT, MPI_ANY_SOURCE, 0, group_, MPI_STATUS_IGNORE);
                --count;
            } else {
                std::this_thread::sleep_for(milliseconds{2});
            }
        }
        return count == 0;
    }

  private:
    MPI_Comm group_ = MPI_COMM_NULL;
};

}  // namespace

TEST_CASE("13.3 tiles arrive whole with their numbers and senders", "[13.3]") {
    on_ranks(4, [](MPI_Comm ranks) {
        // The tiles of rank 1 are 0, 6009, 12018 ..., those of rank 2 are 1, 6010, 12019 ...
        const auto size_of = [](int tile) {
            return tile == 0 ? 70'000 : tile % 2 == 0 ? large : 1 + tile % 7;
        };
        const auto sender_of = [](int tile) {
            return tile >= 0 && tile % 6009 < 3 ? 1 + tile % 6009 : 0;
        };
        if (rt::rank_of(ranks) == 0) return receive(ranks, 15, size_of, sender_of);
        TileSender sender{ranks};
        for (int i = 0; i < 5; ++i) {
            const int tile = 6009 * i + rt::rank_of(ranks) - 1;
            sender.send(tile, tile_of(tile, size_of(tile)));
        }
        sender.finish();
        return std::string{};
    });
}

TEST_CASE("13.3 sending does not wait for rank 0", "[13.3]") {
    on_ranks(2, [](MPI_Comm ranks) {
        constexpr int tiles = 40;
        Signal all_are_sent{ranks};
        if (rt::rank_of(ranks) == 1) {
            TileSender sender{ranks};
            yields = 0;  // those of the wait for rank 0
            for (int tile = 1; tile <= tiles; ++tile) sender.send(tile, tile_of(tile, large));
            all_are_sent.give();
            use_memory_again();
            sender.finish();
            return std::string{};
        }
        TileSender{ranks}.finish();  // of nothing: it does not wait
        const bool has_returned = all_are_sent.await(1);
        const std::string wrong = receive(
            ranks, tiles, [](int) { return large; }, from_rank_1);
        if (has_returned) return wrong;
        return std::string{
            "rank 1 sends 40 tiles, and rank 0 receives none yet: expected that send returns all "
            "the same, actual: after 1 s, rank 1 is still waiting\nHint: MPI_Send waits; MPI_Isend "
            "only begins to send, and returns"};
    });
}

TEST_CASE("13.3 messages keep their pixels until they are sent", "[13.3]") {
    on_ranks(3, [](MPI_Comm ranks) {
        Signal all_are_sent{ranks};
        if (rt::rank_of(ranks) == 0) {
            all_are_sent.await(2);
            return receive(
                ranks, 8, [](int) { return large; }, [](int tile) { return tile / 10; });
        }
        TileSender sender{ranks};
        for (int i = 1; i <= 4; ++i) {
            const int tile = 10 * rt::rank_of(ranks) + i;
            sender.send(tile, tile_of(tile, large));
            use_memory_again();
        }
        all_are_sent.give();
        sender.finish();
        use_memory_again();
        return std::string{};
    });
}

TEST_CASE("13.3 finish waits until all messages have been sent", "[13.3]") {
    for (const int count : {1, 2})
        on_ranks(2, [count](MPI_Comm ranks) {
            Signal begins_to_finish{ranks};
            if (rt::rank_of(ranks) == 0) {
                TileSender{ranks}.finish();  // of nothing: it does not wait
                // The second tile comes before the first.
                std::vector<Color> pixels(large);
                for (int tile = count; tile > 1; --tile)
                    MPI_Recv(pixels.data(), large, rt::mpi_color(), 1, tile, ranks,
                             MPI_STATUS_IGNORE);
                begins_to_finish.await(1);
                std::this_thread::sleep_for(milliseconds{200});
                return receive(
                    ranks, 1, [](int) { return large; }, from_rank_1);
            }
            TileSender sender{ranks};
            for (int tile = 1; tile <= count; ++tile) sender.send(tile, tile_of(tile, large));
            const double begin = MPI_Wtime();
            begins_to_finish.give();
            sender.finish();
            const double waited = MPI_Wtime() - begin;
            std::string wrong;
            if (waited < 0.1)
                wrong =
                    "rank 0 receives tile 1 only after 0.2 s: expected that finish waits until "
                    "then, actual: it returned after " +
                    std::to_string(waited) + " s\nHint: call MPI_Wait for each message";
            else if (sender.kept() != 0)
                wrong = "after finish: expected 0 kept messages, actual " +
                        std::to_string(sender.kept());
            use_memory_again();
            return wrong;
        });
}

TEST_CASE("13.3 rank 0 may send a tile to itself", "[13.3]") {
    // As the chapter's program does when it rehearses on a single rank.
    on_ranks(1, [](MPI_Comm ranks) {
        TileSender sender{ranks};
        sender.send(3, tile_of(3, small));
        std::optional<ArrivingTile> arrived;
        for (int i = 0; i < 500 && !arrived; ++i) {
            arrived = rt::receive_tile(ranks);
            std::this_thread::sleep_for(milliseconds{1});
        }
        if (!arrived) return std::string{"expected tile 3 from rank 0, actual no tile after 0.5 s"};
        MPI_Wait(&arrived->request, MPI_STATUS_IGNORE);
        sender.finish();
        if (arrived->tile == 3 && arrived->from == 0 && arrived->pixels == tile_of(3, small))
            return std::string{};
        return "expected tile 3 from rank 0, actual tile " + std::to_string(arrived->tile) +
               " from rank " + std::to_string(arrived->from) + ", or its pixels are wrong";
    });
}

TEST_CASE("13.3 receiving does not wait for a message", "[13.3]") {
    on_ranks(2, [](MPI_Comm ranks) {
        std::string wrong;
        TileSender sender{ranks};
        if (rt::rank_of(ranks) == 0 && rt::receive_tile(ranks))
            wrong = "no rank has sent anything: expected no tile, actual a tile";
        MPI_Barrier(ranks);
        if (rt::rank_of(ranks) == 0 && wrong.empty())
            wrong = receive(
                ranks, 1, [](int) { return small; }, from_rank_1);
        if (rt::rank_of(ranks) == 1) sender.send(1, tile_of(1, small));
        sender.finish();
        return wrong;
    });
}

TEST_CASE("13.3 receiving does not wait for the pixels", "[13.3]") {
    // Rank 1 stops in the middle of a message: it has begun to send, and makes no call of MPI.
    on_ranks(2, [](MPI_Comm ranks) {
        std::string wrong;
        if (rt::rank_of(ranks) == 1) {
            TileSender sender{ranks};
            sender.send(1, tile_of(1, 4 * large));
            std::this_thread::sleep_for(milliseconds{800});
            sender.finish();
            return wrong;
        }
        std::optional<ArrivingTile> arriving;
        double took = 0;
        for (const double begin = MPI_Wtime(); !arriving && MPI_Wtime() < begin + 2;) {
            const double call = MPI_Wtime();
            arriving = rt::receive_tile(ranks);
            took = MPI_Wtime() - call;
        }
        if (!arriving) return std::string{"expected tile 1 from rank 1, actual no tile after 2 s"};
        if (took > 0.4)
            wrong =
                "rank 1 stops for 0.8 s in the middle of its message: expected that receive_tile "
                "returns meanwhile, actual: it returned after " +
                std::to_string(took) +
                " s\nHint: MPI_Recv waits for the pixels; MPI_Irecv only begins to receive them";
        MPI_Wait(&arriving->request, MPI_STATUS_IGNORE);
        if (wrong.empty() && arriving->pixels != tile_of(1, 4 * large))
            wrong = "expected the pixels of tile 1 when the request is done, actual others";
        return wrong;
    });
}

TEST_CASE("13.3 messages that have been sent are forgotten", "[13.3][hard]") {
    on_ranks(2, [](MPI_Comm ranks) {
        constexpr int count = 40, late = 5;
        if (rt::rank_of(ranks) == 0) {
            const auto size_of = [](int tile) { return tile <= count ? large : small; };
            std::string wrong = receive(ranks, count - late, size_of, from_rank_1);
            MPI_Barrier(ranks);
            if (wrong.empty()) wrong = receive(ranks, late + 8, size_of, from_rank_1);
            return wrong;
        }
        TileSender sender{ranks};
        for (int tile = 1; tile <= count; ++tile) sender.send(tile, tile_of(tile, large));
        // They can be sent only while this rank is in a call of MPI.
        MPI_Barrier(ranks);
        int most = 0;
        for (int tile = count + 1; tile <= count + 8; ++tile) {
            sender.send(tile, tile_of(tile, small));
            most = sender.kept();
        }
        sender.finish();
        if (most < count / 2) return std::string{};
        return "rank 0 has received 35 of 40 tiles, and then 8 more are sent: expected hardly more "
               "than the other 5 and these 8 to be kept, actual " +
               std::to_string(most) +
               "\nHint: MPI_Test tells you of each message whether it has been sent; std::erase_if "
               "can then remove it";
    });
}
