#include <rt/triangle_light.hpp>

#include "lamps.hpp"

using namespace checkpoint;
using rt::LightSample;

namespace {

constexpr const char* even_hint =
    "the part of the triangle that is nearer to a than a share s of the way to bc has the share "
    "s^2 of the area; set s^2 = place.x";

void check_weights(Vec2 place, Vec2 expected) {
    const Vec2 weights = rt::even_weights(place);
    INFO("at the sample point " << text(place) << ": " EXPECTED "the weights " << text(expected)
                                << "\n" ACTUAL "the weights " << text(weights));
    INFO("Hint: " << even_hint << "; then share out s between b and c, by 1 - place.y and place.y");
    const bool is_near = std::abs(weights.x - expected.x) <= 8 * rt::epsilon &&
                         std::abs(weights.y - expected.y) <= 8 * rt::epsilon;
    REQUIRE(is_near);
}

// Which of 64 equal triangles, in eight rows, has this point.
std::size_t cell_of(Vec2 weights) {
    const Real x = 8 * weights.x, y = 8 * weights.y;
    const int column = std::clamp(static_cast<int>(x), 0, 7),
              row = std::clamp(static_cast<int>(y), 0, 7 - column);
    const bool turned =
        x - static_cast<Real>(column) + (y - static_cast<Real>(row)) > 1 && row + column < 7;
    return static_cast<std::size_t>(row * (16 - row) + 2 * column + (turned ? 1 : 0));
}

// Numbers of these triangles as a picture with a at the lower left: eight rows of 15 cells.
template <class Number>
std::vector<Number> in_rows(const std::vector<Number>& numbers) {
    std::vector<Number> rows(8 * 15);
    auto next = numbers.begin();
    for (std::size_t row = 0; row < 8; ++row)
        for (std::size_t k = 0; k < 15 - 2 * row; ++k) rows[15 * (7 - row) + k] = *next++;
    return rows;
}

// The message of a wrong density.
void check_density(const Triangle& light, Vec3 from, Vec3 point, Real allowed, const char* hint) {
    const Exact expected = Exact(1) / exact_solid_angle(light, from, point);
    const Real density = rt::light_density(light, from, point);
    INFO("light_density of " << text(light) << ", seen from " << text(from) << ", toward "
                             << text(point));
    HINT(expected, density, hint);
    const bool is_near =
        times_allowed(density, expected, static_cast<double>(allowed) * expected.high) <= 1;
    REQUIRE(is_near);
}

constexpr const char* formula_hint =
    "distance^2 / (area * cosine): the area is half the length of the cross product of ab and ac, "
    "and the cosine is that between the direction and the normal, both of length 1";

// The angle at which two directions lie apart.
double angle_between(const ExactVec3& a, const ExactVec3& b) {
    return std::atan2(exact_length(cross(a, b)).high, dot(a, b).high);
}

// The irradiance of a triangle of radiance 1 that lies wholly above a floor with this normal, by
// Lambert's formula for polygons: a sum over the edges.
double exact_irradiance(const Triangle& light, Vec3 from, Vec3 normal) {
    const ExactVec3 o = exact_vector(from);
    const ExactVec3 corners[3]{exact_unit(exact_vector(light.a) - o),
                               exact_unit(exact_vector(light.b) - o),
                               exact_unit(exact_vector(light.c) - o)};
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        const ExactVec3 &p = corners[k], &q = corners[(k + 1) % 3];
        sum += angle_between(p, q) * dot(exact_unit(cross(p, q)), exact_vector(normal)).high;
    }
    return std::abs(sum) / 2;
}

// The solid angle of a triangle. Source: Van Oosterom and Strackee, "The solid angle of a plane
// triangle", IEEE Transactions on Biomedical Engineering 30(2), 1983.
double exact_solid_angle_of(const Triangle& light, Vec3 from) {
    const ExactVec3 o = exact_vector(from);
    const ExactVec3 a = exact_unit(exact_vector(light.a) - o),
                    b = exact_unit(exact_vector(light.b) - o),
                    c = exact_unit(exact_vector(light.c) - o);
    return 2 * std::atan2(std::abs(dot(a, cross(b, c)).high),
                          1 + dot(a, b).high + dot(b, c).high + dot(c, a).high);
}

// A lamp in a random position, and a point that sees it from a distance of 1 to 3 times its size,
// not from the side.
struct Seen {
    Triangle light;
    Vec3 from;
};
Seen seen_lamp(rt::Rng& rng) {
    for (;;) {
        const Triangle light = plain_triangle(rng);
        const Vec3 from = 3 * in_cube(rng);
        const ExactVec3 normal = exact_unit(exact_normal(light));
        const ExactVec3 way = exact_vector(light.a) - exact_vector(from);
        const double height = std::abs(dot(normal, way).high);
        if (height > 1 && height > 0.4 * exact_length(way).high) return {light, from};
    }
}

LightSample sampled(const Triangle& light, Vec3 from, Vec2 place) {
    const auto sample = rt::sample_light(light, from, place);
    if (!sample) {
        INFO(text(light) << ", seen from " << text(from) << ": " EXPECTED "a sample, " ACTUAL
                         << "none");
        REQUIRE(sample);
    }
    return *sample;
}

}  // namespace

TEST_CASE("14.1 the weights agree with an example on paper", "[14.1]") {
    check_weights({real(0.25), real(0.5)}, {real(0.25), real(0.25)});
    check_weights({real(0.25), 0}, {real(0.5), 0});
    check_weights({real(0.64), real(0.25)}, {real(0.6), real(0.2)});
    check_weights({0, real(0.7)}, {0, 0});
}

TEST_CASE("14.1 the points are spread evenly over the triangle", "[14.1]") {
    // Of 10,000 right answers with a random seed, one would fail.
    rt::Rng rng{141, 1};
    constexpr long count = 64'000;
    std::vector<long> cells(64);
    for (long i = 0; i < count; ++i) {
        const Real x = rng.uniform(), y = rng.uniform();
        const Vec2 weights = rt::even_weights({x, y});
        const bool is_inside =
            weights.x >= 0 && weights.y >= 0 && weights.x + weights.y <= 1 + 4 * rt::epsilon;
        if (!is_inside) {
            INFO("the weights " << text(weights) << " at the sample point " << text(Vec2{x, y}));
            INFO(
                "Hint: no weight is negative, and the sum of both is at most 1: otherwise the "
                "point is outside the triangle");
            REQUIRE(is_inside);
        }
        ++cells[cell_of(weights)];
    }
    const std::vector<double> expected(64, static_cast<double>(count) / 64);
    const double statistic = chi_square(cells, expected);
    INFO(pictured(in_rows(cells), in_rows(expected), 15));
    INFO(
        "64,000 points in 64 equal triangles, a thousand expected in each: the one at corner a "
        "has "
        << cells[0] << ", the one at b has " << cells[14] << ", and the one at c has "
        << cells[63]);
    INFO("chi-square is " << statistic << ", and of right answers one in 10,000 is above "
                          << chi_square_limit(63));
    INFO("Hint: " << even_hint);
    CHECK(statistic < chi_square_limit(63));
}

TEST_CASE("14.1 place.x is a share of the area and place.y a position along a line", "[14.1]") {
    rt::Rng rng{141, 2};
    for (int i = 0; i < 1000; ++i) {
        const Real s = rng.uniform(), y = rng.uniform();
        check_weights({s * s, y}, {s * (1 - y), s * y});
    }
}

TEST_CASE("14.1 the density agrees with an example on paper", "[14.1]") {
    // The example of the text: legs of 1, so the area is 1/2.
    const Triangle facing{{0, 2, 0}, {1, 2, 0}, {0, 2, 1}};
    check_density(facing, {0, 0, 0}, {0, 2, 0}, 8 * rt::epsilon, formula_hint);
    CHECK(std::abs(rt::light_density(facing, {0, 0, 0}, {0, 2, 0}) - 8) <= 64 * rt::epsilon);
    // From the side, at a distance of the root of 6.
    const Triangle low{{0, 1, 0}, {2, 1, 0}, {0, 1, 2}};
    check_density(low, {real(-2), 0, real(-1)}, {0, 1, 0}, 16 * rt::epsilon, formula_hint);
}

TEST_CASE("14.1 the density is the distance squared over area and cosine", "[14.1]") {
    rt::Rng rng{141, 3};
    for (int i = 0; i < 1000; ++i) {
        const auto [light, from] = seen_lamp(rng);
        const Real s = std::sqrt(rng.uniform()), y = rng.uniform();
        check_density(light, from, point_of(light, {s * (1 - y), s * y}), 200 * rt::epsilon,
                      formula_hint);
    }
}

TEST_CASE("14.1 both sides of a lamp shine", "[14.1]") {
    rt::Rng rng{141, 4};
    for (int i = 0; i < 100; ++i) {
        const auto [light, from] = seen_lamp(rng);
        const Triangle turned{light.a, light.c, light.b};
        const char* const hint =
            "from behind, the normal leads away and the cosine is negative: take std::abs of it";
        check_density(light, from, light.a, 200 * rt::epsilon, hint);
        check_density(turned, from, light.a, 200 * rt::epsilon, hint);
        CHECK(rt::sample_light(turned, from, {real(0.3), real(0.6)}));
    }
}

TEST_CASE("14.1 each sample leads to its point of the triangle", "[14.1]") {
    rt::Rng rng{141, 5};
    for (int i = 0; i < 1000; ++i) {
        const auto [light, from] = seen_lamp(rng);
        const Real x = rng.uniform(), y = rng.uniform();
        const LightSample sample = sampled(light, from, {x, y});
        const Vec3 point = point_of(light, {std::sqrt(x) * (1 - y), std::sqrt(x) * y});
        INFO(text(light) << ", seen from " << text(from) << ", place " << text(Vec2{x, y}));
        INFO("direction " << text(sample.direction) << ", distance " << text(sample.distance)
                          << "; the point is " << text(point));
        {
            INFO("Hint: the direction has length 1: normalize the vector from `from` to the point");
            REQUIRE(std::abs(rt::length(sample.direction) - 1) <= 8 * rt::epsilon);
        }
        {
            INFO("Hint: from + distance * direction is the point of even_weights(place)");
            const Vec3 reached = from + sample.distance * sample.direction;
            REQUIRE(rt::length(reached - point) <= 64 * rt::epsilon);
        }
        const Real density = rt::light_density(light, from, point);
        HINT(density, sample.density, "the density of the sample is light_density at its point");
        const bool is_near = std::abs(sample.density - density) <= 200 * rt::epsilon * density;
        REQUIRE(is_near);
    }
}

TEST_CASE("14.1 a large lamp close by is sampled as well", "[14.1]") {
    const Triangle wall{{-20, 1, -20}, {20, 1, -20}, {0, 1, 30}};
    const Vec3 from{0, 0, 0};
    for (const Real x : {real(0.1), real(0.3), real(0.5)}) {
        const LightSample sample = sampled(wall, from, {x, real(0.5)});
        INFO("a density may be less than 1, here " << text(sample.density));
        CHECK(sample.density > 0);
        CHECK(rt::light_density(wall, from, {0, 1, 0}) < real(0.1));
    }
}

TEST_CASE("14.1 the densities of all directions add up to 1", "[14.1]") {
    // The mean of 1 / density over all samples is the solid angle. Of 15,000 right answers with
    // other seeds, one would fail in one of the five.
    rt::Rng rng{141, 6};
    for (int i = 0; i < 5; ++i) {
        const auto [light, from] = seen_lamp(rng);
        Mean mean;
        for (int n = 0; n < 20'000; ++n) {
            const Real x = rng.uniform(), y = rng.uniform();
            mean.add(1 / static_cast<double>(sampled(light, from, {x, y}).density));
        }
        const double expected = exact_solid_angle_of(light, from);
        HINT(real(expected), real(mean.mean()),
             "this is the triangle's solid angle, the mean of 1 / density over 20,000 samples: a "
             "density per area must be turned into one per solid angle");
        CHECK(std::abs(mean.mean() - expected) < 4.3 * mean.standard_error());
    }
}

TEST_CASE("14.1 a floor gets the light that the formula for polygons gives it", "[14.1]") {
    // Lambert's sum over the edges knows no samples. One right answer in 15,000 would fail.
    rt::Rng rng{141, 7};
    for (int i = 0; i < 5; ++i) {
        const Triangle light = placed(plain_triangle(rng), 1, {0, real(2.5), 0});
        const Vec3 from{rng.uniform(-1, 1), 0, rng.uniform(-1, 1)}, up{0, 1, 0};
        Mean mean;
        for (int n = 0; n < 20'000; ++n) {
            const Real x = rng.uniform(), y = rng.uniform();
            const LightSample sample = sampled(light, from, {x, y});
            mean.add(static_cast<double>(rt::dot(up, sample.direction) / sample.density));
        }
        const double expected = exact_irradiance(light, from, up);
        HINT(real(expected), real(mean.mean()),
             "this is the irradiance, the mean of cosine / density over 20,000 samples, where the "
             "cosine is that on the floor; the cosine on the lamp belongs into the density");
        CHECK(std::abs(mean.mean() - expected) < 4.3 * mean.standard_error());
    }
}

TEST_CASE("14.1 huge and tiny scenes have the same densities", "[14.1][hard]") {
    rt::Rng rng{141, 8};
    const int far = for_this_precision(50, 400);
    for (const int power : {-far, -far / 2, far / 2, far})
        for (int i = 0; i < 20; ++i) {
            const auto [light, from] = seen_lamp(rng);
            const Real scale = std::ldexp(Real(1), power);
            const Triangle scaled = placed(light, scale, {});
            const Real density = rt::light_density(light, from, light.b);
            const Real same = rt::light_density(scaled, scale * from, scaled.b);
            INFO("the scene times " << text(scale));
            HINT(density, same,
                 "a product of lengths has overflowed or underflowed: measure all lengths in a "
                 "unit of about the triangle's size, a power of 2, before you multiply them");
            const bool is_near = std::abs(same - density) <= 16 * rt::epsilon * density;
            REQUIRE(is_near);
            CHECK(rt::sample_light(scaled, scale * from, {real(0.5), real(0.5)}));
        }
}

TEST_CASE("14.1 small distant lamps and large near ones have densities", "[14.1][hard]") {
    rt::Rng rng{141, 9};
    for (const int power : {-40, -20, 12})
        for (int i = 0; i < 20; ++i) {
            const auto [light, from] = seen_lamp(rng);
            const Triangle scaled = placed(light, std::ldexp(Real(1), power), {});
            const Vec3 away = power < 0 ? from : std::ldexp(Real(1), power - 6) * from;
            check_density(scaled, away, scaled.a, 400 * rt::epsilon,
                          "the area of a tiny triangle and the square of a large distance are far "
                          "apart: measure both in a unit of about the triangle's size");
        }
}

TEST_CASE("14.1 the cosine of a lamp seen edge-on keeps its digits far from the origin",
          "[14.1][hard]") {
    rt::Rng rng{141, 10};
    for (int i = 0; i < 300; ++i) {
        const Vec3 far = 1024 * in_cube(rng);
        const Triangle light = placed(plain_triangle(rng), 1, far);
        const Vec3 ab = light.b - light.a, ac = light.c - light.a;
        const Vec3 normal = rt::normalize(rt::cross(ab, ac));
        const Real height = any_size(rng, -5, -1);
        const Vec3 from = light.a + rng.uniform(2, 4) * rt::normalize(ab + ac) + height * normal;
        const Real s = std::sqrt(rng.uniform()), y = rng.uniform();
        const Vec3 point = point_of(light, {s * (1 - y), s * y});
        const Exact expected = exact_solid_angle(light, from, point);
        const Real density = rt::light_density(light, from, point);
        const Exact way = exact_length(exact_vector(point) - exact_vector(from));
        const double area_over_squared =
            (exact_length(exact_normal(light)) / (Exact(2) * way * way)).high;
        INFO(text(light) << ", seen from " << text(from) << " toward " << text(point));
        HINT(expected, 1 / density,
             "this is 1 / density. The point has been rounded, and so is its direction: a corner "
             "says more exactly how far the plane is");
        const double allowed = static_cast<double>(rt::rounding_bound(60)) * area_over_squared;
        // Where the exact value is below what is allowed, there may be no density.
        if (density == 0)
            REQUIRE(expected.high <= allowed);
        else
            REQUIRE(times_allowed(1 / density, expected, allowed) <= 1);
    }
}

TEST_CASE("14.1 a triangle without area has no density and no sample", "[14.1][hard]") {
    rt::Rng rng{141, 11};
    const Vec3 from{1, 2, 3};
    for (const Triangle& light :
         {Triangle{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, Triangle{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}},
          Triangle{{0, 1, 0}, {1, 2, 1}, {2, 3, 2}}}) {
        INFO(text(light));
        INFO("Hint: no light comes from a triangle without area: return 0, and no sample");
        CHECK(rt::light_density(light, from, light.b) == 0);
        CHECK_FALSE(rt::sample_light(light, from, {rng.uniform(), rng.uniform()}));
    }
}

TEST_CASE("14.1 a lamp seen exactly edge-on has no density and no sample", "[14.1][hard]") {
    const Triangle light{{0, 1, 0}, {2, 1, 0}, {0, 1, 2}};
    for (const Vec3 from : {Vec3{5, 1, 3}, Vec3{real(0.5), 1, real(0.5)}, Vec3{0, 1, 0}}) {
        INFO("seen from " << text(from) << ", in its plane");
        INFO("Hint: the cosine is 0, and distance^2 / 0 is infinite or NaN: return 0, no sample");
        CHECK(rt::light_density(light, from, {real(0.5), 1, real(0.5)}) == 0);
        CHECK_FALSE(rt::sample_light(light, from, {real(0.25), real(0.5)}));
    }
    INFO("Hint: from a point of the lamp itself there is no direction to that point");
    CHECK(rt::light_density(light, {0, 1, 0}, {0, 1, 0}) == 0);
    CHECK_FALSE(rt::sample_light(light, {0, 1, 0}, {0, 0}));
}

TEST_CASE("14.1 a density that no number can hold is 0", "[14.1][hard]") {
    const Real tiny = std::sqrt(std::numeric_limits<Real>::min()),
               far = std::sqrt(std::numeric_limits<Real>::max());
    const Triangle speck{{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}};
    INFO("Hint: only a normal number is a density: std::isnormal");
    CHECK(rt::light_density(speck, {0, 0, far}, {0, 0, 0}) == 0);
    CHECK_FALSE(rt::sample_light(speck, {0, 0, far}, {real(0.5), real(0.5)}));
    const Triangle wall{{-far, 0, -far}, {far, 0, -far}, {0, 0, far}};
    CHECK(rt::light_density(wall, {0, tiny, 0}, {0, 0, 0}) == 0);
}
