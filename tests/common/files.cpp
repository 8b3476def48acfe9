#include <sys/wait.h>
#include <unistd.h>

#include <app/errors.hpp>
#include <app/files.hpp>
#include <csignal>
#include <system_error>
#include <thread>

#include "checkpoint.hpp"
#include "temporary_folder.hpp"

namespace fs = std::filesystem;
using checkpoint::read_file;
using checkpoint::TemporaryFolder;
using checkpoint::write_file;

TEST_CASE("replace_file makes a file, and replaces one", "[files]") {
    const TemporaryFolder folder;
    app::replace_file(folder / "a.ppm", "first");
    CHECK(read_file(folder / "a.ppm") == "first");
    app::replace_file(folder / "a.ppm", std::string("2\0nd", 4));
    CHECK(read_file(folder / "a.ppm") == std::string("2\0nd", 4));
    CHECK(folder.count() == 1);
}

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

TEST_CASE("replace_file that fails leaves an older file and nothing else", "[files]") {
    const TemporaryFolder folder;
    write_file(folder / "old.png", "old");
    fs::create_directory(folder / "folder.png");
    fs::create_symlink("loop.png", folder / "loop.png");
    CHECK_THROWS_AS(app::replace_file(folder / "none/a.png", "x"), std::system_error);
    CHECK_THROWS_AS(app::replace_file(folder / "old.png/a.png", "x"), std::system_error);
    CHECK_THROWS_AS(app::replace_file(folder / "folder.png", "x"), std::system_error);
    CHECK_THROWS_AS(app::replace_file(folder / "loop.png", "x"), std::system_error);
    if (fs::exists("/dev/full")) {
        CHECK_THROWS_AS(app::replace_file("/dev/full", "x"), std::system_error);
        CHECK_THROWS_AS(app::replace_file("/dev/full", std::string(100'000, 'x')),
                        std::system_error);
    }
    CHECK(read_file(folder / "old.png") == "old");
    CHECK(folder.count() == 3);
}

TEST_CASE("a reader sees the old file or the new one, never a part", "[files]") {
    const TemporaryFolder folder;
    const fs::path path = folder / "a.ppm";
    const std::string a(300'000, 'a'), b(200'000, 'b');
    app::replace_file(path, a);
    std::thread writer{[&] {
        for (int i = 0; i < 100; ++i) app::replace_file(path, i % 2 ? a : b);
    }};
    int parts = 0;
    for (int i = 0; i < 100; ++i) {
        const std::string seen = read_file(path);
        parts += seen != a && seen != b;
    }
    writer.join();
    CHECK(parts == 0);
    CHECK(folder.count() == 1);
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

TEST_CASE("make_folder makes a folder and those around it, and says where it cannot", "[files]") {
    const TemporaryFolder folder;
    for (int i = 0; i < 2; ++i) {
        app::make_folder(folder / "a/b");
        CHECK(fs::is_directory(folder / "a/b"));
    }
    write_file(folder / "file", "");
    CHECK_THROWS_AS(app::make_folder(folder / "file/b"), app::Failure);
}
