#include <answer.hpp>
#include <rt/running_variance.hpp>

namespace answer EXPORTED {

void add(rt::RunningVariance& known, rt::Real number) {
    rt::add(known, number);
}

rt::Real variance(const rt::RunningVariance& known) {
    return rt::variance(known);
}

}  // namespace EXPORTED
