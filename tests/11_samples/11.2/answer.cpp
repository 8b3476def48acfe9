#include <answer.hpp>
#include <rt/standard_error.hpp>

namespace answer EXPORTED {

rt::Real standard_error(const rt::RunningVariance& known) {
    return rt::standard_error(known);
}

rt::Real chance_within(rt::Real distance, rt::Real error) {
    return rt::chance_within(distance, error);
}

std::int64_t samples_for(rt::Real variance, rt::Real error, std::int64_t most) {
    return rt::samples_for(variance, error, most);
}

}  // namespace EXPORTED
