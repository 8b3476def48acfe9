#include <rt/length.hpp>

#include "checkpoint.hpp"
#include "random_inputs.hpp"

using namespace checkpoint;

namespace {

// A vector v 2^exponent whose length and direction are known exactly, even where squares
// overflow or underflow.
struct Scaled {
    Vec3 v;
    int exponent;

    Vec3 vector() const {
        return {std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)};
    }
    // Whether the squares of the components can be added without overflow or underflow.
    bool is_ordinary() const { return std::abs(exponent) < 30; }
};

// A vector as it is. A component that is lost beside the largest one counts as 0 to all digits.
Scaled scaled(Vec3 v) {
    const int exponent = std::ilogb(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
    return {{std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)},
            exponent};
}

// A vector of any size. If it is too small to keep all its digits, the rounded vector is the
// one that counts.
Scaled any_scaled(rt::Rng& rng, int lowest, int highest) {
    const int exponent = lowest + static_cast<int>(rng() % static_cast<unsigned>(highest - lowest));
    Scaled scaled{any_vector(rng, -4, 0), exponent};
    while (scaled.v == Vec3{}) scaled.v = any_vector(rng, -4, 0);
    const Vec3 rounded = scaled.vector();  // the smallest numbers have few digits
    scaled.v = {std::scalbn(rounded.x, -exponent), std::scalbn(rounded.y, -exponent),
                std::scalbn(rounded.z, -exponent)};
    return scaled;
}

// The exponents of the smallest and the largest number.
constexpr int smallest_exponent =
    std::numeric_limits<Real>::min_exponent - std::numeric_limits<Real>::digits;
constexpr int largest_exponent = std::numeric_limits<Real>::max_exponent - 1;

// The error allowed: the 3 roundings of the sum of three squares, halved by the root, and the
// root's own: 2.5 units.
void check_length(const Scaled& scaled) {
    const Vec3 v = scaled.vector();
    const Exact exact = exact_length(exact_vector(scaled.v));
    const Real computed = rt::length(v), scaled_back = std::scalbn(computed, -scaled.exponent);
    const Real smallest = std::scalbn(std::numeric_limits<Real>::denorm_min(), -scaled.exponent);
    const double ulp =
        static_cast<double>(std::max(smallest, study::ulp(static_cast<Real>(exact.high))));
    INFO("length(" << text(v) << ")");
    HINT(std::scalbn(static_cast<Real>(exact.high), scaled.exponent), computed,
         scaled.is_ordinary() ? "the length is the square root of v . v"
                              : "v . v overflows or loses digits to underflow here: first scale v "
                                "with split_scale, then scale the result back with std::scalbn");
    const double off_in_ulp = times_allowed(scaled_back, exact, ulp);
    REQUIRE(off_in_ulp <= 2.5);
}

// The same, and one division more.
void check_normalize(const Scaled& scaled) {
    const Vec3 v = scaled.vector();
    const ExactVec3 exact = exact_unit(exact_vector(scaled.v));
    const Vec3 computed = rt::normalize(v);
    INFO("normalize(" << text(v) << ")");
    HINT(exact, computed,
         scaled.is_ordinary() ? "divide each component by the length, once"
                              : "v . v overflows or underflows here: first scale v with "
                                "split_scale, which keeps the direction of v");
    REQUIRE(error_in_ulp(computed, exact) <= 3.5);
}

void check_both(const Scaled& scaled) {
    if (scaled.v == Vec3{}) return;  // too small for Real
    check_length(scaled);
    check_normalize(scaled);
}

template <class Check>
void for_ordinary_vectors(Check check) {
    for (const Vec3 v :
         {Vec3{1, 0, 0}, Vec3{0, -2, 0}, Vec3{3, 4, 0}, Vec3{2, 3, 6}, Vec3{-1, 1, 1}})
        check(scaled(v));
    rt::Rng rng{3, 3};
    for (int i = 0; i < 400; ++i) check(any_scaled(rng, -3, 4));
}

// Vectors whose squares overflow or underflow, or become subnormal numbers, which hold fewer digits
// the smaller they are.
template <class Check>
void for_huge_and_tiny_vectors(Check check) {
    constexpr int far = for_this_precision(30, 200), fading = for_this_precision(-19, -155);
    const auto power = [](int n) { return std::pow(Real(10), static_cast<Real>(n)); };
    rt::Rng rng{3, 4};
    for (const int n : {-far, -far / 2, fading, fading - 1, fading - 2, fading - 4, fading - 6, 19,
                        far / 2, far}) {
        check(scaled({3 * power(n), 0, 4 * power(n)}));
        for (int i = 0; i < 20;) {
            const Vec3 v = any_vector(rng, Real(n - 1), Real(n + 1));
            if (v == Vec3{}) continue;
            check(scaled(v));
            ++i;
        }
    }
    check(scaled({power(far), power(-far), 1}));
    check(scaled({1, power(-far), 0}));
}

}  // namespace

TEST_CASE("01.4 the length follows from Pythagoras", "[01.4]") {
    for_ordinary_vectors(check_length);
}

TEST_CASE("01.4 normalize keeps the direction and makes the length 1", "[01.4]") {
    for_ordinary_vectors(check_normalize);
}

TEST_CASE("01.4 the length of huge and tiny vectors is accurate to 2.5 units in the last place",
          "[01.4][hard]") {
    for_huge_and_tiny_vectors(check_length);
}

TEST_CASE("01.4 normalize is accurate to 3.5 units in the last place for huge and tiny vectors",
          "[01.4][hard]") {
    for_huge_and_tiny_vectors(check_normalize);
}

TEST_CASE("01.4 length and normalize are correct for vectors of any direction", "[01.4]") {
    rt::Rng rng{3, 1};
    for (int i = 0; i < 2000; ++i) check_both(any_scaled(rng, -10, 10));
    // Some already have a length of nearly 1.
    for (int i = 0; i < 200; ++i)
        check_both(
            {rt::normalize(any_vector(rng, -1, 0) + Vec3{2, 0, 0}) * (1 + any_number(rng, -15, -1)),
             0});
}

TEST_CASE("01.4 length and normalize work for the smallest and the largest numbers",
          "[01.4][hard]") {
    rt::Rng rng{3, 2};
    for (int i = 0; i < 2000; ++i) {
        check_both(any_scaled(rng, smallest_exponent, largest_exponent - 1));
        // Where squares begin to be too small and too large.
        check_both(any_scaled(rng, smallest_exponent / 2 - 4, smallest_exponent / 2 + 60));
        check_both(any_scaled(rng, largest_exponent / 2 - 4, largest_exponent / 2 + 8));
    }
    const Real largest = std::numeric_limits<Real>::max();
    for (const Scaled& one :
         {Scaled{{1, 0, 0}, smallest_exponent}, Scaled{{2 - rt::epsilon, 0, 0}, largest_exponent}})
        for (const Real sign : {Real(1), Real(-1)}) {
            const Real size = sign * one.v.x;
            check_both({{size, 0, 0}, one.exponent});
            check_both({{0, size, 0}, one.exponent});
            check_both({{0, 0, size}, one.exponent});
        }
    INFO("the length of (0, 0, 0) must be 0");
    CHECK(rt::length({0, 0, 0}) == 0);
    INFO(
        "if all three components are the largest number, the length does not fit into a Real: it "
        "must be infinite");
    CHECK(rt::length({largest, largest, -largest}) == rt::infinity);
}

TEST_CASE("01.4 normalize refuses a vector without a direction", "[01.4][hard]") {
    INFO(
        "Hint: throw std::domain_error(\"why\") if the vector is zero, infinite or NaN; test it "
        "with is_finite(v)");
    const Real zero = 0, nan = std::numeric_limits<Real>::quiet_NaN();
    CHECK_THROWS_AS(rt::normalize({0, 0, 0}), std::domain_error);
    CHECK_THROWS_AS(rt::normalize({-zero, 0, -zero}), std::domain_error);
    for (const Real bad : {rt::infinity, -rt::infinity, nan})
        for (const Real other : {Real(0), Real(1), std::numeric_limits<Real>::max()})
            for (const Vec3 v :
                 {Vec3{bad, other, other}, Vec3{other, bad, other}, Vec3{other, other, bad}}) {
                INFO("normalize(" << text(v) << ") must throw std::domain_error");
                CHECK_THROWS_AS(rt::normalize(v), std::domain_error);
            }
}
