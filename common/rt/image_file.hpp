#pragma once
#include <rt/image.hpp>
#include <string>

namespace rt {

// The bytes of an image file in sRGB, 8 bits per channel. Light above 1 is stored as 1. Throws
// std::logic_error if a color is not finite: that is always a bug.
std::string encode_png(const Image& image);
std::string encode_ppm(const Image& image);  // the binary form, P6

// The picture in the bytes of a PNG file, as linear light; transparency is ignored. JPEG files are
// not read: fuzzing found that the library's JPEG reader, in the version that systems provide,
// writes beyond the end of an array. Throws std::length_error if the picture has more than
// `most_pixels` pixels, and std::runtime_error if the bytes are not a PNG file or the file is
// broken.
Image decode_image(const std::string& bytes, int most_pixels);

}  // namespace rt
