#pragma once
#include <cstdio>
#include <random>
#include <string>

namespace companion {

// A word of 32 characters that nobody can guess.
inline std::string new_secret() {
    std::random_device random;
    char word[33];
    std::snprintf(word, sizeof word, "%08x%08x%08x%08x", random(), random(), random(), random());
    return word;
}

}  // namespace companion
