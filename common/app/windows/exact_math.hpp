#pragma once
// x y + z, rounded once, in software: std::fma calls it on a processor that has no instruction for
// that.

namespace app {

double fma_of_integers(double x, double y, double z);
float fma_of_doubles(float x, float y, float z);

}  // namespace app
