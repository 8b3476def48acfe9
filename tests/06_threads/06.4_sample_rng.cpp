#include <algorithm>
#include <cstdint>
#include <rt/image.hpp>
#include <rt/lambertian.hpp>
#include <rt/make_camera.hpp>
#include <rt/path.hpp>
#include <rt/primary_ray.hpp>
#include <rt/sample_rng.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>
#include <rt/strategies.hpp>
#include <string>
#include <unordered_set>

#include "checkpoint.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Color, rt::Image, rt::Rng, rt::TileGrid, rt::average_samples, rt::sample_rng;

namespace {

struct Key {
    std::uint64_t seed;
    int x, y, sample;
};

std::string text(const Key& k) {
    return "seed " + std::to_string(k.seed) + ", pixel (" + std::to_string(k.x) + ", " +
           std::to_string(k.y) + "), sample " + std::to_string(k.sample);
}

// The first 64 bits that a generator draws.
std::uint64_t first_bits(const Key& k) {
    Rng random = sample_rng(k.seed, k.x, k.y, k.sample);
    const std::uint64_t high = random();
    return high << 32 | random();
}

double first_number(const Key& k) {
    Rng random = sample_rng(k.seed, k.x, k.y, k.sample);
    return static_cast<double>(random.uniform());
}

// Whether the first draw of a generator and of its neighbor, whose numbers are larger by `step`,
// have something to do with each other: pairs are counted in 16 x 16 boxes, and so are their
// differences in 256.
void check_unrelated(const Key& step, const char* what) {
    std::vector<long> pairs(256), differences(256);
    const auto box = [](double u, int boxes) { return static_cast<std::size_t>(u * boxes); };
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 256; ++x) {
            const Key here{5, 2 * x, 2 * y, 2};
            const Key there{here.seed + step.seed, here.x + step.x, here.y + step.y,
                            here.sample + step.sample};
            const double a = first_number(here), b = first_number(there);
            ++pairs[box(a, 16) * 16 + box(b, 16)];
            ++differences[box(a < b ? b - a : b - a + 1, 256) % 256];
        }
    const std::vector<double> expected(256, 64);
    INFO(what
         << ": what one draws tells what the other draws.\nHint: numbers that differ by "
         << "1 must differ in half of their bits before they become a state; mix_bits does that");
    CHECK(chi_square(pairs, expected) < chi_square_limit(255));
    CHECK(chi_square(differences, expected) < chi_square_limit(255));
}

// A path-traced scene, small enough to be drawn many times.
struct SmallScene {
    rt::SphereList world{{{{{0, 0, -3}, 1}, 0}, {{{0, -101, -3}, 100}, 1}}};
    rt::MaterialList<rt::Lambertian> materials{
        {{{real(0.8), real(0.4), real(0.2)}}, {{real(0.5), real(0.6), real(0.7)}}}};
    rt::GradientSky sky{{1, real(0.9), real(0.8)}, {real(0.4), real(0.6), 1}};
    rt::Camera camera = rt::make_camera({}, 31, 19);

    Color operator()(int x, int y) const {
        return average_samples(7, x, y, 3, [&](int, Rng& random) {
            const rt::Ray ray = rt::primary_ray(camera, x, y, rt::random_place(random));
            return rt::path_radiance(ray, world, materials, sky, rt::SkyEnding{}, 4, random);
        });
    }
};

}  // namespace

TEST_CASE("06.4 the same four numbers give the same generator", "[06.4]") {
    for (const Key& key : {Key{0, 0, 0, 0}, Key{1, 2, 3, 4}, Key{9, 800, 449, 99}}) {
        const std::uint64_t before = first_bits(key);
        first_bits({key.seed, key.x + 1, key.y, key.sample});
        first_bits({key.seed, key.x, key.y, key.sample + 1});
        INFO(text(key) << "\nHint: nothing may be remembered from one call to the next");
        CHECK(first_bits(key) == before);
    }
}

TEST_CASE("06.4 other seeds and pixels and samples give other numbers", "[06.4]") {
    const Key key{5, 20, 30, 3};
    const std::uint64_t bits = first_bits(key);
    for (const Key& other :
         {Key{6, 20, 30, 3}, Key{5, 21, 30, 3}, Key{5, 20, 31, 3}, Key{5, 20, 30, 4},
          Key{5, 30, 20, 3}, Key{5, 19, 31, 3}, Key{5, 21, 30, 2}, Key{4, 21, 30, 3}}) {
        INFO(text(key) << " and " << text(other) << " draw the same");
        CHECK(first_bits(other) != bits);
    }
}

TEST_CASE("06.4 neighbors have nothing to do with each other", "[06.4]") {
    check_unrelated({0, 1, 0, 0}, "pixels beside each other");
    check_unrelated({0, 0, 1, 0}, "pixels below each other");
    check_unrelated({0, 0, 0, 1}, "samples one after the other");
    check_unrelated({1, 0, 0, 0}, "seeds one after the other");
    check_unrelated({0, 1, 0, -1}, "pixels beside each other, one sample apart");
}

TEST_CASE("06.4 the average takes each sample once with its own generator", "[06.4]") {
    std::vector<int> samples;
    std::vector<std::uint64_t> bits;
    const Color average = average_samples(5, 4, 3, 6, [&](int sample, Rng& random) {
        samples.push_back(sample);
        const std::uint64_t high = random();
        bits.push_back(high << 32 | random());
        for (int i = 0; i < sample; ++i) random();  // a path may need more or fewer numbers
        return Color{static_cast<Real>(sample), 2, 0};
    });
    CHECK(samples == std::vector<int>{0, 1, 2, 3, 4, 5});
    for (std::size_t i = 0; i < bits.size(); ++i) {
        INFO("sample " << i << " does not get the generator of its own");
        CHECK(bits[i] == first_bits({5, 4, 3, static_cast<int>(i)}));
    }
    INFO("the average of 0 ... 5 is 2.5, and of 2 it is 2; yours is " << average);
    CHECK(average == Color{real(2.5), 2, 0});
}

TEST_CASE("06.4 a picture is the same in any order of its pixels", "[06.4]") {
    const SmallScene scene;
    const Image in_order = rt::make_image(31, 19, scene);
    Image backwards{31, 19}, jumping{31, 19};
    for (int i = 31 * 19 - 1; i >= 0; --i) backwards.at(i % 31, i / 31) = scene(i % 31, i / 31);
    for (int k = 0; k < 31 * 19; ++k) {
        const int i = k * 100 % (31 * 19);  // 100 and 589 have no common divisor
        jumping.at(i % 31, i / 31) = scene(i % 31, i / 31);
    }
    INFO("Hint: a pixel's color must not depend on which pixels were drawn before");
    CHECK(backwards == in_order);
    CHECK(jumping == in_order);
}

TEST_CASE("06.4 any number of workers draws the same picture", "[06.4][hard]") {
    const SmallScene scene;
    const Image alone = rt::make_image(31, 19, scene);
    const TileGrid grid{31, 19, 4};
    for (const auto& [name, strategy] : rt::strategies())
        for (const int workers : {1, 2, 3, 7, 64}) {
            const Image image = rt::render_image(strategy, grid, workers,
                                                 [&](int x, int y, int) { return scene(x, y); });
            INFO(name << " with " << workers << " workers, bit for bit");
            CHECK(image == alone);
        }
}

TEST_CASE("06.4 no two samples share a generator however large the numbers", "[06.4][hard]") {
    std::unordered_set<std::uint64_t> seen;
    std::size_t count = 0;
    const std::uint64_t large_seed = std::uint64_t{1} << 63;
    const int coordinates[] = {0,      1,      2,      255,     256,     1023,         65'535,
                               65'536, 65'537, 99'999, 1 << 20, 1 << 24, 2'147'483'647};
    for (const std::uint64_t seed :
         {std::uint64_t{0}, std::uint64_t{1}, large_seed, large_seed + 1, std::uint64_t{1} << 32})
        for (const int x : coordinates)
            for (const int y : coordinates)
                for (const int sample : coordinates) {
                    seen.insert(first_bits({seed, x, y, sample}));
                    ++count;
                }
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 100; ++x)
            for (int sample = 3; sample < 8; ++sample) {
                seen.insert(first_bits({77, x, y, sample}));
                ++count;
            }
    INFO(count << " different keys draw " << seen.size()
               << " different 64-bit numbers at first.\nHint: numbers that are shifted together "
                  "into too few bits, or added up, meet those of another pixel");
    CHECK(seen.size() == count);
}

TEST_CASE("06.4 an exception reaches the caller from every strategy", "[06.4][hard]") {
    // The given strategies, too; and first that there is a generator at all.
    (void)sample_rng(1, 2, 3, 4);
    for (const auto& [name, strategy] : rt::strategies()) {
        INFO(name);
        CHECK_THROWS_AS(strategy({40, 40, 4}, 3,
                                 [](const rt::Tile& tile, int) {
                                     if (tile.bottom == 40) throw std::runtime_error("tile");
                                 }),
                        std::runtime_error);
    }
}
