#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <rt/image.hpp>
#include <rt/lambertian.hpp>
#include <rt/make_camera.hpp>
#include <rt/path.hpp>
#include <rt/primary_ray.hpp>
#include <rt/sample_rng.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>
#include <rt/strategies.hpp>
#include <set>
#include <string>

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

std::string text(const Color& c) {
    return '(' + checkpoint::text(c.r) + ", " + checkpoint::text(c.g) + ", " +
           checkpoint::text(c.b) + ')';
}

// The first 64 bits that a generator draws.
std::uint64_t first_bits(const Key& k) {
    Rng random = sample_rng(k.seed, k.x, k.y, k.sample);
    const std::uint64_t high = random();
    return high << 32 | random();
}

// How many of the first 64 bits differ between two keys.
int distance(const Key& a, const Key& b) {
    return std::popcount(first_bits(a) ^ first_bits(b));
}

// Finds keys whose generators draw the same as another's.
class Seen {
  public:
    void add(const Key& key) {
        ++count_;
        const std::uint64_t number = first_bits(key);
        std::size_t place = number % slots_.size();
        while (slots_[place] != 0) {
            if (slots_[place] == number && met_.empty()) met_ = text(key);
            if (slots_[place] == number) return;
            place = (place + 1) % slots_.size();
        }
        slots_[place] = number;
    }
    void check() const {
        INFO("among " << count_
                      << " different keys, this one draws the same as another.\nHint: if the "
                         "numbers are shifted together into too few bits, added up, or each "
                         "multiplied by a prime number, two samples get the same state");
        CHECK(met_ == "");
    }

  private:
    int count_ = 0;
    std::string met_;  // the first such key
    std::vector<std::uint64_t> slots_ = std::vector<std::uint64_t>(std::size_t{1} << 21);
};

// With 255 degrees of freedom, the chi-square statistic of right code stays below this in all but
// one of ten million runs. Several hundred of them are computed here.
constexpr double limit_of_255 = 391;

// Checks that the draws of a generator have nothing to do with those of its neighbor, whose numbers
// are larger by `step`. Each of the first four draws of one is compared with each of the other's.
void check_unrelated(const Key& step, const char* what) {
    constexpr int draws = 4;
    std::vector<long> high[draws][draws], low[draws][draws];
    std::vector<long> differences(256);
    for (auto* counts : {high, low})
        for (int i = 0; i < draws * draws; ++i)
            counts[i / draws][i % draws] = std::vector<long>(256);
    double least_distance = 0, distances[32] = {};  // one for each turn
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            const Key here{5, 2 * x + 1, 2 * y + 1, 6};
            Rng a = sample_rng(here.seed, here.x, here.y, here.sample);
            Rng b = sample_rng(here.seed + step.seed, here.x + step.x, here.y + step.y,
                               here.sample + step.sample);
            std::uint32_t of_a[draws], of_b[draws];
            for (auto& bits : of_a) bits = a();
            for (auto& bits : of_b) bits = b();
            for (int i = 0; i < draws; ++i)
                for (int k = 0; k < draws; ++k) {
                    ++high[i][k][(of_a[i] >> 28) * 16 + (of_b[k] >> 28)];
                    ++low[i][k][(of_a[i] & 15) * 16 + (of_b[k] & 15)];
                }
            ++differences[(of_b[0] - of_a[0]) >> 24];
            // This generator rotates its bits before it returns them.
            if (x % 8 == 0) {
                int least = 32;
                for (int turn = 0; turn < 32; ++turn) {
                    const int different = std::popcount(of_a[3] ^ std::rotl(of_b[3], turn));
                    least = std::min(least, different);
                    distances[turn] += different;
                }
                least_distance += least;
            }
        }
    const std::vector<double> expected(256, 64);
    INFO(what
         << ": the draws of one generator are related to the draws of the other.\nHint: two inputs "
            "that differ by "
         << "1 must differ in half of their bits before they become a state; mix_bits does that. "
         << "And each sample needs a state of its own, not a later position in the same stream");
    CHECK(chi_square(differences, expected) < limit_of_255);
    for (int i = 0; i < draws; ++i)
        for (int k = 0; k < draws; ++k) {
            INFO("draw " << i << " of one, draw " << k << " of the other");
            REQUIRE(chi_square(high[i][k], expected) < limit_of_255);
            REQUIRE(chi_square(low[i][k], expected) < limit_of_255);
        }
    // Of 32 distances between bits that are drawn at random, the least is 10.1 on average.
    INFO(
        "how many of the 32 bits differ between the fourth draws; one of these draws is rotated so "
        "that the fewest bits differ");
    CHECK(least_distance / 2048 > 9.5);
    // Right code is 0.5 off once in 10^12 runs.
    const auto [fewest, most] = std::minmax_element(std::begin(distances), std::end(distances));
    INFO(
        "how many of the 32 bits differ on average, if all fourth draws of one are rotated by the "
        "same number of bits; " EXPECTED
        "16.\nHint: two generators with the same state and different streams are related: give "
        "each sample a state of its own");
    CHECK(*fewest / 2048 > 15.5);
    CHECK(*most / 2048 < 16.5);
}

// The first pixel in which two pictures differ, in words; empty if there is none.
std::string difference(const Image& actual, const Image& expected) {
    for (int y = 0; y < expected.height(); ++y)
        for (int x = 0; x < expected.width(); ++x)
            if (!(actual.at(x, y) == expected.at(x, y)))
                return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") is " +
                       text(actual.at(x, y)) + "; expected " + text(expected.at(x, y));
    return {};
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
        INFO(text(key) << "\nHint: keep nothing from one call to the next");
        CHECK(first_bits(key) == before);
    }
}

TEST_CASE("06.4 different seeds and pixels and samples draw different numbers", "[06.4]") {
    const Key key{5, 20, 30, 3};
    const std::uint64_t bits = first_bits(key);
    for (const Key& other :
         {Key{6, 20, 30, 3}, Key{5, 21, 30, 3}, Key{5, 20, 31, 3}, Key{5, 20, 30, 4},
          Key{5, 30, 20, 3}, Key{5, 19, 31, 3}, Key{5, 21, 30, 2}, Key{4, 21, 30, 3}}) {
        INFO(text(key) << " and " << text(other) << " draw the same numbers");
        CHECK(first_bits(other) != bits);
    }
}

TEST_CASE("06.4 neighboring pixels and samples draw unrelated numbers", "[06.4]") {
    check_unrelated({0, 1, 0, 0}, "pixels beside each other");
    check_unrelated({0, 0, 1, 0}, "pixels below each other");
    check_unrelated({0, 0, 0, 1}, "samples one after the other");
    check_unrelated({0, 0, 0, 4}, "samples not far from each other");
    check_unrelated({1, 0, 0, 0}, "seeds one after the other");
    check_unrelated({0, 1, 0, -1}, "pixels beside each other, one sample apart");
    check_unrelated({0, 1, -1, 0}, "pixels along a diagonal");
    check_unrelated({1, -1, 0, 0}, "pixels beside each other, one seed apart");
    check_unrelated({1, 0, 0, -1}, "samples one after the other, one seed apart");
}

TEST_CASE("06.4 the average contains each sample once with its own generator", "[06.4]") {
    // One type for all calls: whatever one call remembers, the next one finds.
    using Draw = std::function<Color(int, Rng&)>;
    Rng rng{6, 4};
    Key key{};
    for (const int count : {1, 2, 3, 6, 7, 7, 64, 300}) {
        // Light of any size, even below 0, because an average knows nothing about light; and black.
        const auto any = [&] {
            return std::scalbn(rng.uniform(-1, 1), static_cast<int>(rng() % 20));
        };
        std::vector<Color> colors;
        for (int i = 0; i < count; ++i)
            colors.push_back(rng() % 4 ? Color{any(), any(), any()} : Color{});
        if (key.sample != count)  // 7 twice, of the same pixel
            key = {std::uint64_t{rng()} << 32 | rng(), static_cast<int>(rng() >> 1),
                   static_cast<int>(rng() >> 1), count};
        std::vector<int> samples, expected_samples;
        std::vector<std::uint64_t> bits;
        Draw draw;
        draw = [&](int sample, Rng& random) {
            samples.push_back(sample);
            const std::uint64_t high = random();
            bits.push_back(high << 32 | random());
            for (int i = 0; i < sample; ++i) random();  // a path may need more or fewer numbers
            // An average inside an average: each has a sum of its own.
            if (sample == 1)
                average_samples(8, 7, 6, 2, Draw{[](int, Rng&) { return Color{9, 9, 9}; }});
            return colors[static_cast<std::size_t>(sample) % colors.size()];
        };
        const Color average = average_samples(key.seed, key.x, key.y, count, draw);
        INFO(count << " samples of pixel (" << key.x << ", " << key.y << "), seed " << key.seed);
        {
            for (int i = 0; i < count; ++i) expected_samples.push_back(i);
            INFO(
                "the samples for which draw is called.\nHint: call draw once for each sample, in "
                "order");
            REQUIRE(samples == expected_samples);
        }
        for (std::size_t i = 0; i < bits.size(); ++i) {
            INFO("sample " << i
                           << " does not get its own generator\nHint: make a new one for each "
                              "sample: sample_rng(seed, x, y, sample)");
            REQUIRE(bits[i] == first_bits({key.seed, key.x, key.y, static_cast<int>(i)}));
        }
        for (Real Color::*channel : {&Color::r, &Color::g, &Color::b}) {
            // In any order of the operations, and with any rounding in between.
            Exact sum = 0;
            Real largest = 0;
            for (const Color& color : colors) {
                sum = sum + Exact(static_cast<double>(color.*channel));
                largest = std::max(largest, std::abs(color.*channel));
            }
            const Exact mean = sum / Exact(count);
            const double error =
                std::abs((Exact(static_cast<double>(average.*channel)) - mean).high);
            if (error <= static_cast<double>(rt::rounding_bound(4 * count + 8) * largest)) continue;
            INFO(
                "the values are a color channel of the average.\nHint: add up the colors that draw "
                "returns, and divide by the number of samples as a Real");
            const std::string actual = checkpoint::text(average.*channel);
            REQUIRE(actual == checkpoint::text(mean));
        }
    }
}

TEST_CASE("06.4 a picture does not depend on the order of its pixels", "[06.4]") {
    const SmallScene scene;
    const Image in_order = rt::make_image(31, 19, scene);
    Image backwards{31, 19}, jumping{31, 19};
    for (int i = 31 * 19 - 1; i >= 0; --i) backwards.at(i % 31, i / 31) = scene(i % 31, i / 31);
    for (int k = 0; k < 31 * 19; ++k) {
        const int i = k * 100 % (31 * 19);  // 100 and 589 have no common divisor
        jumping.at(i % 31, i / 31) = scene(i % 31, i / 31);
    }
    INFO("Hint: a pixel's color must not depend on which pixels were drawn before");
    CHECK(difference(backwards, in_order) == "");
    CHECK(difference(jumping, in_order) == "");
}

TEST_CASE("06.4 any number of workers draws the same picture", "[06.4]") {
    const SmallScene scene;
    const Image alone = rt::make_image(31, 19, scene);
    const TileGrid grid{31, 19, 4};
    for (const auto& [name, strategy] : rt::strategies())
        for (const int workers : {1, 2, 3, 7, 64}) {
            const Image image = rt::render_image(strategy, grid, workers,
                                                 [&](int x, int y, int) { return scene(x, y); });
            INFO(name << ", bit for bit, workers: " << workers);
            CHECK(difference(image, alone) == "");
        }
}

TEST_CASE("06.4 no two samples of a picture share a generator", "[06.4]") {
    // Among a million states of 64 bits, two are equal once in 37 million runs. Among a million
    // states of 32 bits, 120 pairs would be equal.
    Seen seen;
    for (std::uint64_t seed = 0; seed < 3; ++seed)
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                for (int sample = 0; sample < 64; ++sample) seen.add({seed, x, y, sample});
    // Any samples of a picture of 1920 x 1080 pixels, with 64 samples each.
    Rng rng{6, 6};
    std::set<unsigned> chosen;
    while (chosen.size() < 100'000) chosen.insert(rng() % (1920 * 1080 * 64));
    for (const unsigned number : chosen) {
        const auto pixel = static_cast<int>(number / 64);
        seen.add({4, pixel % 1920, pixel / 1920, static_cast<int>(number % 64)});
    }
    // Pictures may be wide, and seeds of any size.
    const int some[] = {5, 6, 255, 256, 1920, 10'005, 65'535, 65'536, 65'541, 70'000};
    const std::uint64_t large = std::uint64_t{7} << 32;
    for (const std::uint64_t seed : {std::uint64_t{7}, large, large + 1})
        for (const int x : some)
            for (const int y : some)
                for (const int sample : some) seen.add({seed, x, y, sample});
    seen.check();
}

TEST_CASE("06.4 no two samples share a generator however large the numbers", "[06.4][hard]") {
    Seen seen;
    const auto add = [&](const Key& key) { seen.add(key); };
    const int coordinates[] = {255,          256,
                               1000,         1023,
                               1024,         1080,
                               1920,         3840,
                               4096,         9973,
                               10'000,       65'535,
                               65'536,       65'537,
                               99'999,       1 << 20,
                               1'000'003,    1 << 24,
                               1'000'000,    1 << 30,
                               1 << 29,      1 << 16 | 1 << 8,
                               2'147'483'647};
    // If the pixels were mixed into 32 bits, 8 pairs of these would be equal.
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) add({3, x, y, 0});
    const std::uint64_t large_seed = std::uint64_t{1} << 63;
    for (const std::uint64_t seed :
         {std::uint64_t{0}, std::uint64_t{1}, large_seed, large_seed + 1})
        for (const int a : coordinates) {
            for (const int b : coordinates) {
                for (const int c : coordinates)
                    if (c % 3 == 0) add({seed, a, b, c});
                for (const int small : {0, 1, 70}) {
                    add({seed, a, b, small});
                    add({seed, a, small, b});
                    add({seed, small, a, b});
                }
            }
            add({seed, 0, 0, a});
            for (const int small : {70, 71}) {
                add({seed, a, small, 0});
                add({seed, small, a, 0});
                add({seed, a, 0, small});
                add({seed, 0, a, small});
            }
        }
    seen.check();
}

TEST_CASE("06.4 every bit of the four numbers counts", "[06.4][hard]") {
    Rng rng{6, 5};
    std::vector<Key> keys;
    for (int i = 0; i < 16; ++i) {
        const auto any = [&] { return static_cast<int>(rng() >> (1 + 2 * i % 32)); };
        keys.push_back({std::uint64_t{rng()} << 32 | rng(), any(), any(), any()});
    }
    const auto check = [&](const char* what, int bit, auto changed) {
        int sum = 0;
        for (const Key& key : keys) sum += distance(key, changed(key));
        INFO("if bit "
             << bit << " of " << what
             << " changes, about half of the first 64 drawn bits should change; the value is "
             << "the mean number of bits that change");
        const double mean = sum / 16.0;  // 32, give or take 1
        REQUIRE(mean > 25.5);
        REQUIRE(mean < 38.5);
    };
    for (int bit = 0; bit < 64; ++bit)
        check("seed", bit, [=](Key key) {
            key.seed ^= std::uint64_t{1} << bit;
            return key;
        });
    for (int bit = 0; bit < 31; ++bit) {
        check("x", bit, [=](Key key) { return key.x ^= 1 << bit, key; });
        check("y", bit, [=](Key key) { return key.y ^= 1 << bit, key; });
        check("sample", bit, [=](Key key) { return key.sample ^= 1 << bit, key; });
    }
}
