#include "../../04.6/rt/leave_surface.hpp"
