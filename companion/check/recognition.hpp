#pragma once
// Recognizing the known mistakes by what fails.

#include <companion/check/signature.hpp>
#include <map>
#include <string>
#include <vector>

namespace companion {

using Signatures = std::map<std::string, Signature>;  // by the mistake's name

// Mistakes with the same signature: an answer contains one of them, but nobody can tell which.
using LookAlikes = std::vector<std::string>;

// The mistake that an answer resembles, or the two mistakes that were made at once. Empty if no
// mistake is similar enough, or if several are about equally similar.
std::vector<LookAlikes> recognize(const Signatures& known, const std::string& exercise,
                                  const Signature& signature);

}  // namespace companion
