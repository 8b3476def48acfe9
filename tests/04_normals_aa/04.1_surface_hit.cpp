#include <rt/surface_hit.hpp>

#include "checkpoint.hpp"
