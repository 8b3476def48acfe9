#pragma once
#include <rt/real.hpp>

namespace rt {

// One link of a chain: a number, and the address of the next link. In the last link, that address
// is nullptr.
struct Link {
    Real value = 0;
    const Link* next = nullptr;
};

}  // namespace rt
