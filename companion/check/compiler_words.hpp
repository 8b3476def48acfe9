#pragma once
#include <string>

namespace companion {

// What a compiler's error or warning usually means, in plain words; empty for an unusual one.
std::string plain_words(const std::string& error);

}  // namespace companion
