#pragma once

namespace rt {

// A value for each of two independent halves of the samples.
template <class T>
struct Halves {
    T first{}, second{};
};

// The fewest and the most samples that a part of the picture may get: 1 <= least <= most.
struct CountLimits {
    int least = 1, most = 1;
};

}  // namespace rt
