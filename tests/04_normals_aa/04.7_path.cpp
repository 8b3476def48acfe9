#include <rt/ending.hpp>
#include <rt/image.hpp>
#include <rt/lambertian.hpp>
#include <rt/leave_surface.hpp>
#include <rt/make_camera.hpp>
#include <rt/path.hpp>
#include <rt/ray.hpp>
#include <rt/render_pixel.hpp>
#include <rt/rng.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>

#include "checkpoint.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Color, rt::Hit, rt::Interval, rt::Ray, rt::Scatter;

namespace {

// Worlds and materials that are no geometry at all: the loop must not know the difference.

// An idealized ground y = 0: a ray that goes down always hits it, a ray that goes up never does.
struct Ground {
    mutable int rays = 0;
    mutable Interval asked;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        ++rays;
        asked = within;
        if (rays > 10000)
            throw std::runtime_error(
                "the path does not end.\nHint: count the bounces; call ending after bounce number "
                "`depth` and after every later bounce");
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

// Goes on downward for all but the last of `bounces` bounces, then up: a path of `bounces` bounces.
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

// Equal but for the rounding of the products along a path: at most 50 factors, multiplied in any
// order, and each product is rounded by half an epsilon on either side.
bool is_near(Color a, Color b) {
    const auto near = [](Real x, Real y) {
        return std::abs(x - y) <= 64 * rt::epsilon * std::abs(y);
    };
    return near(a.r, b.r) && near(a.g, b.g) && near(a.b, b.b);
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

// A path whose bounces are all known beforehand, with the records of what it asked for.
struct Story {
    enum class End { sky, absorbed, ended_in_sky, ended_in_black };
    Ray first;
    std::vector<Hit> hits;         // of each bounce
    std::vector<Scatter> bounces;  // how the path goes on
    std::vector<Color> factors;    // what the ending multiplies the throughput by
    int depth = 1;
    End end = End::sky;

    mutable std::vector<Ray> rays;
    mutable std::vector<Interval> intervals;
    mutable std::vector<Vec3> incoming;
    mutable std::vector<Hit> hits_given;
    mutable std::vector<Color> throughputs;
};

Story any_story(rt::Rng& rng) {
    Story story;
    const auto any_color = [&](Real lowest, Real highest) {
        return Color{any_size(rng, lowest, highest), any_size(rng, lowest, highest),
                     any_size(rng, lowest, highest)};
    };
    const bool is_long = rng() % 100 == 0;
    const auto count = static_cast<std::size_t>(is_long ? rng() % 300 : rng() % 8);
    story.depth = 1 + static_cast<int>(rng() % (count + 3));
    story.first = {any_size(rng, -3, 3) * any_direction(rng), any_direction(rng)};
    // In powers of ten. Some paths become very dim.
    const bool is_dark = rng() % 4 == 0;
    const Real darkest = is_long ? real(-0.1) : is_dark ? -3 : rng.uniform(-3, 0);
    const Real brightest = is_long ? real(0.1) : is_dark ? -2 : real(0.5);
    const unsigned dark_channel = rng() % 6;  // often there is none
    for (std::size_t i = 0; i < count; ++i) {
        Hit hit;
        hit.t = rng.uniform();
        hit.point = any_size(rng, -3, 3) * any_direction(rng);
        hit.normal = any_direction(rng);
        hit.front = rng() & 1;
        hit.point_error = any_size(rng, -9, 3);
        hit.material = static_cast<int>(rng() % 100);
        story.hits.push_back(hit);
        Color attenuation = any_color(darkest, brightest);
        if (dark_channel == 0) attenuation.r = 0;
        if (dark_channel == 1) attenuation.g = 0;
        if (dark_channel == 2) attenuation.b = 0;
        story.bounces.push_back({attenuation, any_direction(rng)});
        story.factors.push_back(any_color(is_long ? darkest : 0, is_long ? real(0.2) : 1));
    }
    // Only a path that has made `depth` bounces can be ended.
    const bool can_be_ended = static_cast<int>(count) >= story.depth;
    story.end = static_cast<Story::End>(rng() % (can_be_ended ? 4 : count > 0 ? 2 : 1));
    return story;
}

Color sky_of(Vec3 direction) {
    return {2 + direction.x, 20 + 10 * direction.y, 300 + 100 * direction.z};
}

// What path_radiance gives for a story, whose records it fills.
Color radiance(const Story& story, rt::Rng& rng) {
    struct World {
        const Story& story;
        std::optional<Hit> hit(const Ray& ray, Interval within) const {
            const std::size_t i = story.rays.size();
            story.rays.push_back(ray);
            story.intervals.push_back(within);
            if (i > story.hits.size() + 50)
                throw std::runtime_error(
                    "the path does not end.\nHint: count the bounces; after bounce number `depth` "
                    "and after every later bounce, do what the ending says");
            if (i >= story.hits.size()) return {};
            return story.hits[i];
        }
    };
    const auto materials = [&](Vec3 incoming, const Hit& hit,
                               rt::Rng& random) -> std::optional<Scatter> {
        const std::size_t i = story.incoming.size();
        story.incoming.push_back(incoming);
        story.hits_given.push_back(hit);
        random();
        const bool is_last = i + 1 >= story.bounces.size();
        if (is_last && story.end == Story::End::absorbed) return {};
        return story.bounces[std::min(i, story.bounces.size() - 1)];
    };
    const auto ending = [&](Color& throughput, rt::Rng& random) {
        story.throughputs.push_back(throughput);
        random();
        const std::size_t bounce = story.incoming.size();  // how many have been made
        if (bounce >= story.bounces.size() && story.end == Story::End::ended_in_sky)
            return rt::PathEnd::in_sky;
        if (bounce >= story.bounces.size() && story.end == Story::End::ended_in_black)
            return rt::PathEnd::in_black;
        throughput *= story.factors[std::min(bounce, story.factors.size()) - 1];
        return rt::PathEnd::none;
    };
    return rt::path_radiance(story.first, World{story}, materials, sky_of, ending, story.depth,
                             rng);
}

// A ray with a time, and a world that looks at it.
using answer::TimedRay;
struct TimedGround : Ground {
    mutable bool time_was_lost = false;

    std::optional<Hit> hit(const TimedRay& ray, Interval within) const {
        if (ray.time != real(0.375)) time_was_lost = true;
        return Ground::hit(ray, within);
    }
};

}  // namespace

TEST_CASE("04.7 a path that hits nothing returns the sky in its direction", "[04.7]") {
    rt::Rng rng{45, 1};
    const Ground world;
    const rt::GradientSky sky{{0, 0, 0}, {1, 1, 1}};
    const Ray ray{{0, 5, 0}, {real(0.6), real(0.8), 0}};
    const Color light = rt::path_radiance(ray, world, UpAfter{1}, sky, rt::SkyEnding{}, 8, rng);
    if (!is_near(light, sky(ray.direction))) {
        INFO(EXPECTED "the sky 0.9 in every channel, " ACTUAL << text(light));
        CHECK(text(light) == text(sky(ray.direction)));
    }
    CHECK(world.rays == 1);
    {
        INFO("Hint: every t from 0 to infinity counts; leave_surface takes care of the rest");
        CHECK(world.asked.min == 0);
        CHECK(world.asked.max == rt::infinity);
    }
    const Color bounced =
        rt::path_radiance(downward, world, UpAfter{1}, sky, rt::SkyEnding{}, 8, rng);
    INFO("the path goes straight down and up again: " EXPECTED
         << text(tint) << ", " ACTUAL << text(bounced)
         << ".\nHint: the light comes from the direction in which the path finally leaves");
    if (!is_near(bounced, tint)) CHECK(text(bounced) == text(tint));
}

TEST_CASE("04.7 every bounce multiplies the light by its attenuation", "[04.7]") {
    for (int bounces = 1; bounces <= 6; ++bounces) {
        rt::Rng rng{45, 2};
        const Ground world;
        const Color light = rt::path_radiance(downward, world, UpAfter{bounces},
                                              rt::UniformSky{sky_color}, rt::BlackEnding{}, 8, rng);
        const Color expected = power(tint, bounces) * sky_color;
        INFO(bounces << " bounces: " EXPECTED << text(expected) << ", " ACTUAL << text(light));
        INFO("Hint: start with (1, 1, 1) and multiply channel by channel");
        if (!is_near(light, expected)) REQUIRE(text(light) == text(expected));
        REQUIRE(world.rays == bounces + 1);
    }
}

TEST_CASE("04.7 an absorbed path is black", "[04.7]") {
    rt::Rng rng{45, 3};
    const Color light = rt::path_radiance(downward, Ground{}, Absorber{}, rt::UniformSky{},
                                          rt::SkyEnding{}, 8, rng);
    INFO("if the material gives no Scatter, the light is absorbed: " EXPECTED "(0, 0, 0), " ACTUAL
         << text(light));
    CHECK(light == Color{});
}

TEST_CASE("04.7 the material gets the incoming direction and the hit", "[04.7]") {
    rt::Rng rng{45, 4};
    for (int i = 0; i < 500; ++i) {
        const Story story = any_story(rng);
        radiance(story, rng);
        for (std::size_t k = 0; k < std::min(story.incoming.size(), story.hits.size()); ++k) {
            const Vec3 expected = k == 0 ? story.first.direction : story.bounces[k - 1].direction;
            const Hit &hit = story.hits_given[k], &right = story.hits[k];
            INFO("bounce number " << k + 1);
            if (error_in_ulp(story.incoming[k], ExactVec3{expected.x, expected.y, expected.z}) >
                8) {
                INFO(EXPECTED "the incoming direction "
                     << text(expected) << ", " ACTUAL << text(story.incoming[k])
                     << ".\nHint: pass on the direction in which the ray arrived, not the "
                        "direction of the camera's ray");
                REQUIRE(text(story.incoming[k]) == text(expected));
            }
            const auto all = [](const Hit& h) {
                return "t " + text(h.t) + ", point " + text(h.point) + ", normal " +
                       text(h.normal) + (h.front ? ", front" : ", not front") + ", error " +
                       text(h.point_error) + ", material " + std::to_string(h.material);
            };
            const bool is_same = hit.t == right.t && hit.point == right.point &&
                                 hit.normal == right.normal && hit.front == right.front &&
                                 hit.point_error == right.point_error &&
                                 hit.material == right.material;
            if (!is_same) {
                INFO("Hint: pass on the hit as the world gives it");
                REQUIRE(all(hit) == all(right));
            }
            REQUIRE(is_same);
        }
    }
}

TEST_CASE("04.7 any path returns the light that its bounces determine", "[04.7]") {
    rt::Rng rng{45, 14};
    for (int i = 0; i < 2000; ++i) {
        const Story story = any_story(rng);
        rt::Rng twin = rng;
        const Color light = radiance(story, rng);

        // The same path, followed once more.
        Color throughput{1, 1, 1}, expected;
        const std::size_t count = story.hits.size();
        std::size_t draws = 0, asked = 0;
        bool has_ended = false;
        std::vector<Color> throughputs;
        for (std::size_t k = 0; k < count && !has_ended; ++k) {
            const bool is_last = k + 1 == count;
            ++draws;
            if (is_last && story.end == Story::End::absorbed) {
                has_ended = true;
                break;
            }
            throughput *= story.bounces[k].attenuation;
            if (static_cast<int>(k) + 1 < story.depth) continue;
            ++asked, ++draws;
            throughputs.push_back(throughput);
            if (is_last && story.end == Story::End::ended_in_sky)
                expected = throughput * sky_of(story.bounces[k].direction);
            has_ended = is_last && story.end != Story::End::sky;
            if (!has_ended) throughput *= story.factors[k];
        }
        const Vec3 last = count == 0 ? story.first.direction : story.bounces[count - 1].direction;
        if (!has_ended) expected = throughput * sky_of(last);

        INFO("a path of " << count << " bounces, depth " << story.depth << ", "
                          << (story.end == Story::End::sky        ? "then the path meets the sky"
                              : story.end == Story::End::absorbed ? "the last bounce absorbs it"
                              : story.end == Story::End::ended_in_sky
                                  ? "then the ending says PathEnd::in_sky"
                                  : "then the ending says PathEnd::in_black"));
        for (std::size_t k = 0; k < story.rays.size(); ++k) {
            INFO("ray number " << k + 1
                               << ".\nHint: every t from 0 to infinity counts; leave_surface takes "
                                  "care of the rest");
            REQUIRE(story.intervals[k].min == 0);
            REQUIRE(story.intervals[k].max == rt::infinity);
        }
        for (std::size_t k = 0; k < std::min(story.rays.size(), count + 1); ++k) {
            const Ray next =
                k == 0 ? story.first
                       : Ray{rt::leave_surface(story.hits[k - 1], story.bounces[k - 1].direction),
                             story.bounces[k - 1].direction};
            const Ray& ray = story.rays[k];
            const auto off = [](Vec3 a, Vec3 b) { return error_in_ulp(a, {b.x, b.y, b.z}); };
            INFO("ray number " << k + 1);
            if (off(ray.direction, next.direction) > 8) {
                INFO("Hint: the ray goes on in the direction that the material chose");
                REQUIRE(text(ray.direction) == text(next.direction));
            }
            if (off(ray.origin, next.origin) > 8) {
                INFO(
                    "Hint: the next ray starts at leave_surface(hit, new direction); the first ray "
                    "starts where it was given");
                REQUIRE(text(ray.origin) == text(next.origin));
            }
        }
        {
            INFO("the number of rays that were followed: " EXPECTED
                 "one more than the number of bounces, unless the path ends earlier. Call the "
                 "ending after bounce number `depth` and after every later bounce");
            REQUIRE(story.rays.size() == count + !has_ended);
        }
        {
            INFO(
                "the number of calls of the ending: call it after bounce number `depth` and after "
                "every later bounce");
            REQUIRE(story.throughputs.size() == asked);
        }
        for (std::size_t k = 0; k < asked; ++k)
            if (!is_near(story.throughputs[k], throughputs[k])) {
                INFO(
                    "Hint: ending gets the product of all attenuations so far, the last one "
                    "included, and may change it");
                REQUIRE(text(story.throughputs[k]) == text(throughputs[k]));
            }
        if (!is_near(light, expected)) {
            INFO(EXPECTED "the light "
                 << text(expected) << ", " ACTUAL << text(light)
                 << ".\nHint: the light is the throughput times the sky in the direction in which "
                    "the ray goes on, or black if the path is absorbed or ends in black. Even the "
                    "dimmest light counts");
            REQUIRE(text(light) == text(expected));
        }
        for (std::size_t k = 0; k < draws; ++k) twin();
        INFO(
            "Hint: the path itself draws no random number, and passes on `random` itself, not a "
            "copy. The values are the next number of the generator");
        REQUIRE(rng() == twin());
    }
}

TEST_CASE("04.7 the depth limit ends a path in the sky or in black", "[04.7]") {
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
        INFO("depth " << depth << ": a path that would bounce forever");
        {
            INFO("SkyEnding: " EXPECTED << text(power(half, depth)) << ", " ACTUAL << text(in_sky)
                                        << ".\nHint: after `depth` bounces, return the sky in the "
                                           "last direction times the attenuations of all bounces");
            if (!is_near(in_sky, power(half, depth)))
                REQUIRE(text(in_sky) == text(power(half, depth)));
        }
        if (!(in_black == Color{})) REQUIRE(text(in_black) == "(0, 0, 0)");
        INFO("Hint: a path of depth " << depth << " follows " << depth
                                      << " rays, no more and no fewer");
        REQUIRE(sky_world.rays == depth);
        REQUIRE(black_world.rays == depth);
    }
}

TEST_CASE("04.7 a bounce changes only the origin and the direction of the ray", "[04.7]") {
    rt::Rng rng{45, 6};
    const TimedRay ray{{0, 1, 0}, {0, -1, 0}, real(0.375)};
    const TimedGround world;
    rt::path_radiance(ray, world, UpAfter{4}, rt::UniformSky{}, rt::BlackEnding{}, 8, rng);
    INFO("Hint: change the ray's origin and direction; do not make a new ray");
    CHECK_FALSE(world.time_was_lost);
}

TEST_CASE("04.7 BlackEnding and SkyEnding give the light that the series predicts", "[04.7]") {
    const double albedo = 0.8, up = 0.25;
    for (const int depth : {1, 2, 4}) {
        // The paths that end by themselves: after k bounces, the last of which goes up.
        double black = 0;
        for (int k = 1; k < depth; ++k) black += std::pow(albedo, k) * std::pow(1 - up, k - 1) * up;
        const double sky = black + std::pow(albedo, depth) * std::pow(1 - up, depth - 1);
        const Mean in_black = mean_light(real(albedo), depth, rt::BlackEnding{}, 7);
        const Mean in_sky = mean_light(real(albedo), depth, rt::SkyEnding{}, 8);
        INFO("depth " << depth << ", BlackEnding: " EXPECTED << black << ", " ACTUAL
                      << in_black.mean() << " +- " << in_black.standard_error());
        // Where all paths give the same, only the rounding of the products is left.
        const double rounding = depth * static_cast<double>(rt::epsilon);
        CHECK(std::abs(in_black.mean() - black) <= 4 * in_black.standard_error() + rounding);
        INFO("depth " << depth << ", SkyEnding: " EXPECTED << sky << ", " ACTUAL << in_sky.mean()
                      << " +- " << in_sky.standard_error());
        CHECK(std::abs(in_sky.mean() - sky) <= 4 * in_sky.standard_error() + rounding);
    }
}

TEST_CASE("04.7 Russian roulette is correct on average", "[04.7]") {
    const double albedo = 0.8, up = 0.25, exact = albedo * up / (1 - albedo * (1 - up));
    for (const int depth : {1, 3}) {
        const Mean light = mean_light(real(albedo), depth, rt::RouletteEnding{}, 9);
        INFO("depth " << depth << ": " EXPECTED << exact << ", " ACTUAL << light.mean() << " +- "
                      << light.standard_error()
                      << ".\nHint: a path that goes on with probability p is divided by p");
        CHECK(std::abs(light.mean() - exact) <= 4 * light.standard_error());
    }
}

TEST_CASE("04.7 the throughput's largest channel decides how likely a path is to go on", "[04.7]") {
    const Real bright = real(0.5), dim = real(0.125);
    for (const Color before :
         {Color{bright, dim, dim}, Color{dim, bright, dim}, Color{dim, dim, bright}}) {
        rt::Rng rng{45, 11};
        constexpr int count = 10000;
        int going = 0;
        for (int i = 0; i < count; ++i) {
            Color c = before;
            if (rt::play_roulette(c, real(0.95), rng) != rt::PathEnd::none) continue;
            ++going;
            INFO("a path with the throughput "
                 << text(before) << " goes on: " EXPECTED "the throughput " << text(before / bright)
                 << ", " ACTUAL << text(c)
                 << ".\nHint: divide by the probability: the largest of red, green and blue, but "
                    "at most most_likely");
            REQUIRE(is_near(c, before / bright));
        }
        INFO("paths with the throughput "
             << text(before) << ": " EXPECTED "that about 5000 of 10000 go on, " ACTUAL << going
             << ".\nHint: the probability is the largest of all three channels");
        CHECK(std::abs(going - count / 2) <= 300);  // 6 standard errors
    }
}

TEST_CASE("04.7 most_likely limits how likely a path is to go on", "[04.7]") {
    struct Counted {
        rt::Rng rng{45, 12};
        int draws = 0;
        Real uniform() {
            ++draws;
            return rng.uniform();
        }
    };
    {
        INFO("Hint: leave RouletteEnding as it was given");
        CHECK(text(rt::RouletteEnding{}.most_likely) == text(real(0.95)));
    }
    for (const Real bright : {Real(3), Real(1), real(0.7), real(0.02)})
        for (const Real most_likely : {real(0.95), real(0.25)}) {
            const Color before{bright / 2, bright, bright / 4};
            const Real p = std::min(bright, most_likely);
            const std::string paths = "paths with the throughput " + text(before) +
                                      " and most_likely " + text(most_likely);
            Counted random;
            constexpr int count = 10000;
            int going = 0;
            for (int i = 0; i < count; ++i) {
                Color c = before;
                if (rt::play_roulette(c, most_likely, random) != rt::PathEnd::none) continue;
                ++going;
                INFO(paths << ": one goes on; " EXPECTED "the throughput " << text(before / p)
                           << ", " ACTUAL << text(c)
                           << ".\nHint: divide by the probability, which is at most most_likely");
                REQUIRE(is_near(c, before / p));
            }
            const double expected = count * static_cast<double>(p);
            const double deviation = std::sqrt(expected * (1 - static_cast<double>(p)));
            INFO(paths << ": " EXPECTED "that about " << expected << " of " << count
                       << " go on, " ACTUAL << going
                       << ".\nHint: the probability is the largest channel, however small, but at "
                          "most most_likely");
            CHECK(std::abs(going - expected) <= 6 * deviation);
            INFO("the values are how many random numbers were drawn for " << count << " decisions");
            CHECK(random.draws <= count);
        }
}

TEST_CASE("04.7 a gray sphere under a white sky returns its albedo", "[04.7]") {
    // The furnace: from a sphere alone every path leaves after one bounce, so nothing is random
    // here. One path that meets the sphere again is one too many.
    rt::Rng rng{46, 1};
    const Real albedo = real(0.75);
    const rt::MaterialList<rt::Lambertian> gray{{{{albedo, albedo, albedo}}}};
    for (const Real radius : {real(1e-9), Real(1), real(1e9)})
        for (int i = 0; i < 20000; ++i) {
            const Vec3 center = 100 * radius * any_direction(rng);
            const Vec3 from = center + 3 * radius * any_direction(rng);
            const Vec3 at = center + real(0.99) * radius * any_direction(rng);
            const Color light = rt::path_radiance(Ray{from, (at - from) / radius},
                                                  rt::SphereList{{{{center, radius}, 0}}}, gray,
                                                  rt::UniformSky{}, rt::BlackEnding{}, 16, rng);
            const bool is_near = std::abs(light.r - albedo) <= rt::epsilon;
            if (!is_near) {
                INFO("radius " << text(radius) << ": " EXPECTED << text(albedo) << ", " ACTUAL
                               << text(light.r)
                               << ".\nHint: the path met the sphere again that it had just left, "
                                  "and was dimmed twice. In leave_surface, move by the error of "
                                  "the point plus the rounding error of the sum");
                REQUIRE(text(light.r) == text(albedo));
            }
            REQUIRE(is_near);
        }
}

TEST_CASE("04.7 between two facing spheres the light of all bounces adds up", "[04.7]") {
    // From the point of one sphere that faces the other, a share (r / d)^2 of all bounces meets the
    // other, if d is the distance from its center: r = 1, d = 2 here, so that they almost touch.
    const double share = 0.25, albedo = 0.5;
    const rt::SphereList world{{{{{-2, 0, 0}, 1}, 0}, {{{1, 0, 0}, 1}, 0}}};
    const Color half{real(0.5), real(0.5), real(0.5)};
    const rt::MaterialList<rt::Lambertian> gray{{{half}}};
    const Ray ray{{real(-0.5), 0, 0}, {-1, 0, 0}};
    const auto mean_light = [&](const auto& ending, int depth) {
        rt::Rng rng{46, 2};
        Mean light;
        for (int i = 0; i < 100'000; ++i)
            light.add(static_cast<double>(
                rt::path_radiance(ray, world, gray, rt::UniformSky{}, ending, depth, rng).g));
        return light;
    };
    const auto check = [](const char* what, const Mean& light, double expected) {
        INFO(what << ": " EXPECTED << expected << ", " ACTUAL << light.mean() << " +- "
                  << light.standard_error());
        // Correct code stays within 3 standard errors in all but one of 370 runs, and
        // the seed is fixed.
        CHECK(std::abs(light.mean() - expected) <= 3 * light.standard_error());
    };
    const double first = albedo * (1 - share), second = albedo * albedo * share;
    check("depth 2, black", mean_light(rt::BlackEnding{}, 2), first);
    check("depth 2, sky", mean_light(rt::SkyEnding{}, 2), first + second);
    // With more depth, the light lies between the two.
    const Mean roulette = mean_light(rt::RouletteEnding{}, 2);
    const Mean deep = mean_light(rt::SkyEnding{}, 32);
    CHECK(deep.mean() > first);
    CHECK(deep.mean() < first + second);
    INFO("Russian roulette gives " << roulette.mean() << " +- " << roulette.standard_error()
                                   << ", 32 bounces " << deep.mean());
    CHECK(std::abs(roulette.mean() - deep.mean()) <=
          4 * (roulette.standard_error() + deep.standard_error()));
}

TEST_CASE("04.7 a path in a closed room stays in it", "[04.7]") {
    rt::Rng rng{46, 3};
    const rt::SphereList room{{{{{0, 0, 0}, 1}, 0}}};
    const rt::MaterialList<rt::Lambertian> white{{{{1, 1, 1}}}};
    for (int i = 0; i < 200; ++i) {
        const Color light = rt::path_radiance(Ray{{0, 0, 0}, any_direction(rng)}, room, white,
                                              rt::UniformSky{}, rt::BlackEnding{}, 100, rng);
        INFO(
            "this path left the room.\nHint: a ray from the inner side of the room must start "
            "inside");
        REQUIRE(light == Color{});
    }
}

TEST_CASE("04.7 the probability of roulette is right to the last digits", "[04.7][hard]") {
    // Draws the same number again and again.
    struct Fixed {
        Real number;
        int draws = 0;
        Real uniform() {
            ++draws;
            return number;
        }
    };
    rt::Rng rng{45, 10};
    for (int i = 0; i < 20000; ++i) {
        const Color before{any_size(rng, -6, 1), any_size(rng, -6, 1), any_size(rng, -6, 1)};
        const Real most_likely = i % 4 ? rng.uniform(real(0.05), 1) : real(0.95);
        const Real p = std::min(most_likely, std::max({before.r, before.g, before.b}));
        const auto describe = [&] {
            return "throughput " + text(before) + ", most_likely " + text(most_likely) +
                   ": " EXPECTED "the probability " + text(p);
        };
        int draws = 0;
        std::optional<Color> wrongly_divided;
        const auto goes_on = [&](Real drawn) {
            Fixed random{drawn};
            Color c = before;
            const bool goes = rt::play_roulette(c, most_likely, random) == rt::PathEnd::none;
            draws = std::max(draws, random.draws);
            if (goes && !is_near(c, before / p)) wrongly_divided = c;
            return goes;
        };
        // The numbers on one side of a limit go on. Which side does not matter.
        Real low = 0, high = 1 - rt::epsilon / 2;
        const bool small_ones_go_on = goes_on(low);
        Real share = small_ones_go_on ? 1 : 0;
        if (goes_on(high) != small_ones_go_on) {
            while (high - low > rt::epsilon / 2) {
                const Real middle = low + (high - low) / 2;
                if (!(low < middle && middle < high)) break;
                (goes_on(middle) == small_ones_go_on ? low : high) = middle;
            }
            share = small_ones_go_on ? high : 1 - high;
        }
        if (!(std::abs(share - p) <= 2 * rt::epsilon)) {
            INFO(describe() << ", " ACTUAL << text(share));
            INFO("Hint: the probability is the largest channel, but at most most_likely");
            REQUIRE(text(share) == text(p));
        }
        if (wrongly_divided) {
            INFO(describe());
            INFO("Hint: a path that goes on is divided by the probability, in all channels");
            REQUIRE(text(*wrongly_divided) == text(before / p));
        }
        INFO("the values are the number of random numbers that were drawn for one decision");
        REQUIRE(draws <= 1);
    }
}

TEST_CASE("04.7 roulette ends a black path whatever number it draws", "[04.7]") {
    struct Always {
        Real number;
        Real uniform() const { return number; }
    };
    for (const Real drawn : {Real(0), real(0.5), 1 - rt::epsilon / 2}) {
        Color throughput;
        Always random{drawn};
        const rt::PathEnd end = rt::play_roulette(throughput, real(0.95), random);
        INFO("throughput (0, 0, 0), drawn "
             << text(drawn)
             << ".\nHint: p is 0, and 0 / 0 is NaN. Go on only if the number drawn is less than p");
        const std::string name = end == rt::PathEnd::in_black ? "in_black"
                                 : end == rt::PathEnd::none   ? "none"
                                                              : "in_sky";
        CHECK(name == "in_black");
    }
}

TEST_CASE("04.7 roulette ends even a path between white surfaces", "[04.7]") {
    rt::Rng rng{45, 11};
    for (int i = 0; i < 1000; ++i) {
        const Ground world;
        const auto white = [](Vec3, const Hit&, rt::Rng&) -> std::optional<Scatter> {
            return Scatter{{1, 1, 1}, {0, -1, 0}};
        };
        const Color light = rt::path_radiance(downward, world, white, rt::UniformSky{},
                                              rt::RouletteEnding{}, 1, rng);
        INFO("Hint: even the brightest path must not go on with certainty");
        REQUIRE(light == Color{});
    }
}

TEST_CASE("04.7 a scene of any size gives the same picture", "[04.7][hard]") {
    constexpr int width = 24, height = 16;
    // Two spheres that touch, and a third that is half in the ground.
    const auto picture = [](Real scale) {
        const auto sphere = [&](Real x, Real y, Real z, Real r) {
            return rt::SceneSphere{{scale * Vec3{x, y, z}, scale * r}, 0};
        };
        const rt::SphereList world{{sphere(0, -1000, 0, 1000), sphere(-1, 1, 0, 1),
                                    sphere(1, 1, 0, 1), sphere(0, 0, 2, real(0.5))}};
        const rt::MaterialList<rt::Lambertian> gray{{{{real(0.5), real(0.6), real(0.7)}}}};
        const rt::Camera camera = rt::make_camera(
            {scale * Vec3{0, 2, 6}, scale * Vec3{0, 1, 0}, {0, 1, 0}, rt::pi / 4}, width, height);
        return rt::make_image(width, height, [&](int column, int row) {
            return rt::render_pixel(camera, world, gray, rt::GradientSky{{1, 1, 1}, {0, 0, 1}},
                                    rt::SkyEnding{}, {16, 8, 1}, column, row);
        });
    };
    const rt::Image image = picture(1);
    const auto different_pixels = [&](Real scale, Real step) {
        const rt::Image scaled = picture(scale);
        int count = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Color a = image.at(x, y), b = scaled.at(x, y);
                REQUIRE(rt::is_finite(b));
                count += !(std::max({std::abs(a.r - b.r), std::abs(a.g - b.g),
                                     std::abs(a.b - b.b)}) <= step);
            }
        return count;
    };
    INFO("Hint: your code uses a length that does not scale with the scene");
    for (const int power : {-30, 30}) {
        INFO("scaled by 2^" << power << ", which is exact: every bit must stay the same");
        CHECK(different_pixels(std::scalbn(Real(1), power), 0) == 0);
    }
    // Other factors round every number of the scene. In double no path notices; in float one in
    // several thousand meets a different sphere than before, which shows as noise in its pixel.
    for (const Real scale : {real(1e-9), real(1e9)}) {
        INFO("scaled by " << text(scale));
        CHECK(different_pixels(scale, 1 / Real(255)) <= for_this_precision(width * height / 50, 0));
    }
}
