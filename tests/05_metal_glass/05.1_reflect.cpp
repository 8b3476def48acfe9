#include <rt/reflect.hpp>

#include "exact_vectors.hpp"

using namespace checkpoint;

namespace {

// How far a computed vector is from the exact one, in epsilon of the vector's length. Only the
// accuracy of the whole vector counts, not that of each component, since any way of mirroring will
// do, even one in a basis.
double off_in_epsilons(Vec3 computed, const ExactVec3& correct) {
    return in_epsilon(length(correct - exact(computed)) / length(correct));
}

ExactVec3 mirrored(Vec3 d, Vec3 n) {
    return exact(d) - (Exact(2) * dot(exact(d), exact(n))) * exact(n);
}

// An axis or the opposite of one.
Vec3 any_axis(rt::Rng& rng) {
    const Real sign = rng() & 1 ? Real(1) : Real(-1);
    const unsigned axis = rng() % 3;
    return {axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0};
}

void check_mirrored(Vec3 incoming, Vec3 normal, const char* hint) {
    const Vec3 computed = rt::reflect(incoming, normal);
    const ExactVec3 correct = mirrored(incoming, normal);
    const double off = off_in_epsilons(computed, correct);
    if (!(off <= 64)) {
        UNSCOPED_INFO("reflect(" << text(incoming) << ", " << text(normal) << ")");
        UNSCOPED_HINT(correct, computed, hint);
    }
    REQUIRE(off <= 64);
}

}  // namespace

TEST_CASE("05.1 a mirror reverses the direction's part along the normal", "[05.1]") {
    const auto check = [](Vec3 incoming, Vec3 normal, Vec3 expected) {
        const Vec3 computed = rt::reflect(incoming, normal);
        const double off = off_in_epsilons(computed, exact(expected));
        INFO("reflect(" << text(incoming) << ", " << text(normal) << ")");
        const char* hint =
            "subtract the part along the normal twice: if you subtract it once, the light runs "
            "along the surface";
        if (computed == -expected)
            hint = "`incoming` points at the surface, and the result must point away from it";
        else if (length(unit(exact(expected)) - exact(computed)).high <=
                 static_cast<double>(rt::rounding_bound(16)))
            hint = "do not normalize: a long vector has a long mirror image";
        HINT(expected, computed, hint);
        CHECK(off <= 8);
    };
    check({3, -4, 1}, {0, 1, 0}, {3, 4, 1});
    check({3, -4, 1}, {0, -1, 0}, {3, 4, 1});  // the other side's normal: the same mirror
    check({-2, 5, 7}, {1, 0, 0}, {2, 5, 7});
    check({1, 1, -1}, {0, 0, 1}, {1, 1, 1});
    check({1, 0, 2}, {0, 1, 0}, {1, 0, 2});  // along the surface
    check({3, -4, 1}, {real(0.6), real(0.8), 0}, {real(4.68), real(-1.76), 1});
}

TEST_CASE("05.1 reflection keeps the length and the angle", "[05.1]") {
    rt::Rng rng{51, 1};
    for (int i = 0; i < 2000; ++i) {
        const auto [incoming, normal] = random_arrival(rng);
        const Vec3 computed = rt::reflect(incoming, normal);
        const double longer = in_epsilon(length(exact(computed)) - length(exact(incoming)));
        const double turned =
            in_epsilon(dot(exact(computed), exact(normal)) + dot(exact(incoming), exact(normal)));
        const bool is_right = longer <= 64 && turned <= 64;
        if (!is_right) {
            INFO("reflect(" << text(incoming) << ", " << text(normal) << ") = " << text(computed));
            {
                INFO("Hint: the length must not change. The value is the difference, in epsilon");
                REQUIRE(longer <= 64);
            }
            INFO(
                "Hint: the cosine with the normal must only change its sign. The values are the "
                "difference, in epsilon");
            REQUIRE(turned <= 64);
        }
        REQUIRE(is_right);
    }
}

TEST_CASE("05.1 the mirror direction is accurate to 64 epsilon for any light and any normal",
          "[05.1][hard]") {
    rt::Rng rng{51, 2};
    for (int i = 0; i < 5000; ++i) {
        Vec3 normal = i % 8 ? random_unit(rng) : any_axis(rng);
        Vec3 incoming = random_unit(rng);  // from either side
        // Now and then all but along the surface, or all but along the normal.
        const Real tiny = std::pow(Real(10), rng.uniform(for_this_precision(-8, -17), 0));
        const Vec3 along = rounded(unit(cross(exact(normal), exact(incoming))));
        if (i % 4 == 0) incoming = along + (i % 8 ? tiny : -tiny) * normal;
        if (i % 4 == 1) incoming = (i % 8 == 1 ? normal : -normal) + tiny * along;
        if (i % 2 == 0) incoming *= std::scalbn(Real(1), static_cast<int>(rng() % 80) - 40);
        check_mirrored(incoming, normal,
                       "compute d - 2 (d . n) n for any length and angle; only the last digits may "
                       "be rounded");
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
            const Vec3 computed = rt::reflect(scale * incoming, normal) / scale;
            const double off = off_in_epsilons(computed, exact(reflected));
            if (!(off <= 8)) {
                UNSCOPED_INFO("`incoming` was multiplied by 2^" << exponent);
                UNSCOPED_HINT(scale * reflected, scale * computed,
                              "the result must grow and shrink with `incoming`: do not normalize, "
                              "and add no constant");
            }
            REQUIRE(off <= 8);
        }
    }
}

TEST_CASE("05.1 light that grazes the surface leaves it again", "[05.1][hard]") {
    for (Real tiny = 1; tiny > std::numeric_limits<Real>::min(); tiny /= 64)
        for (const Real side : {Real(1), Real(-1)}) {
            const Vec3 computed = rt::reflect({1, -tiny, 0}, {0, side, 0});
            const Vec3 expected{1, tiny, 0};
            const double off_in_ulp = error_in_ulp(computed, exact(expected));
            if (!(off_in_ulp <= 8))
                UNSCOPED_HINT(expected, computed, "light is reflected at any angle, however small");
            REQUIRE(off_in_ulp <= 8);
        }
}
