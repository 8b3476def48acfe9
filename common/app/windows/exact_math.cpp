// std::fma and std::sqrt, rounded once, as IEEE 754 requires. Those of MinGW's library round twice,
// and they are called where the processor has no instruction for these functions, or the compiler
// does not optimize.
#include <emmintrin.h>

#include <app/windows/exact_math.hpp>
#include <bit>
#include <cmath>
#include <cstdint>

namespace app {
namespace {

__extension__ using Wide = __int128;

// A number m 2^e, where m has 53 bits.
struct Split {
    std::int64_t m;
    int e;
};

Split split(double x) {
    int e = 0;
    const double m = std::frexp(x, &e);
    return {static_cast<std::int64_t>(std::ldexp(m, 53)), e - 53};
}

// m 2^-count, rounded to odd: if the bits that are lost are not all 0, the last bit becomes 1. If
// this result is rounded again, to at least two bits fewer, the outcome is the same as if m were
// rounded once.
Wide shifted_right(Wide m, int count) {
    if (count > 126) return m < 0 ? -1 : m > 0;
    const Wide shifted = m >> count;
    return shifted << count == m ? shifted : shifted | 1;
}

// m 2^e for m > 0, rounded once.
double rounded(Wide m, int e) {
    constexpr int most = 62, of_double = 53, least = -1074;  // bits, bits, and an exponent
    int bits = 0;
    while (m >> bits != 0) ++bits;
    if (bits > most) {
        m = shifted_right(m, bits - most);
        e += bits - most;
        bits = most;
    }
    if (const int lost = least - e; lost > bits - of_double && lost > 0) {  // a subnormal number
        m = shifted_right(m << 2, lost);
        // The last bit that stays, the next bit, and whether any bit after that is 1.
        const auto end = static_cast<int>(m & 7);
        m = (m >> 2) + (end == 3 || end > 5);
        e = least;
    }
    return std::ldexp(static_cast<double>(static_cast<std::int64_t>(m)), e);
}

}  // namespace

double fma_of_integers(double x, double y, double z) {
    if (x == 0 || y == 0 || !std::isfinite(x) || !std::isfinite(y)) return x * y + z;
    if (!std::isfinite(z)) return z;
    if (z == 0) return x * y;
    const Split a = split(x), b = split(y), c = split(z);
    Wide product = Wide{a.m} * b.m, other = c.m;  // with 106 bits and with 53 bits
    int e = a.e + b.e, up = c.e - e;  // other is in units 2^up times as large as product's
    constexpr int product_room = 20, other_room = 73;
    if (up > other_room) {
        product = shifted_right(product, up - other_room);
        e = c.e - other_room;
        up = other_room;
    } else if (up < 0) {
        const int shift = -up < product_room ? -up : product_room;
        product <<= shift;
        e -= shift;
        up += shift;
    }
    const Wide sum = product + (up < 0 ? shifted_right(other, -up) : other << up);
    return sum == 0 ? 0 : sum < 0 ? -rounded(-sum, e) : rounded(sum, e);
}

float fma_of_doubles(float x, float y, float z) {
    const double product = double{x} * y, sum = product + z, added = sum - product;
    const double error = (product - (sum - added)) + (z - added);
    if (!std::isfinite(sum) || error == 0) return static_cast<float>(sum);
    // Rounded to odd.
    auto bits = std::bit_cast<std::uint64_t>(sum);
    if (bits % 2 == 0) bits += (error > 0) == (sum > 0) ? 1 : -1;
    return static_cast<float>(std::bit_cast<double>(bits));
}

}  // namespace app

namespace {

[[gnu::target("fma")]] double fma_of_processor(double x, double y, double z) {
    return __builtin_fma(x, y, z);
}

[[gnu::target("fma")]] float fma_of_processor(float x, float y, float z) {
    return __builtin_fmaf(x, y, z);
}

bool has_instruction() {
    return __builtin_cpu_supports("fma");
}

}  // namespace

extern "C" {

double fma(double x, double y, double z) {
    return has_instruction() ? fma_of_processor(x, y, z) : app::fma_of_integers(x, y, z);
}

float fmaf(float x, float y, float z) {
    return has_instruction() ? fma_of_processor(x, y, z) : app::fma_of_doubles(x, y, z);
}

double sqrt(double x) {
    return _mm_cvtsd_f64(_mm_sqrt_sd(_mm_setzero_pd(), _mm_set_sd(x)));
}

}  // extern "C"
