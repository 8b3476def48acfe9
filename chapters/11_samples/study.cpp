#include "study.hpp"

namespace samples {

void run_study(study::Report&) {}

}  // namespace samples
