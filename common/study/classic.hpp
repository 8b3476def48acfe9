#pragma once
// The baseline of the studies: a ray tracer as introductions write it, in our words. Everything
// that can be hit is an object of its own on the heap behind a shared pointer, and is asked through
// a virtual function; so are materials. The tree is made of the same objects. Numbers are double,
// whatever rt::Real is; chance is std::rand. It is compiled with the same flags as all else.

#include <memory>
#include <rt/image.hpp>
#include <study/cover.hpp>

namespace study::classic {

class Hittable;

std::shared_ptr<const Hittable> make_world(const study::Cover& cover);

// The mean color of the cover picture, as study::mean_color has it.
rt::Color mean_color(const study::Cover& cover, const Hittable& world);

// The whole picture. The random numbers go on where the last picture's ended.
rt::Image picture(const study::Cover& cover, const Hittable& world);

}  // namespace study::classic
