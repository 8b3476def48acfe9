#pragma once
// The baseline of the studies: a ray tracer as introductory texts write it, in our own code.
// Everything that can be hit is an object of its own on the heap, held by a shared pointer and
// called through a virtual function; so are materials. The tree is made of the same kind of
// objects. Numbers are double, whatever rt::Real is; random numbers come from std::rand. It is
// compiled with the same flags as everything else.

#include <memory>
#include <rt/image.hpp>
#include <study/cover.hpp>

namespace study::classic {

class Hittable;

std::shared_ptr<const Hittable> make_world(const study::Cover& cover);

// The mean color of the cover picture, as study::mean_color computes it.
rt::Color mean_color(const study::Cover& cover, const Hittable& world);

// The whole picture. The random numbers continue where the last picture's ended.
rt::Image picture(const study::Cover& cover, const Hittable& world);

}  // namespace study::classic
