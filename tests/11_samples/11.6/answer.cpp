#include <answer.hpp>
#include <rt/denoise.hpp>

namespace answer EXPORTED {

rt::Real bilateral_weight(int across, int down, const rt::Features& a, const rt::Features& b,
                          const rt::DenoiseWidths& widths) {
    return rt::bilateral_weight(across, down, a, b, widths);
}

rt::Image denoised(const rt::Image& picture, const rt::Canvas<rt::Features>& features,
                   const rt::DenoiseWidths& widths) {
    return rt::denoised(picture, features, widths);
}

}  // namespace EXPORTED
