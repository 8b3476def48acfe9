#pragma once
// What the ranks say to each other when no new tile is left. Tiles that are out are then given out
// again, in case a rank is slow or hangs: whichever copy arrives first counts. Tiles themselves
// travel as in 13.3; all other messages have a group of their own, where receive_tile does not find
// them.

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <rt/ranks.hpp>
#include <thread>
#include <utility>
#include <vector>

namespace cluster {

// How long a rank stays away from MPI while its threads draw. Messages travel only while their
// sender and their receiver are in calls of MPI, and over some networks, the counter waits for rank
// 0 to be in one.
constexpr std::chrono::microseconds time_away{100};

// The group of these messages. All ranks must make the first call together.
inline MPI_Comm talk() {
    static const MPI_Comm group = [] {
        MPI_Comm made{};
        MPI_Comm_dup(MPI_COMM_WORLD, &made);
        return made;
    }();
    return group;
}

// The tags of messages to rank 0. A farewell holds the number of rays.
constexpr int question = 1, farewell = 2;
// What the others get in place of a tile.
constexpr int picture_is_finished = -1;

// A rank other than rank 0, as it talks to rank 0.
class Helper {
  public:
    // Returns a tile that is out, or none if rank 0 has not answered yet. Rank 0 is asked a hundred
    // times a second at most.
    std::optional<int> outstanding() {
        const auto now = std::chrono::steady_clock::now();
        if (!has_asked_ && now >= next_question_) {
            MPI_Send(nullptr, 0, MPI_INT, 0, question, talk());
            has_asked_ = true;
            next_question_ = now + std::chrono::milliseconds{10};
        }
        return std::exchange(answer_, {});
    }

    // Whether rank 0 has said that the picture is finished.
    bool is_dismissed() {
        int is_there = 0;
        MPI_Iprobe(0, MPI_ANY_TAG, talk(), &is_there, MPI_STATUS_IGNORE);
        if (!is_there) return false;
        int tile = 0;
        MPI_Recv(&tile, 1, MPI_INT, 0, MPI_ANY_TAG, talk(), MPI_STATUS_IGNORE);
        if (tile == picture_is_finished) return true;
        answer_ = tile;
        has_asked_ = false;
        return false;
    }

    void say_farewell(std::uint64_t rays) { MPI_Send(&rays, 1, MPI_UINT64_T, 0, farewell, talk()); }

  private:
    bool has_asked_ = false;
    std::chrono::steady_clock::time_point next_question_{};
    std::optional<int> answer_;
};

// The other ranks, as rank 0 talks to them.
class Helpers {
  public:
    // Answers all questions with tiles that are out, as long as there are any.
    void answer(const std::function<std::optional<int>()>& outstanding) {
        while (const std::optional<int> rank = next_message(question)) {
            MPI_Recv(nullptr, 0, MPI_INT, *rank, question, talk(), MPI_STATUS_IGNORE);
            if (const std::optional<int> tile = outstanding())
                MPI_Send(&*tile, 1, MPI_INT, *rank, 0, talk());
        }
    }

    // Tells all other ranks that the picture is finished, and waits until they have said farewell.
    // Meanwhile, calls serve() again and again. Returns the ranks that have not said farewell after
    // `patience`.
    template <class Serve>
    std::vector<int> dismiss(std::chrono::seconds patience, const Serve& serve) {
        std::vector<int> here;
        for (int rank = 1; rank < rt::rank_count(talk()); ++rank) {
            here.push_back(rank);
            MPI_Send(&picture_is_finished, 1, MPI_INT, rank, 0, talk());
        }
        const auto end = std::chrono::steady_clock::now() + patience;
        while (!here.empty() && std::chrono::steady_clock::now() < end) {
            serve();
            while (const std::optional<int> rank = next_message(farewell)) {
                std::uint64_t rays = 0;
                MPI_Recv(&rays, 1, MPI_UINT64_T, *rank, farewell, talk(), MPI_STATUS_IGNORE);
                rays_ += rays;
                std::erase(here, *rank);
            }
            std::this_thread::sleep_for(time_away);
        }
        return here;
    }

    // The rays of all ranks that have said farewell.
    std::uint64_t rays() const { return rays_; }

  private:
    // The sender of a message with this tag, if there is one.
    static std::optional<int> next_message(int tag) {
        int is_there = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, tag, talk(), &is_there, &status);
        if (!is_there) return {};
        return status.MPI_SOURCE;
    }

    std::uint64_t rays_ = 0;
};

}  // namespace cluster
