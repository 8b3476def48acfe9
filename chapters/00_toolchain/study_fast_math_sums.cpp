#define RT_STUDIES_FAST_MATH
#include "sums.hpp"

#include "sums_body.hpp"

toolchain::Sums toolchain::fast_math_sums() {
    return {naive, pairwise, compensated};
}
