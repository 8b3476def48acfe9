#pragma once
#include <rt/directions.hpp>
#include <rt/lens_ray.hpp>
#include <rt/mirror_and_motion.hpp>
#include <rt/render_pixel.hpp>

namespace rt {

// A camera with a lens (given). If the aperture is 0, no random point on the lens is drawn.
struct LensCamera {
    Camera camera;
    Lens lens;
};

template <class Random>
Ray make_ray(const LensCamera& with_lens, int column, int row, Vec2 offset, Random& random) {
    if (!(with_lens.lens.aperture > 0)) return primary_ray(with_lens.camera, column, row, offset);
    return lens_ray(with_lens.camera, with_lens.lens, column, row, offset, random_place(random));
}

// A camera, with or without a lens, whose shutter is open for a while (given). If nothing moves, no
// random time is drawn.
template <class StillCamera>
struct ShutterCamera {
    StillCamera camera;
    bool anything_moves = true;
};

template <class StillCamera, class Random>
TimedRay make_ray(const ShutterCamera<StillCamera>& with_shutter, int column, int row, Vec2 offset,
                  Random& random) {
    const Ray ray = make_ray(with_shutter.camera, column, row, offset, random);
    return {ray.origin, ray.direction, with_shutter.anything_moves ? random.uniform() : Real(0)};
}

}  // namespace rt
