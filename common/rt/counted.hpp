#pragma once
#include <concepts>
#include <string>

namespace rt {

// "1 sphere", "2 spheres". The noun is given in the singular, and its plural ends in s.
std::string counted(std::integral auto count, const std::string& noun) {
    return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

}  // namespace rt
