#include <rt/path.hpp>
#include <rt/ray.hpp>
#include <rt/rng.hpp>
#include <rt/sky.hpp>

#include "checkpoint.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Color, rt::Hit, rt::Interval, rt::Ray, rt::Scatter;

namespace {

// Worlds and materials that are no geometry at all: the loop must not know the difference.

// The ground y = 0, as an idea: a ray that goes down always hits it, a ray that goes up never does.
struct Ground {
    mutable int rays = 0;
    mutable Interval asked;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        ++rays;
        asked = within;
        if (rays > 10000)
            throw std::runtime_error(
                "the path does not end.\nHint: count the bounces; from bounce number `depth` on "
                "call ending after every bounce, not only after that one");
        if (ray.direction.y >= 0) return {};
        Hit hit;
        hit.t = 1;
        hit.point = ray.origin + ray.direction;
        hit.normal = {0, 1, 0};
        hit.material = 7;
        return hit;
    }
};

const Ray downward{{0, 1, 0}, {0, -1, 0}};
const Color tint{real(0.5), real(0.25), 1};
const Color sky_color{2, 3, 4};

// Goes on downward for `bounces` bounces less one, then up: a path of as many bounces in all.
struct UpAfter {
    int bounces;
    mutable int done = 0;

    template <class Random>
    std::optional<Scatter> operator()(Vec3, const Hit&, Random&) const {
        return Scatter{tint, {0, ++done < bounces ? Real(-1) : Real(1), 0}};
    }
};

// Goes up with a probability of 1/4 at every bounce.
struct UpOrDown {
    Color attenuation;
    template <class Random>
    std::optional<Scatter> operator()(Vec3, const Hit&, Random& random) const {
        return Scatter{attenuation, {0, random.uniform() < real(0.25) ? Real(1) : Real(-1), 0}};
    }
};

struct Absorber {
    template <class Random>
    std::optional<Scatter> operator()(Vec3, const Hit&, Random&) const {
        return {};
    }
};

Color power(Color c, int n) {
    Color product{1, 1, 1};
    for (int i = 0; i < n; ++i) product *= c;
    return product;
}

std::string text(Color c) {
    return '(' + checkpoint::text(c.r) + ", " + checkpoint::text(c.g) + ", " +
           checkpoint::text(c.b) + ')';
}

// The mean light of paths that go up with a probability of 1/4 at every bounce.
template <class Ending>
Mean mean_light(Real albedo, int depth, const Ending& ending, std::uint64_t stream) {
    rt::Rng rng{45, stream};
    Mean light;
    for (int i = 0; i < 100'000; ++i)
        light.add(static_cast<double>(rt::path_radiance(downward, Ground{},
                                                        UpOrDown{{albedo, albedo, albedo}},
                                                        rt::UniformSky{}, ending, depth, rng)
                                          .g));
    return light;
}

// Keeps the compiler from taking Ray for granted: a ray with a time, and a world that looks at it.
struct TimedRay {
    Vec3 origin, direction;
    Real time;
};
struct TimedGround : Ground {
    mutable bool time_was_lost = false;

    std::optional<Hit> hit(const TimedRay& ray, Interval within) const {
        if (ray.time != real(0.375)) time_was_lost = true;
        return Ground::hit(ray, within);
    }
};

// The ground with so large an error that the side on which the next ray starts is plain to see.
struct ThickGround {
    mutable int rays = 0;
    mutable Ray next;

    std::optional<Hit> hit(const Ray& ray, Interval) const {
        if (++rays > 1) {
            next = ray;
            return {};
        }
        Hit hit;
        hit.t = 1;
        hit.normal = {0, 1, 0};
        hit.point_error = real(0.25);
        return hit;
    }
};

}  // namespace

TEST_CASE("04.5 a path that hits nothing brings the sky of its direction", "[04.5]") {
    rt::Rng rng{45, 1};
    const Ground world;
    const rt::GradientSky sky{{0, 0, 0}, {1, 1, 1}};
    const Ray ray{{0, 5, 0}, {real(0.6), real(0.8), 0}};
    const Color light = rt::path_radiance(ray, world, UpAfter{1}, sky, rt::SkyEnding{}, 8, rng);
    INFO("expected the sky 0.9 in every channel, yours gives " << text(light));
    CHECK(light == sky(ray.direction));
    CHECK(world.rays == 1);
    INFO("Hint: every t from 0 to infinity counts; leave_surface sees to the rest");
    CHECK(world.asked == Interval{0, rt::infinity});
    const Color bounced =
        rt::path_radiance(downward, world, UpAfter{1}, sky, rt::SkyEnding{}, 8, rng);
    INFO("straight down and up again: expected "
         << text(tint) << ", yours gives " << text(bounced)
         << ".\nHint: the light comes from where the path leaves to in the end");
    CHECK(bounced == tint * sky({0, 1, 0}));
}

TEST_CASE("04.5 every bounce multiplies the light by its attenuation", "[04.5]") {
    for (int bounces = 1; bounces <= 6; ++bounces) {
        rt::Rng rng{45, 2};
        const Ground world;
        const Color light = rt::path_radiance(downward, world, UpAfter{bounces},
                                              rt::UniformSky{sky_color}, rt::BlackEnding{}, 8, rng);
        const Color expected = power(tint, bounces) * sky_color;
        INFO(bounces << " bounces: expected " << text(expected) << ", yours gives " << text(light));
        INFO("Hint: start with (1, 1, 1) and multiply channel by channel");
        REQUIRE(light == expected);
        REQUIRE(world.rays == bounces + 1);
    }
}

TEST_CASE("04.5 an absorbed path is black", "[04.5]") {
    rt::Rng rng{45, 3};
    const Color light = rt::path_radiance(downward, Ground{}, Absorber{}, rt::UniformSky{},
                                          rt::SkyEnding{}, 8, rng);
    INFO("Hint: no Scatter means that the light ends here; yours gives " << text(light));
    CHECK(light == Color{});
}

TEST_CASE("04.5 the material is told the incoming direction and the hit", "[04.5]") {
    rt::Rng rng{45, 4};
    int calls = 0;
    bool right = true;
    const auto material = [&](Vec3 incoming, const Hit& hit, rt::Rng&) -> std::optional<Scatter> {
        right = right && hit.material == 7 && hit.t == 1;
        right = right && incoming == (calls == 0 ? Vec3{0, -1, 0} : Vec3{real(0.6), real(-0.8), 0});
        const Vec3 next = ++calls == 3 ? Vec3{0, 1, 0} : Vec3{real(0.6), real(-0.8), 0};
        return Scatter{{1, 1, 1}, next};
    };
    rt::path_radiance(downward, Ground{}, material, rt::UniformSky{}, rt::SkyEnding{}, 8, rng);
    CHECK(calls == 3);
    INFO("Hint: pass on the direction in which the ray arrived, not the one from the camera");
    CHECK(right);
}

TEST_CASE("04.5 the depth limit ends a path in the sky or in black", "[04.5]") {
    for (const int depth : {1, 2, 5, 50}) {
        rt::Rng rng{45, 5};
        const Ground sky_world, black_world;
        const UpAfter never{1 << 30};
        const Color half{real(0.5), real(0.5), 1};
        const auto halve = [&](Vec3, const Hit&, rt::Rng&) -> std::optional<Scatter> {
            return Scatter{half, {0, -1, 0}};
        };
        const Color in_sky = rt::path_radiance(downward, sky_world, halve, rt::UniformSky{},
                                               rt::SkyEnding{}, depth, rng);
        const Color in_black = rt::path_radiance(downward, black_world, never, rt::UniformSky{},
                                                 rt::BlackEnding{}, depth, rng);
        INFO("depth " << depth << ": a path that would bounce for ever");
        {
            INFO("SkyEnding: expected " << text(power(half, depth)) << ", yours gives "
                                        << text(in_sky)
                                        << ".\nHint: after `depth` bounces the sky of the last "
                                           "direction, times the attenuation of all bounces");
            REQUIRE(in_sky == power(half, depth));
        }
        REQUIRE(in_black == Color{});
        INFO("Hint: a path of depth " << depth << " follows " << depth
                                      << " rays, no more, no less");
        REQUIRE(sky_world.rays == depth);
        REQUIRE(black_world.rays == depth);
    }
}

TEST_CASE("04.5 the ray keeps what else it carries", "[04.5]") {
    rt::Rng rng{45, 6};
    const TimedRay ray{{0, 1, 0}, {0, -1, 0}, real(0.375)};
    const TimedGround world;
    rt::path_radiance(ray, world, UpAfter{4}, rt::UniformSky{}, rt::BlackEnding{}, 8, rng);
    INFO("Hint: change the ray's origin and direction; do not make a new ray");
    CHECK_FALSE(world.time_was_lost);
}

TEST_CASE("04.5 the next ray starts on the side of its own direction", "[04.5]") {
    rt::Rng rng{45, 13};
    for (const Real goes_on : {Real(-1), Real(1)}) {
        const ThickGround world;
        const auto material = [&](Vec3, const Hit&, rt::Rng&) -> std::optional<Scatter> {
            return Scatter{{1, 1, 1}, {0, goes_on, 0}};
        };
        rt::path_radiance(downward, world, material, rt::UniformSky{}, rt::BlackEnding{}, 8, rng);
        INFO("a ray comes from above to the ground, y = 0, and goes on "
             << (goes_on < 0 ? "down into it" : "upward again")
             << ": the next one starts at y = " << text(world.next.origin.y)
             << ".\nHint: leave_surface gets the new direction, not the one that arrived");
        CHECK(world.next.direction == Vec3{0, goes_on, 0});
        CHECK(world.next.origin.y * goes_on > 0);
    }
}

TEST_CASE("04.5 black darkens and the sky brightens by what the series says", "[04.5]") {
    const double albedo = 0.8, up = 0.25;
    for (const int depth : {1, 2, 4}) {
        // The paths that end by themselves: after k bounces, of which the last goes up.
        double black = 0;
        for (int k = 1; k < depth; ++k) black += std::pow(albedo, k) * std::pow(1 - up, k - 1) * up;
        const double sky = black + std::pow(albedo, depth) * std::pow(1 - up, depth - 1);
        const Mean in_black = mean_light(real(albedo), depth, rt::BlackEnding{}, 7);
        const Mean in_sky = mean_light(real(albedo), depth, rt::SkyEnding{}, 8);
        INFO("depth " << depth << ", BlackEnding: expected " << black << ", yours gives "
                      << in_black.mean() << " +- " << in_black.standard_error());
        // Where all paths give the same, rounding of the products is left.
        const double rounding = depth * static_cast<double>(rt::epsilon);
        CHECK(std::abs(in_black.mean() - black) <= 4 * in_black.standard_error() + rounding);
        INFO("depth " << depth << ", SkyEnding: expected " << sky << ", yours gives "
                      << in_sky.mean() << " +- " << in_sky.standard_error());
        CHECK(std::abs(in_sky.mean() - sky) <= 4 * in_sky.standard_error() + rounding);
    }
}

TEST_CASE("04.5 Russian roulette is right on the average", "[04.5]") {
    const double albedo = 0.8, up = 0.25, exact = albedo * up / (1 - albedo * (1 - up));
    for (const int depth : {1, 3}) {
        const Mean light = mean_light(real(albedo), depth, rt::RouletteEnding{}, 9);
        INFO("depth " << depth << ": expected " << exact << ", yours gives " << light.mean()
                      << " +- " << light.standard_error()
                      << ".\nHint: a path that goes on with probability p is divided by p");
        CHECK(std::abs(light.mean() - exact) <= 4 * light.standard_error());
    }
}

TEST_CASE("04.5 roulette follows bright paths and lets dark ones go", "[04.5][hard]") {
    const auto share_that_goes_on = [](Color throughput) {
        rt::Rng rng{45, 10};
        const rt::RouletteEnding ending;
        Mean share;
        for (int i = 0; i < 100'000; ++i) {
            Color c = throughput;
            const bool goes_on = ending(c, rng) == rt::Fate::goes_on;
            share.add(goes_on);
            const Real p =
                std::min(ending.most_likely, std::max({throughput.r, throughput.g, throughput.b}));
            if (goes_on && !(c == throughput / p)) {
                INFO("throughput " << text(throughput) << " became " << text(c));
                REQUIRE(c == throughput / p);
            }
        }
        return share;
    };
    const Mean gray = share_that_goes_on({real(0.1), real(0.5), real(0.2)});
    INFO("Hint: the probability is the largest channel, and most_likely at the most");
    CHECK(std::abs(gray.mean() - 0.5) <= 4 * gray.standard_error());
    const Mean white = share_that_goes_on({1, 1, 1});
    CHECK(std::abs(white.mean() - 0.95) <= 4 * white.standard_error());
    const Mean bright = share_that_goes_on({8, 1, 1});
    CHECK(std::abs(bright.mean() - 0.95) <= 4 * bright.standard_error());
    INFO("Hint: a path without light never goes on, or 0 / 0 spoils the picture");
    CHECK(share_that_goes_on({}).mean() == 0);
}

TEST_CASE("04.5 a black path ends whatever roulette draws", "[04.5][hard]") {
    struct AlwaysZero {
        Real uniform() const { return 0; }
    } zero;
    Color throughput;
    const rt::Fate fate = rt::play_roulette(throughput, real(0.95), zero);
    INFO("throughput (0, 0, 0), drawn 0: the throughput became "
         << text(throughput)
         << ".\nHint: p is 0, and 0 / 0 is not a number. Go on only if the number drawn is less "
            "than p");
    CHECK(throughput == Color{});
    CHECK(fate == rt::Fate::ends_in_black);
}

TEST_CASE("04.5 even a path between white surfaces ends by roulette", "[04.5][hard]") {
    rt::Rng rng{45, 11};
    for (int i = 0; i < 1000; ++i) {
        const Ground world;
        const auto white = [](Vec3, const Hit&, rt::Rng&) -> std::optional<Scatter> {
            return Scatter{{1, 1, 1}, {0, -1, 0}};
        };
        const Color light = rt::path_radiance(downward, world, white, rt::UniformSky{},
                                              rt::RouletteEnding{}, 1, rng);
        INFO("Hint: no path may be sure to go on, however bright it is");
        REQUIRE(light == Color{});
    }
}

TEST_CASE("04.5 depth 1 asks for the light of the first surface only", "[04.5][hard]") {
    rt::Rng rng{45, 12};
    const Ground world;
    const Color light = rt::path_radiance(downward, world, UpAfter{1}, rt::UniformSky{sky_color},
                                          rt::SkyEnding{}, 1, rng);
    INFO("expected " << text(tint * sky_color) << ", yours gives " << text(light));
    CHECK(light == tint * sky_color);
    CHECK(world.rays == 1);
}
