#include "checkpoint.hpp"
