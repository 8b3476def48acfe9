#pragma once
#include <rt/sine_cosine.hpp>
#include <rt/sky_picture.hpp>
#include <utility>

namespace rt {

// A sky from a picture (given), turned around the vertical, and with its light multiplied.
class PictureSky {
  public:
    // The picture must outlive the sky. A turn of a quarter, 0.25, takes what is ahead, at -z, to
    // the left, to -x: counterclockwise, seen from above. 0 <= turn < 1, and 0 <= scale.
    PictureSky(const Image& picture, Real turn, Real scale)
        : table_{make_sky_table(picture)}, turn_{sine_cosine_of_turn(turn)}, scale_{scale} {}

    // The light from a direction.
    Color operator()(Vec3 direction) const {
        const SkyPixel pixel = sky_pixel(*table_.picture, in_picture(direction));
        return scale_ * table_.picture->at(pixel.column, pixel.row);
    }

    // The probability density, per solid angle, with which sample() takes a direction.
    Real density(Vec3 direction) const { return sky_density(table_, in_picture(direction)); }

    // A direction to the sky; none if the sky is black.
    std::optional<LightSample> sample(Vec2 place) const {
        std::optional<LightSample> sample = sample_sky(table_, place);
        if (sample) sample->direction = in_world(sample->direction);
        return sample;
    }

  private:
    Vec3 in_world(Vec3 v) const {
        return {turn_.cosine * v.x + turn_.sine * v.z, v.y, turn_.cosine * v.z - turn_.sine * v.x};
    }
    Vec3 in_picture(Vec3 v) const {
        return {turn_.cosine * v.x - turn_.sine * v.z, v.y, turn_.cosine * v.z + turn_.sine * v.x};
    }

    SkyTable table_;
    SineCosine<Real> turn_;
    Real scale_;
};

}  // namespace rt
