#include <rt/reflect.hpp>

#include "exact_vectors.hpp"

using namespace checkpoint;

TEST_CASE("05.1 a mirror turns the part along the normal around", "[05.1]") {
    const auto check = [](Vec3 incoming, Vec3 normal, Vec3 expected) {
        const Vec3 computed = rt::reflect(incoming, normal);
        INFO("reflect(" << text(incoming) << ", " << text(normal) << ")");
        const char* hint =
            "take the part along the normal away twice: once stops the light at the "
            "surface, twice throws it back";
        if (computed == -expected)
            hint = "`incoming` points at the surface, the result away from it";
        else if (length(unit(exact(expected)) - exact(computed)).high <=
                 static_cast<double>(rt::rounding_bound(16)))
            hint = "do not normalize: a long vector has a long mirror image";
        HINT(expected, computed, hint);
        CHECK(computed == expected);
    };
    check({3, -4, 1}, {0, 1, 0}, {3, 4, 1});
    check({3, -4, 1}, {0, -1, 0}, {3, 4, 1});  // the other side's normal: the same mirror
    check({-2, 5, 7}, {1, 0, 0}, {2, 5, 7});
    check({1, 1, -1}, {0, 0, 1}, {1, 1, 1});
    check({1, 0, 2}, {0, 1, 0}, {1, 0, 2});  // along the surface
}

TEST_CASE("05.1 reflection keeps the length and the angle", "[05.1]") {
    rt::Rng rng{51, 1};
    for (int i = 0; i < 2000; ++i) {
        const auto [incoming, normal] = random_arrival(rng);
        const Vec3 computed = rt::reflect(incoming, normal);
        INFO("reflect(" << text(incoming) << ", " << text(normal) << ") = " << text(computed));
        // 5 roundings of terms that sum up to 3 at most, and a normal whose length is off by half
        // an epsilon, which counts 4 times.
        const double allowed = 5 * 3 / 2.0 + 2;
        {
            INFO("Hint: the length must stay as it was");
            REQUIRE(in_epsilon(length(exact(computed)) - length(exact(incoming))) <= allowed);
        }
        INFO("Hint: the cosine with the normal must stay as it was, but for its sign");
        REQUIRE(in_epsilon(dot(exact(computed), exact(normal)) +
                           dot(exact(incoming), exact(normal))) <= allowed);
    }
}

TEST_CASE("05.1 each component has the accuracy that the formula allows", "[05.1][hard]") {
    rt::Rng rng{51, 2};
    for (int i = 0; i < 2000; ++i) {
        const auto [d, n] = random_arrival(rng);
        const Vec3 computed = rt::reflect(d, n);
        const ExactVec3 correct = exact(d) - (Exact(2) * dot(exact(d), exact(n))) * exact(n);
        INFO("reflect(" << text(d) << ", " << text(n) << ")");
        HINT(correct, computed, "more than the five roundings of d - 2 (d . n) n");
        // The dot product rounds 3 times, the product with n and the difference once each.
        const Real terms = 2 * (std::abs(d.x * n.x) + std::abs(d.y * n.y) + std::abs(d.z * n.z));
        const auto within = [&](Real c, Exact e, Real dc, Real nc) {
            const Real allowed = rt::rounding_bound(5) * (std::abs(dc) + terms * std::abs(nc));
            return std::abs((e - exact(c)).high) <= static_cast<double>(allowed);
        };
        REQUIRE(within(computed.x, correct.x, d.x, n.x));
        REQUIRE(within(computed.y, correct.y, d.y, n.y));
        REQUIRE(within(computed.z, correct.z, d.z, n.z));
    }
}

TEST_CASE("05.1 long and short vectors are reflected alike", "[05.1][hard]") {
    rt::Rng rng{51, 3};
    const int far = for_this_precision(90, 900);  // powers of two
    for (int i = 0; i < 100; ++i) {
        const auto [incoming, normal] = random_arrival(rng);
        const Vec3 reflected = rt::reflect(incoming, normal);
        for (const int exponent : {-far, -40, 40, far}) {
            const Real scale = std::scalbn(Real(1), exponent);
            const Vec3 computed = rt::reflect(scale * incoming, normal);
            INFO("`incoming` was multiplied by 2^" << exponent);
            HINT(scale * reflected, computed,
                 "the result must grow and shrink with `incoming`: no normalizing, no constant");
            REQUIRE(computed == scale * reflected);
        }
    }
}

TEST_CASE("05.1 light that grazes the surface leaves it again", "[05.1][hard]") {
    for (Real tiny = 1; tiny > std::numeric_limits<Real>::min(); tiny /= 64) {
        const Vec3 computed = rt::reflect({1, -tiny, 0}, floor_normal);
        HINT((Vec3{1, tiny, 0}), computed, "no angle is too small to be reflected");
        REQUIRE(computed == Vec3{1, tiny, 0});
    }
}
