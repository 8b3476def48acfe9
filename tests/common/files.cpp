#include <app/errors.hpp>
#include <app/files.hpp>
#include <system_error>
#include <thread>

#include "checkpoint.hpp"
#include "temporary_folder.hpp"

namespace fs = std::filesystem;
using checkpoint::read_file;
using checkpoint::TemporaryFolder;
using checkpoint::write_file;

TEST_CASE("replace_file makes a file, and replaces one, whatever their names", "[files]") {
    const TemporaryFolder folder;
    for (const char* const name : {"a.ppm", "Jos\xc3\xa9 \xe4\xb8\xad.ppm"}) {
        const fs::path path = folder / name;
        app::replace_file(path, "first\n");
        CHECK(read_file(path) == "first\n");
        const std::string second("2\0nd\r\n", 6);
        app::replace_file(path, second);
        CHECK(read_file(path) == second);
        CHECK(app::read_input_file(path, "it", 100) == second);
    }
    CHECK(folder.count() == 2);
}

TEST_CASE("replace_file that fails leaves an older file and nothing else", "[files]") {
    const TemporaryFolder folder;
    write_file(folder / "old.png", "old");
    fs::create_directory(folder / "folder.png");
    CHECK_THROWS_AS(app::replace_file(folder / "none/a.png", "x"), std::system_error);
    CHECK_THROWS_AS(app::replace_file(folder / "old.png/a.png", "x"), std::system_error);
    CHECK_THROWS_AS(app::replace_file(folder / "folder.png", "x"), std::system_error);
    CHECK(read_file(folder / "old.png") == "old");
    CHECK(folder.count() == 2);
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
        std::ifstream in{path, std::ios::binary};
        const bool is_windows = fs::path::preferred_separator == '\\';
        if (!in && is_windows) continue;  // which opens no file while it is being replaced
        const std::string seen{std::istreambuf_iterator<char>{in}, {}};
        parts += seen != a && seen != b;
    }
    writer.join();
    CHECK(parts == 0);
    CHECK(folder.count() == 1);
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
