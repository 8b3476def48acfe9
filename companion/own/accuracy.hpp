#pragma once
// Reads and judges the learner's page accuracy.md.

#include <optional>
#include <string>
#include <vector>

namespace companion {

// What the page says about a choice: the compiler option that makes it, and the figures that the
// learner wrote.
struct AccuracyChoice {
    std::string option;
    std::optional<double> time, error;
};
std::vector<AccuracyChoice> accuracy_choices(const std::string& page);

}  // namespace companion
