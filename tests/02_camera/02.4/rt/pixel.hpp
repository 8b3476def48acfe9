#include "../../02.1/rt/pixel.hpp"
