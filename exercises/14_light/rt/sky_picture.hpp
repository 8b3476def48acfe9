#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <rt/light_sample.hpp>
#include <rt/portable.hpp>
#include <rt/running_shares.hpp>
#include <rt/sine_cosine.hpp>
#include <rt/sky_table.hpp>
#include <rt/todo.hpp>
#include <rt/tone_curve.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Exercise 14.3. The pixel of a picture of the whole sky that is seen in a direction of length 1.
// Rows are bands of equal angle from straight up, (0, 1, 0), to straight down; columns are slices
// of equal angle. The middle of the picture is seen along -z, and its right half along +x. Its left
// and right edges meet at +z.
// Star: the pixel is in the picture, however the angles are rounded, and at the poles, too.
inline SkyPixel sky_pixel(const Image& picture, Vec3 direction) {
    return rt::todo("14.3", picture, direction);
}

// Exercise 14.3. The solid angle, in steradians, of each pixel in a row: the share of a turn, 2 pi
// / width, times the difference of the heights of the row's edges.
// Star: accurate to 20 epsilon near the poles, too, in a picture of many rows.
inline Real sky_solid_angle(const Image& picture, int row) {
    return rt::todo("14.3", picture, row);
}

// Exercise 14.3. The shares by which pixels are drawn, from running_shares: each row by the light
// that comes from all of it, and in each row, each pixel by the light that comes from it. The light
// of a pixel is its luminance times its solid angle. Colors are 0 or more.
// Star: a picture may be black, and one pixel may be a million times as bright as the others.
inline SkyTable make_sky_table(const Image& picture) {
    return rt::todo("14.3", picture);
}

// Exercise 14.3. The probability density, per solid angle, with which sample_sky takes a direction:
// the probability of its pixel, spread evenly over the pixel's solid angle.
inline Real sky_density(const SkyTable& table, Vec3 direction) {
    return rt::todo("14.3", table, direction);
}

// Exercise 14.3. A direction to the sky, with its density and an infinite distance: place.y chooses
// a row, and place.x a pixel in it. `rest` of each pick says where in the pixel, from left to right
// and, by shares of the height, from top to bottom. 0 <= x, y < 1.
// Star: none if the sky is black. The direction leads to the chosen pixel even if it is on its
// edge, and its length is accurate to 5 epsilon near the poles, too.
inline std::optional<LightSample> sample_sky(const SkyTable& table, Vec2 place) {
    return rt::todo("14.3", table, place);
}

}  // namespace rt
