#pragma once
// The finished tiles of a picture, in a file on rank 0's disk (13.4).

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <future>
#include <rt/saved_tiles.hpp>
#include <string>
#include <vector>

namespace cluster {

namespace fs = std::filesystem;

// An open file or folder.
class Descriptor {
  public:
    // Throws app::Failure if it cannot be opened. A link is not followed.
    Descriptor(const fs::path& path, int flags)
        : number_{::open(path.c_str(), flags | O_CLOEXEC | O_NOFOLLOW, 0666)} {
        if (number_ < 0)
            throw app::Failure(path.string() + " cannot be opened: " + std::strerror(errno));
    }
    ~Descriptor() { ::close(number_); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return number_; }

  private:
    int number_;
};

// No two runs have a lock for the same file at a time.
class Lock {
  public:
    // Throws app::Failure, which says who has the lock, if another run has it.
    explicit Lock(const fs::path& file)
        : file_{file.string() + ".lock"}, open_{file_, O_RDWR | O_CREAT} {
        const bool has_other =
            ::flock(open_.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        struct stat status {};
        ::fstat(open_.number(), &status);
        if (has_other || status.st_nlink == 0) {  // just removed by the other run
            std::string who = "it has just ended";
            std::getline(std::ifstream{file_}, who);
            throw app::Failure("another run of the same command has its tiles in " + file.string() +
                               " (" + who + "); wait until it has ended");
        }
        std::array<char, 256> host{};
        ::gethostname(host.data(), host.size() - 1);
        std::ofstream{file_} << "process " << ::getpid() << " on " << host.data() << '\n';
    }
    ~Lock() { ::unlink(file_.c_str()); }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

  private:
    std::string file_;
    Descriptor open_;
};

// The file of a picture's finished tiles. While an object of this class exists, no other run uses
// the file.
class TileStore {
  public:
    // Creates the file, in a folder that exists, if it is missing. Throws app::Failure if that
    // fails, or if another run uses the file.
    TileStore(const fs::path& file, const rt::TilePlaces& places)
        : file_{file},
          places_{places},
          lock_{file},
          open_{file, O_RDWR | O_CREAT},
          out_{file, std::ios::binary | std::ios::in} {
        // Should the power fail, the file is still in its folder, and the folder in its own.
        const fs::path folder = file.parent_path();
        for (const fs::path& path : {folder, folder / ".."})
            ::fsync(Descriptor{path, O_RDONLY | O_DIRECTORY}.number());
    }

    // Hands over the tiles that earlier runs have finished, and returns the numbers of the others.
    std::vector<int> restore(const rt::PutTile& put) {
        std::ifstream in{file_, std::ios::binary};
        std::vector<int> missing = restore_tiles(in, places_, put);
        damaged_ = static_cast<int>(
            std::ranges::count_if(missing, [&](int tile) { return was_written(in, tile); }));
        return missing;
    }

    // The number of tiles that were written once, but are no longer whole.
    int damaged() const { return damaged_; }

    // Throws std::runtime_error if the tile cannot be written.
    void save(int tile, const std::vector<rt::Color>& pixels) {
        save_tile(out_, places_, tile, pixels);
        // The system has the tile now, and writes it to the disk meanwhile.
        using namespace std::chrono_literals;
        if (writing_.valid() && writing_.wait_for(0s) != std::future_status::ready) return;
        if (writing_.valid() && writing_.get() != 0) throw std::runtime_error("the disk is full");
        writing_ = std::async(std::launch::async, [&] { return ::fdatasync(open_.number()); });
    }

    // Removes the file: the picture is finished.
    void remove() { ::unlink(file_.c_str()); }

    const fs::path& file() const { return file_; }

  private:
    bool was_written(std::istream& in, int tile) const {
        std::vector<char> bytes(sizeof(std::uint64_t) + places_.pixels(tile) * sizeof(rt::Color));
        in.clear();
        in.seekg(places_.begin(tile));
        in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return std::any_of(bytes.begin(), bytes.begin() + in.gcount(),
                           [](char byte) { return byte != 0; });
    }

    fs::path file_;
    rt::TilePlaces places_;
    Lock lock_;
    Descriptor open_;
    std::ofstream out_;
    int damaged_ = 0;
    std::future<int> writing_;  // ends before the file is closed
};

}  // namespace cluster
