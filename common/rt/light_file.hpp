#pragma once
#include <rt/image.hpp>
#include <string>

// Picture files that store linear light, without an upper limit: .hdr and .pfm.

namespace rt {

// The bytes of a Radiance file (.hdr): a byte for each channel, and one exponent for all three. So
// a channel is too small by up to 1/128 of the largest channel. A channel below 0 is stored as 0,
// and light beyond 2^127 as the most that the format can hold. Throws std::logic_error if a color
// is not finite: that is always a bug.
std::string encode_hdr(const Image& image);

// The bytes of a portable float map (.pfm): three floats per pixel, rows from the bottom up. A
// channel below 0 stays as it is, and one beyond the largest float is stored as that. Throws
// std::logic_error if a color is not finite.
std::string encode_pfm(const Image& image);

// The largest number that decode_light accepts for a channel.
inline constexpr double brightest = 1e9;

// The picture in the bytes of a .hdr or .pfm file; the first bytes say which of them it is. A gray
// .pfm file (Pf) has three equal channels, and the size of its scale, if not 1, is a factor. The
// EXPOSURE of a .hdr file is ignored, as most programs do. Throws std::length_error if the picture
// has more than `most_pixels` pixels, and std::runtime_error if it cannot be used. The message then
// says why, in words that follow "the file", such as "ends too early". A channel must be a number
// from 0 to `brightest`.
Image decode_light(const std::string& bytes, int most_pixels);

}  // namespace rt
