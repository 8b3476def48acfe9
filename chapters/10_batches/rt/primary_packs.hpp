#pragma once
#include <cmath>
#include <rt/arrival.hpp>
#include <rt/cameras.hpp>
#include <rt/sine_cosine.hpp>
#include <utility>

namespace rt {

// The rays of a camera for packs of paths (given): primary_ray of 02.4 and lens_ray of 08.2.

// A sample point of the picture for each path of a pack: the pixel, and the offset within it.
struct PixelPack {
    Pack column{}, row{};
    PlacePack offset;
};

struct PrimaryRays {
    Vec3Pack origin, direction;
};

// pixel_to_viewport of 02.1.
inline PlacePack pixel_to_viewport(const Camera& camera, const PixelPack& pixel) {
    const Real width = static_cast<Real>(camera.width), height = static_cast<Real>(camera.height);
    const Pack right = (pixel.column - width / 2) + pixel.offset.x;
    const Pack down = (pixel.row - height / 2) + pixel.offset.y;
    return {right / width * camera.viewport.width, -down / height * camera.viewport.height};
}

// random(i) is the generator of path i.
template <class RandomOf>
PrimaryRays primary_rays(const Camera& camera, const PixelPack& pixel, const RandomOf&,
                         std::size_t size) {
    const PlacePack p = pixel_to_viewport(camera, pixel);
    const auto [u, v, w] = camera.basis;
    const Vec3Pack toward = to_world(pack_of(u), pack_of(v), pack_of(w), {p.x, p.y, pack_of(-1)});
    return {pack_of(camera.eye), normalize(toward, first_bits(size))};
}

template <class RandomOf>
PrimaryRays primary_rays(const LensCamera& with_lens, const PixelPack& pixel,
                         const RandomOf& random, std::size_t size) {
    if (!(with_lens.lens.aperture > 0)) return primary_rays(with_lens.camera, pixel, random, size);
    const PlacePack p = pixel_to_viewport(with_lens.camera, pixel),
                    place = random_places(size, random);
    const Pack radius = with_lens.lens.aperture / 2 * sqrt(place.x);
    const auto [sine, cosine] = sine_cosine_of_turn(place.y);
    const Pack right = radius * cosine, up = radius * sine;
    const Real focus = with_lens.lens.focus_distance;
    const Vec3Pack u = pack_of(with_lens.camera.basis.u), v = pack_of(with_lens.camera.basis.v),
                   w = pack_of(with_lens.camera.basis.w);
    const Vec3Pack toward = to_world(u, v, w, {p.x - right / focus, p.y - up / focus, pack_of(-1)});
    return {pack_of(with_lens.camera.eye) + right * u + up * v,
            normalize(toward, first_bits(size))};
}

}  // namespace rt
