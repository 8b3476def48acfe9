#define OWN_RT rt_16
#define OWN_BATCHES batches_16
#include "narrow_lanes.hpp"

batches::Width batches::registers_of_16_bytes() {
    return batches_16::make_width();
}
