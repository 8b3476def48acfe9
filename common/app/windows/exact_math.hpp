#pragma once
// x y + z, rounded once, computed in software. std::fma calls these functions on a processor that
// has no instruction for x y + z.

namespace app {

double fma_of_integers(double x, double y, double z);
float fma_of_doubles(float x, float y, float z);

}  // namespace app
