#include <answer.hpp>
#include <functional>
#include <rt/jitter.hpp>
#include <rt/rng.hpp>

namespace answer EXPORTED {

rt::Vec2 jittered_offset(int cell, int n, rt::Vec2 place) {
    return rt::jittered_offset(cell, n, place);
}

rt::Color pixel_average(int samples, rt::Rng& random,
                        const std::function<rt::Color(rt::Vec2)>& sample) {
    return rt::pixel_average(samples, random, sample);
}

}  // namespace EXPORTED
