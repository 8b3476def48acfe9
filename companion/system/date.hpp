#pragma once
#include <ctime>
#include <string>

namespace companion {

// The day of a time, where the learner is: "2030-01-31".
std::string date_of(std::time_t time);

}  // namespace companion
