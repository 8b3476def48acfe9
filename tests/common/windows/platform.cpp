#include <app/errors.hpp>
#include <app/files.hpp>
#include <app/interrupt.hpp>
#include <app/platform.hpp>
#include <csignal>
#include <system_error>
#include <thread>

#include "checkpoint.hpp"
#include "temporary_folder.hpp"

namespace fs = std::filesystem;
using checkpoint::read_file;
using checkpoint::TemporaryFolder;
using checkpoint::write_file;

TEST_CASE("replace_file makes a file, and replaces one, whatever their names", "[platform]") {
    const TemporaryFolder folder;
    for (const char* const name : {"a.ppm", "Jos\xc3\xa9 \xe4\xb8\xad.ppm"}) {
        const fs::path path = folder / name;
        app::replace_file(path, "first\n");
        CHECK(read_file(path) == "first\n");
        app::replace_file(path, std::string("2\0nd\r\n", 6));
        CHECK(read_file(path) == std::string("2\0nd\r\n", 6));
        CHECK(app::read_input_file(path, "it", 100) == std::string("2\0nd\r\n", 6));
    }
    CHECK(folder.count() == 2);
}

TEST_CASE("replace_file that fails leaves an older file and nothing else", "[platform]") {
    const TemporaryFolder folder;
    write_file(folder / "old.png", "old");
    fs::create_directory(folder / "folder.png");
    CHECK_THROWS_AS(app::replace_file(folder / "none/a.png", "x"), std::system_error);
    CHECK_THROWS_AS(app::replace_file(folder / "old.png/a.png", "x"), std::system_error);
    CHECK_THROWS_AS(app::replace_file(folder / "folder.png", "x"), std::system_error);
    CHECK(read_file(folder / "old.png") == "old");
    CHECK(folder.count() == 2);
}

TEST_CASE("a file is replaced as soon as nobody reads it", "[platform]") {
    const TemporaryFolder folder;
    const fs::path path = folder / "a.ppm";
    app::replace_file(path, "old");
    std::ifstream viewer{path, std::ios::binary};
    REQUIRE(viewer);
    std::thread closing{[&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        viewer.close();
    }};
    app::replace_file(path, "new");
    closing.join();
    CHECK(read_file(path) == "new");
    CHECK(folder.count() == 1);
}

TEST_CASE("a reader sees the old file or the new one, never a part", "[platform]") {
    const TemporaryFolder folder;
    const fs::path path = folder / "a.ppm";
    const std::string a(300'000, 'a'), b(200'000, 'b');
    app::replace_file(path, a);
    std::thread writer{[&] {
        for (int i = 0; i < 50; ++i) app::replace_file(path, i % 2 ? a : b);
    }};
    int parts = 0;
    for (int i = 0; i < 50; ++i) {
        const std::string seen = read_file(path);
        parts += seen != a && seen != b && !seen.empty();  // empty: it could not be opened
    }
    writer.join();
    CHECK(parts == 0);
    CHECK(folder.count() == 1);
}

TEST_CASE("the first Ctrl-C is noted, and does not end the program", "[platform]") {
    const auto before = std::signal(SIGINT, SIG_DFL);
    {
        const app::Interruption interruption;
        CHECK(app::Interruption::signal() == 0);
        std::raise(SIGINT);
        CHECK(app::Interruption::signal() == SIGINT);
    }
    CHECK(std::signal(SIGINT, before) == SIG_DFL);
}

TEST_CASE("every kind of error has its exit code", "[platform]") {
    CHECK(app::run_or_explain("program", [] { return 3; }) == 3);
    CHECK(app::run_or_explain("program", []() -> int { throw app::UsageError("wrong"); }) == 2);
    CHECK(app::run_or_explain("program", []() -> int { throw app::Failure("disk"); }) == 1);
}

TEST_CASE("a file is no terminal", "[platform]") {
    const TemporaryFolder folder;
    std::FILE* const file = app::open_for_writing(folder / "a", true);
    REQUIRE(file);
    CHECK_FALSE(app::is_terminal(file));
    std::fclose(file);
    CHECK_FALSE(app::open_for_writing(folder / "a", true));
    CHECK(app::is_writable(folder / "a"));
    CHECK(app::is_writable(folder.path()));
}
