#pragma once
// Recognizing the known mistakes by what fails.

#include <companion/check/signature.hpp>
#include <map>
#include <string>
#include <vector>

namespace companion {

using Signatures = std::map<std::string, Signature>;  // by the mistake's name

// Mistakes that look the same from outside: it is one of them.
using LookAlikes = std::vector<std::string>;

// The mistake that an answer looks like; or the two that were made at once; or nothing, if no
// mistake is similar enough or several are nearly as similar.
std::vector<LookAlikes> recognize(const Signatures& known, const std::string& exercise,
                                  const Signature& signature);

}  // namespace companion
