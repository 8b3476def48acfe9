#include <stb_image.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <rt/image_file.hpp>
#include <system_error>
#include <thread>

#include "checkpoint.hpp"
#include "temporary_folder.hpp"

namespace fs = std::filesystem;
using checkpoint::read_file;
using checkpoint::Real;
using checkpoint::TemporaryFolder;
using checkpoint::write_file;
using rt::Color;
using rt::Image;

namespace {

// The bytes of a decoded image, row by row.
std::vector<int> decode(const std::string& file, int& width, int& height) {
    int channels = 0;
    stbi_uc* const pixels =
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(file.data()),
                              static_cast<int>(file.size()), &width, &height, &channels, 0);
    REQUIRE(pixels);
    CHECK(channels == 3);
    const std::vector<int> bytes(pixels, pixels + width * height * channels);
    stbi_image_free(pixels);
    return bytes;
}

// Every byte value occurs, and no two rows or columns are the same.
Image test_image() {
    return rt::make_image(61, 43, [](int x, int y) {
        const auto hex = static_cast<std::uint32_t>((x * 4 % 256) << 16 | (y * 5 % 256) << 8 |
                                                    ((x * 7 + y * 13) % 256));
        return rt::from_hex(hex);
    });
}

void check_decoded(const std::string& file) {
    const Image image = test_image();
    int width = 0, height = 0;
    const std::vector<int> bytes = decode(file, width, height);
    CHECK(width == image.width());
    CHECK(height == image.height());
    std::vector<int> expected;
    for (const Color& c : image.pixels())
        for (const Real channel : {c.r, c.g, c.b}) expected.push_back(rt::to_byte(channel));
    CHECK(bytes == expected);
}

}  // namespace

TEST_CASE("a PNG file holds the image, as another program reads it", "[image_file]") {
    check_decoded(rt::encode_png(test_image()));
}

TEST_CASE("a PPM file holds the image, as another program reads it", "[image_file]") {
    check_decoded(rt::encode_ppm(test_image()));
}

TEST_CASE("a PPM file is its heading and three bytes a pixel", "[image_file]") {
    Image image{2, 1, {1, 1, 1}};
    image.at(1, 0) = {0, Real(0.5), 2};
    CHECK(rt::encode_ppm(image) == std::string("P6\n2 1\n255\n\xff\xff\xff\x00\xbc\xff", 17));
}

TEST_CASE("a color that is not finite reaches no file", "[image_file]") {
    for (const Real bad : {std::numeric_limits<Real>::quiet_NaN(), rt::infinity}) {
        Image image{3, 3};
        image.at(2, 2) = {0, 0, bad};
        CHECK_THROWS_AS(rt::encode_png(image), std::logic_error);
        CHECK_THROWS_AS(rt::encode_ppm(image), std::logic_error);
    }
}

TEST_CASE("replace_file makes a file, and replaces one", "[image_file]") {
    const TemporaryFolder folder;
    rt::replace_file(folder / "a.ppm", "first");
    CHECK(read_file(folder / "a.ppm") == "first");
    rt::replace_file(folder / "a.ppm", std::string("2\0nd", 4));
    CHECK(read_file(folder / "a.ppm") == std::string("2\0nd", 4));
    CHECK(folder.count() == 1);
}

TEST_CASE("replace_file keeps a file's permissions", "[image_file]") {
    const TemporaryFolder folder;
    write_file(folder / "a.png", "old");
    const auto wanted = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read;
    fs::permissions(folder / "a.png", wanted);
    rt::replace_file(folder / "a.png", "new");
    CHECK(fs::status(folder / "a.png").permissions() == wanted);
}

TEST_CASE("replace_file goes through links", "[image_file]") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "deep");
    fs::create_symlink("deep/target.png", folder / "link.png");
    fs::create_symlink("link.png", folder / "link to link.png");
    for (const char* const text : {"not there yet", "there"}) {
        rt::replace_file(folder / "link to link.png", text);
        CHECK(fs::is_symlink(folder / "link.png"));
        CHECK(read_file(folder / "deep/target.png") == text);
    }
    CHECK(folder.count() == 3);
}

TEST_CASE("replace_file that fails leaves an older file and nothing else", "[image_file]") {
    const TemporaryFolder folder;
    write_file(folder / "old.png", "old");
    fs::create_directory(folder / "folder.png");
    fs::create_symlink("loop.png", folder / "loop.png");
    CHECK_THROWS_AS(rt::replace_file(folder / "none/a.png", "x"), std::system_error);
    CHECK_THROWS_AS(rt::replace_file(folder / "old.png/a.png", "x"), std::system_error);
    CHECK_THROWS_AS(rt::replace_file(folder / "folder.png", "x"), std::system_error);
    CHECK_THROWS_AS(rt::replace_file(folder / "loop.png", "x"), std::system_error);
    if (fs::exists("/dev/full")) {
        CHECK_THROWS_AS(rt::replace_file("/dev/full", "x"), std::system_error);
        CHECK_THROWS_AS(rt::replace_file("/dev/full", std::string(100'000, 'x')),
                        std::system_error);
    }
    CHECK(read_file(folder / "old.png") == "old");
    CHECK(folder.count() == 3);
}

TEST_CASE("a reader sees the old file or the new one, never a part", "[image_file]") {
    const TemporaryFolder folder;
    const fs::path path = folder / "a.ppm";
    const std::string a(300'000, 'a'), b(200'000, 'b');
    rt::replace_file(path, a);
    std::thread writer{[&] {
        for (int i = 0; i < 100; ++i) rt::replace_file(path, i % 2 ? a : b);
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

TEST_CASE("an interruption leaves no part of a file", "[image_file]") {
    const TemporaryFolder folder;
    const fs::path path = folder / "a.ppm";
    for (int i = 0; i < 5; ++i) {
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            std::signal(SIGTERM, SIG_DFL);
            const std::string bytes(8'000'000, 'x');
            for (;;) rt::replace_file(path, bytes);
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
