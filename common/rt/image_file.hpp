#pragma once
#include <rt/image.hpp>
#include <string>

namespace rt {

// The bytes of an image file in sRGB, 8 bits a channel. Light above 1 is stored as full.
// Throws std::logic_error, which is a bug to be found, when a color is not finite.
std::string encode_png(const Image& image);
std::string encode_ppm(const Image& image);  // the binary form, P6

// The picture in the bytes of a PNG file, as linear light; transparency is left out. JPEG is not
// read: fuzzing found that the library, as systems package it, writes beyond an array there.
// Throws std::length_error when it has more than this many pixels, std::runtime_error when it is no
// PNG file or a broken one.
Image decode_image(const std::string& bytes, int most_pixels);

}  // namespace rt
