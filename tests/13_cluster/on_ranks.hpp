#pragma once
// Test cases on several ranks. The program of a checkpoint starts itself again under mpirun, once
// for all of its test cases. Each rank runs all of them, and leaves what it finds in files; the
// first program reads these, and gives up on ranks that hang.

#include <sched.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <rt/ranks.hpp>
#include <rt/todo.hpp>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "checkpoint.hpp"

// While a rank waits, Open MPI calls this in a loop. A rank that has waited for long probably
// hangs. It sleeps, so that it does not keep a core busy until we give up on it. Open MPI calls
// this in each MPI_Test, too. On a busy machine, a rank that leaves its core gets it back only
// milliseconds later, so the first calls do nothing.
inline int yields = 0;  // since the latest work began
extern "C" int sched_yield() noexcept {
    if (++yields < 1'000) return 0;
    if (yields < 10'000) return static_cast<int>(::syscall(SYS_sched_yield));
    const timespec moment{0, 2'000'000};
    return ::nanosleep(&moment, nullptr);
}

namespace checkpoint {

inline constexpr int most_ranks = 4;

// What a rank does in a test case: returns what is wrong, empty if nothing is.
using RankWork = std::function<std::string(MPI_Comm ranks)>;

namespace ranks {

namespace fs = std::filesystem;

// Where ranks leave what they find; null in the first program.
inline const char* folder_of_ranks() {
    return std::getenv("COURSE_RANKS_FOLDER");
}

// "0", "0 something is wrong", ...: how a rank's work ended.
constexpr char is_right = '0', is_wrong = '1', is_unwritten = '2';

// Files of one call of on_ranks.
inline fs::path begun(const fs::path& folder, const std::string& call) {
    return folder / (call + ".begun");
}
inline fs::path ended(const fs::path& folder, const std::string& call, int rank) {
    return folder / (call + '.' + std::to_string(rank));
}
// Grows with each call that is begun.
inline fs::path progress(const fs::path& folder) {
    return folder / "progress";
}
inline void leave(const fs::path& file, const std::string& words) {
    std::ofstream{file.string() + ".part"} << words;
    fs::rename(file.string() + ".part", file);
}

// In a rank: MPI, from the first call to the program's end.
class Mpi {
  public:
    Mpi() { MPI_Init(nullptr, nullptr); }
    ~Mpi() { MPI_Finalize(); }
    Mpi(const Mpi&) = delete;
    Mpi& operator=(const Mpi&) = delete;
};

inline void work_as_rank(const std::string& call, int count, const RankWork& work) {
    static const Mpi mpi;
    const fs::path folder = folder_of_ranks();
    // Numbered backward in the group: so it shows if an answer asks MPI_COMM_WORLD instead.
    const int rank = most_ranks - 1 - rt::rank_of(MPI_COMM_WORLD);
    MPI_Comm group = MPI_COMM_NULL;
    MPI_Comm_split(MPI_COMM_WORLD, rank < count ? 0 : MPI_UNDEFINED, rank, &group);
    if (rank == 0) {
        leave(begun(folder, call), "");
        std::ofstream{progress(folder), std::ios::app} << '.';
    }
    if (rank < count) {
        yields = 0;
        std::string words{is_right};
        try {
            const std::string wrong = work(group);
            if (!wrong.empty()) words = is_wrong + wrong;
        } catch (const rt::NotImplemented& todo) {
            words = is_unwritten + std::string{todo.what()};
        } catch (const std::exception& error) {
            words = is_wrong + std::string{"an exception: "} + error.what();
        }
        leave(ended(folder, call, rank), words);
    }
    yields = 0;
    // A rank that is done waits for the others, so that one that hangs is found in its own test
    // case.
    MPI_Barrier(MPI_COMM_WORLD);
}

// The ranks, while they run.
class Group {
  public:
    Group() : folder_{fs::temp_directory_path() / ("ranks." + std::to_string(::getpid()))} {}
    ~Group() { stop(); }
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;

    // What the ranks of a call left, after they have ended or it makes no sense to wait any longer.
    std::vector<std::optional<std::string>> results(const std::string& test,
                                                    const std::string& call, int count) {
        if (!is_started_) start("");
        if (is_stuck_ || (!only_.empty() && only_ != test)) start(test);
        is_stuck_ = !wait(call, count);
        if (is_stuck_ && only_.empty() && !fs::exists(begun(folder_, call))) {
            // In another test case, which may not even be asked for.
            start(test);
            is_stuck_ = !wait(call, count);
        }
        return all_of(call, count);
    }

    void stop() {
        if (process_ >= 0) {
            // mpirun ends its ranks, unless it has no time to.
            ::kill(-process_, SIGTERM);
            for (int i = 0; i < 100 && !has_ended(); ++i) pause();
            if (process_ >= 0) {
                ::kill(-process_, SIGKILL);
                ::waitpid(process_, nullptr, 0);
                process_ = -1;
            }
        }
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

  private:
    // In pauses, 5 and 20 seconds or more: if the machine pauses, only one of them is lost. Once a
    // rank has found something wrong, it is clear that the test case fails, and the others have
    // half a second.
    static constexpr int patience = 2500, patience_at_start = 10'000, patience_if_wrong = 250;

    static void pause() { std::this_thread::sleep_for(std::chrono::milliseconds{2}); }

    bool has_ended() {
        if (process_ >= 0 && ::waitpid(process_, nullptr, WNOHANG) == process_) process_ = -1;
        return process_ < 0;
    }

    // For all test cases, or for this one.
    void start(const std::string& test) {
        stop();
        fs::create_directories(folder_);
        is_started_ = true;
        only_ = test;
        const std::string program = fs::read_symlink("/proc/self/exe");
        const std::string count = std::to_string(most_ranks);
        const std::map<std::string, std::string> environment{
            {"COURSE_RANKS_FOLDER", folder_},
            {"OMPI_ALLOW_RUN_AS_ROOT", "1"},
            {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"},
            {"OMPI_MCA_rmaps_base_oversubscribe", "1"},
            {"OMPI_MCA_mpi_yield_when_idle", "1"},
            // The ranks share this machine's memory. Looking for networks would take a quarter of a
            // second.
            {"OMPI_MCA_pml", "ob1"},
            {"OMPI_MCA_btl", "self,vader"},
            // As the chapter's program does: one more kind of window for memory of one's own.
            {"OMPI_MCA_osc", "sm,pt2pt"},
            // Containers may not read each other's memory.
            {"OMPI_MCA_btl_vader_single_copy_mechanism", "none"}};
        process_ = ::fork();
        if (process_ != 0) return;
        ::setpgid(0, 0);
        for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
        if (!std::freopen("/dev/null", "r", stdin) || !std::freopen("/dev/null", "w", stdout) ||
            !std::freopen("/dev/null", "w", stderr))
            ::_exit(1);
        for (int file = 3; file < 64; ++file) ::close(file);
        std::vector<const char*> words{COURSE_MPIEXEC, "-n", count.c_str(), program.c_str()};
        if (!test.empty()) words.push_back(only_.c_str());
        words.push_back(nullptr);
        ::execv(words[0], const_cast<char* const*>(words.data()));
        ::_exit(127);
    }

    std::vector<std::optional<std::string>> all_of(const std::string& call, int count) const {
        std::vector<std::optional<std::string>> all;
        for (int rank = 0; rank < count; ++rank) {
            std::ifstream in{ended(folder_, call, rank)};
            std::ostringstream words;
            if (in) words << in.rdbuf();
            all.push_back(in ? std::optional{words.str()} : std::nullopt);
        }
        return all;
    }

    // Whether all of them ended. Waits as long as the ranks go from one call to the next.
    bool wait(const std::string& call, int count) {
        std::uintmax_t latest = 0;
        for (int waited = 0;; ++waited) {
            const bool ended_before = has_ended();
            const auto all = all_of(call, count);
            const bool complete = std::ranges::all_of(all, [](auto& words) { return !!words; });
            if (complete || ended_before) return complete;
            const bool wrong = std::ranges::any_of(
                all, [](auto& words) { return words && words->front() != is_right; });
            std::error_code none;
            const std::uintmax_t size = fs::file_size(progress(folder_), none);
            if (!none && size != latest) {
                latest = size;
                waited = 0;
            }
            if (waited > (wrong ? patience_if_wrong : latest == 0 ? patience_at_start : patience))
                return false;
            pause();
        }
    }

    fs::path folder_;
    pid_t process_ = -1;
    bool is_started_ = false, is_stuck_ = false;
    std::string only_;  // the test case that runs alone
};

// The stub's exception, as a rank told of it.
[[noreturn]] inline void throw_unwritten(const std::string& words) {
    // exercise 13.1 is still to be written: FILE:LINE, explained in ...
    const auto after = [&](const char* mark) {
        return words.find(mark) + std::string{mark}.size();
    };
    const auto file = after("written: "), id = after("exercise ");
    const auto colon = words.find(':', file);
    throw rt::NotImplemented{words.substr(id, words.find(' ', id) - id),
                             words.substr(file, colon - file), std::atoi(&words[colon + 1])};
}

}  // namespace ranks

// Does this work on ranks 0 ... count - 1 of a group of their own, at most most_ranks. Fails with
// what the first rank finds wrong.
inline void on_ranks(int count, const RankWork& work) {
    const std::string test = Catch::getResultCapture().getCurrentTestName();
    static std::map<std::string, int> calls;
    std::string call = test + ' ' + std::to_string(calls[test]++);
    for (char& letter : call)
        if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
    if (ranks::folder_of_ranks()) return ranks::work_as_rank(call, count, work);

    static ranks::Group group;
    const auto all = group.results(test, call, count);
    std::string wrong;
    for (int rank = 0; rank < count; ++rank) {
        const auto& words = all[static_cast<std::size_t>(rank)];
        if (words && words->front() == ranks::is_unwritten) ranks::throw_unwritten(*words);
        if (words && words->front() == ranks::is_wrong && wrong.empty())
            wrong = "On rank " + std::to_string(rank) + " of " + std::to_string(count) + ": " +
                    words->substr(1);
    }
    for (int rank = 0; rank < count && wrong.empty(); ++rank)
        if (!all[static_cast<std::size_t>(rank)])
            wrong = "Rank " + std::to_string(rank) + " of " + std::to_string(count) +
                    " did not finish: it crashed, or it is still waiting for another rank.\nHint: "
                    "do all ranks make the same calls, in the group `ranks` and not in "
                    "MPI_COMM_WORLD? Is each message received?";
    if (!wrong.empty()) FAIL(wrong);
    SUCCEED();
}

}  // namespace checkpoint
