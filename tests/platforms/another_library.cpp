// A mathematical library whose results are off by a unit in the last place, one way or the other,
// for about half of all numbers: loaded before the system's, it stands in for any other library. It
// leaves alone what IEEE 754 prescribes, such as sqrt, fma and fmod.
#include <dlfcn.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace {

template <class Number>
Number moved(Number result, Number argument) {
    using Word = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;
    // sin 0, exp 0, log 1, ...: all libraries agree.
    if (result == 0 || std::abs(result) == 1 || !std::isfinite(result)) return result;
    std::uint64_t lot = std::bit_cast<Word>(argument) * 0x9e3779b97f4a7c15u;
    lot = (lot ^ (lot >> 29)) * 0xbf58476d1ce4e5b9u;
    lot ^= lot >> 32;
    const auto bits = std::bit_cast<Word>(result);
    return std::bit_cast<Number>(
        static_cast<Word>(lot & 1 ? (lot & 2 ? bits + 1 : bits - 1) : bits));
}

template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

#define OF_ONE(name, Number)                                   \
    extern "C" Number name(Number x) noexcept {                \
        static const auto right = next<Number(Number)>(#name); \
        return moved(right(x), x);                             \
    }
#define OF_TWO(name, Number)                                           \
    extern "C" Number name(Number x, Number y) noexcept {              \
        static const auto right = next<Number(Number, Number)>(#name); \
        return moved(right(x, y), x + 3 * y);                          \
    }
#define TURNED(name, Number)                                                   \
    extern "C" void name(Number x, Number* sine, Number* cosine) noexcept {    \
        static const auto right = next<void(Number, Number*, Number*)>(#name); \
        right(x, sine, cosine);                                                \
        *sine = moved(*sine, x);                                               \
        *cosine = moved(*cosine, x + 1);                                       \
    }
#define BOTH(OF, name) OF(name, double) OF(name##f, float)

BOTH(OF_ONE, sin)
BOTH(OF_ONE, cos)
BOTH(OF_ONE, tan)
BOTH(OF_ONE, asin)
BOTH(OF_ONE, acos)
BOTH(OF_ONE, atan)
BOTH(OF_ONE, sinh)
BOTH(OF_ONE, cosh)
BOTH(OF_ONE, tanh)
BOTH(OF_ONE, exp)
BOTH(OF_ONE, exp2)
BOTH(OF_ONE, expm1)
BOTH(OF_ONE, log)
BOTH(OF_ONE, log2)
BOTH(OF_ONE, log10)
BOTH(OF_ONE, log1p)
BOTH(OF_ONE, cbrt)
BOTH(OF_ONE, erf)
BOTH(OF_TWO, atan2)
BOTH(OF_TWO, pow)
BOTH(OF_TWO, hypot)
BOTH(TURNED, sincos)
