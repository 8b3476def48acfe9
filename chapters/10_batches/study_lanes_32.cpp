#define OWN_RT rt_32
#define OWN_BATCHES batches_32
#include "narrow_lanes.hpp"

batches::Width batches::registers_of_32_bytes() {
    return batches_32::make_width();
}
