#include <sys/wait.h>
#include <unistd.h>

#include <app/files.hpp>
#include <csignal>
#include <system_error>

#include "checkpoint.hpp"
#include "temporary_folder.hpp"

namespace fs = std::filesystem;
using checkpoint::read_file;
using checkpoint::TemporaryFolder;
using checkpoint::write_file;

TEST_CASE("replace_file keeps a file's permissions", "[files]") {
    const TemporaryFolder folder;
    write_file(folder / "a.png", "old");
    const auto wanted = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read;
    fs::permissions(folder / "a.png", wanted);
    app::replace_file(folder / "a.png", "new");
    CHECK(fs::status(folder / "a.png").permissions() == wanted);
}

TEST_CASE("replace_file goes through links", "[files]") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "deep");
    fs::create_symlink("deep/target.png", folder / "link.png");
    fs::create_symlink("link.png", folder / "link to link.png");
    for (const char* const text : {"not there yet", "there"}) {
        app::replace_file(folder / "link to link.png", text);
        CHECK(fs::is_symlink(folder / "link.png"));
        CHECK(read_file(folder / "deep/target.png") == text);
    }
    CHECK(folder.count() == 3);
}

TEST_CASE("replace_file fails where links form a circle, and where a disk is full", "[files]") {
    const TemporaryFolder folder;
    fs::create_symlink("loop.png", folder / "loop.png");
    CHECK_THROWS_AS(app::replace_file(folder / "loop.png", "x"), std::system_error);
    CHECK(folder.count() == 1);
    if (fs::exists("/dev/full")) {
        CHECK_THROWS_AS(app::replace_file("/dev/full", "x"), std::system_error);
        CHECK_THROWS_AS(app::replace_file("/dev/full", std::string(100'000, 'x')),
                        std::system_error);
    }
}

TEST_CASE("an interruption leaves no part of a file", "[files]") {
    const TemporaryFolder folder;
    const fs::path path = folder / "a.ppm";
    for (int i = 0; i < 5; ++i) {
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            std::signal(SIGTERM, SIG_DFL);
            const std::string bytes(8'000'000, 'x');
            for (;;) app::replace_file(path, bytes);
        }
        while (folder.count() == 0) ::usleep(100);
        ::usleep(500 * static_cast<unsigned>(i));
        ::kill(child, SIGTERM);
        int status = 0;
        REQUIRE(::waitpid(child, &status, 0) == child);
        CHECK(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == SIGTERM);
        for (const auto& left : fs::directory_iterator{folder.path()})
            CHECK(left.path().filename() == "a.ppm");
        fs::remove(path);
    }
}
