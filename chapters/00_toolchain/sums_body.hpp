// Three ways to add up numbers. Two files compile this text, one of them with -ffast-math, so there
// is no #pragma once, and an unnamed namespace keeps the functions of the two files apart. The text
// includes no header that defines functions: if both files compiled the same inline function, the
// linker would keep only one of the two versions, and nobody could say which.

namespace {

using toolchain::Real;

// Adds one term after the other. The k-th addition may be off by half a unit in the last place of
// the partial sum, so the error may grow with the number of terms.
Real naive(const Real* terms, std::size_t count) {
    Real sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += terms[i];
    return sum;
}

// Adds the sums of the two halves. Every term goes through about log2(count) additions instead of
// up to `count`. Short pieces are added up one after the other, because calls cost time.
Real pairwise(const Real* terms, std::size_t count) {
    if (count <= 128) return naive(terms, count);
    const std::size_t half = count / 2;
    return pairwise(terms, half) + pairwise(terms + half, count - half);
}

// Kahan's method: what rounding took away from one addition goes into the next one. With real
// numbers, `lost` would always be 0. So the compiler removes it under -ffast-math, which allows
// calculating as if numbers were real.
Real compensated(const Real* terms, std::size_t count) {
    Real sum = 0, lost = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Real term = terms[i] - lost;
        const Real next = sum + term;
        lost = (next - sum) - term;
        sum = next;
    }
    return sum;
}

}  // namespace
