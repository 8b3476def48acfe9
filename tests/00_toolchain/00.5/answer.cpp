#include <answer.hpp>
#include <rt/chain.hpp>

namespace answer EXPORTED {

rt::Real sum_along(const rt::Link* first) {
    return rt::sum_along(first);
}

std::vector<rt::Link> gathered(const rt::Link* first) {
    return rt::gathered(first);
}

}  // namespace EXPORTED
