#include <answer.hpp>
#include <rt/sobol.hpp>

namespace answer EXPORTED {

std::uint32_t reversed_bits(std::uint32_t x) {
    return rt::reversed_bits(x);
}

rt::FixedPoint2 sobol_point(std::uint32_t index) {
    return rt::sobol_point(index);
}

std::uint32_t owen_scrambled(std::uint32_t fraction, std::uint32_t seed) {
    return rt::owen_scrambled(fraction, seed);
}

}  // namespace EXPORTED
