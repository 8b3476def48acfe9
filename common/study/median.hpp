#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace study {

// The median of one or more numbers. If their count is even, the result is the larger of the two in
// the middle.
inline double median(std::vector<double> numbers) {
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::nth_element(numbers.begin(), middle, numbers.end());
    return *middle;
}

}  // namespace study
