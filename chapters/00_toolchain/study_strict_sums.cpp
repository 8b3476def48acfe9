#include "sums.hpp"

#include "sums_body.hpp"

toolchain::Sums toolchain::strict_sums() {
    return {naive, pairwise, compensated};
}
