#include "../../03.2/rt/hit_sphere.hpp"
