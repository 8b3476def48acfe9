#pragma once
#include <rt/canvas.hpp>
#include <rt/denoise_widths.hpp>
#include <rt/image.hpp>

namespace answer {

rt::Real bilateral_weight(int across, int down, const rt::Features& a, const rt::Features& b,
                          const rt::DenoiseWidths& widths);
rt::Image denoised(const rt::Image& picture, const rt::Canvas<rt::Features>& features,
                   const rt::DenoiseWidths& widths);

}  // namespace answer

namespace rt {

using answer::bilateral_weight;
using answer::denoised;

}  // namespace rt
