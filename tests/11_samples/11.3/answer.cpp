#include <answer.hpp>
#include <rt/twin_halves.hpp>

namespace answer EXPORTED {

int worth_of(rt::Real spread, rt::Real mean_spread, rt::Real error, rt::CountLimits limits) {
    return rt::worth_of(spread, mean_spread, error, limits);
}

rt::Halves<int> crossed_counts(rt::Halves<rt::Real> spread, rt::Halves<rt::Real> mean_spread,
                               rt::Real error, rt::CountLimits limits) {
    return rt::crossed_counts(spread, mean_spread, error, limits);
}

rt::Real twin_mean(rt::Halves<rt::Real> mean) {
    return rt::twin_mean(mean);
}

rt::Real twin_square_error(rt::Halves<rt::Real> mean) {
    return rt::twin_square_error(mean);
}

}  // namespace EXPORTED
