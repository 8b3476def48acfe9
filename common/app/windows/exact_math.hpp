#pragma once
// x y + z, rounded once, without an instruction for it: what std::fma calls on a processor that has
// none.

namespace app {

double fma_of_integers(double x, double y, double z);
float fma_of_doubles(float x, float y, float z);

}  // namespace app
