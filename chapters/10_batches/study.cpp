#include "study.hpp"

namespace batches {

void run_study(study::Report&) {}

}  // namespace batches
