#pragma once
#include <rt/view.hpp>

namespace answer {

rt::View turned_view(const rt::View& view, int frame, int frames);

}  // namespace answer

namespace rt {

using answer::turned_view;

}  // namespace rt
