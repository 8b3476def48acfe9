#include <answer.hpp>
#include <functional>
#include <rt/sample_rng.hpp>

namespace answer EXPORTED {

rt::Rng sample_rng(std::uint64_t seed, int x, int y, int sample) {
    return rt::sample_rng(seed, x, y, sample);
}

rt::Color average_samples(std::uint64_t seed, int x, int y, int samples,
                          const std::function<rt::Color(int, rt::Rng&)>& draw) {
    return rt::average_samples(seed, x, y, samples, draw);
}

}  // namespace EXPORTED
