#include <checkpoint.hpp>
