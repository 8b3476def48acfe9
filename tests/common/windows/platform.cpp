#include <app/files.hpp>
#include <app/platform.hpp>
#include <app/windows/exact_math.hpp>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <rt/rng.hpp>
#include <thread>

#include "checkpoint.hpp"
#include "temporary_folder.hpp"

namespace fs = std::filesystem;
using checkpoint::read_file;
using checkpoint::TemporaryFolder;

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

TEST_CASE("a product and a sum are rounded once, with an instruction for it or without",
          "[platform]") {
    // MinGW's library gives 0x1.9e3ed27b3e596p-2.
    CHECK(std::fma(-0x1.a0414d6c909ap-5, -0x1.d729f50de481ap-2, -0x1.b62fb56e282c8p-2) ==
          -0x1.9e3ed27b3e595p-2);
    if (!__builtin_cpu_supports("fma")) return;
    rt::Rng rng{1, 1};
    const auto bits = [&] { return std::uint64_t{rng()} << 32 | rng(); };
    // Of all sizes, or near one exponent: at 2^-530 products are subnormal.
    const auto number = [&](int kind, int exponent) {
        return kind == 0 ? std::bit_cast<double>(bits())
                         : std::ldexp(static_cast<double>(static_cast<std::int64_t>(bits())),
                                      exponent + static_cast<int>(rng() % 60) - 93);
    };
    int wrong = 0, wrong_in_float = 0;
    const auto differ = [](auto a, auto b) { return a != b && !(a != a && b != b); };
    for (int i = 0; i < 300'000; ++i) {
        const double x = number(i % 3, i % 3 == 1 ? 0 : -520),
                     y = number(i % 3, i % 3 == 1 ? 0 : -520);
        const double z = i % 5 == 0 ? -x * y : number(i % 3, i % 3 == 1 ? 0 : -1050);
        wrong += differ(std::fma(x, y, z), app::fma_of_integers(x, y, z));
        const auto a = static_cast<float>(x), b = static_cast<float>(y), c = static_cast<float>(z);
        wrong_in_float += differ(std::fma(a, b, c), app::fma_of_doubles(a, b, c));
    }
    CHECK(wrong == 0);
    CHECK(wrong_in_float == 0);
}

TEST_CASE("a root is rounded once", "[platform]") {
    // Its square lies between that of the number before it and its own, so only one of them is
    // right.
    rt::Rng rng{2, 1};
    double (*volatile root)(double) = std::sqrt;
    int wrong = 0;
    for (int i = 0; i < 300'000; ++i) {
        const double x = 1 + 3 * std::ldexp(static_cast<double>(rng()), -32) +
                         std::ldexp(static_cast<double>(rng()), -52),
                     r = root(x);
        const double half_up = std::fma(r, r, -x), unit = std::numeric_limits<double>::epsilon();
        wrong += std::abs(half_up) > r * unit;  // |r^2 - x| <= 2 r (unit / 2)
    }
    CHECK(wrong == 0);
}
