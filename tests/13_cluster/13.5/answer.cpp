#include <answer.hpp>
#include <rt/turned_view.hpp>

namespace answer EXPORTED {

rt::View turned_view(const rt::View& view, int frame, int frames) {
    return rt::turned_view(view, frame, frames);
}

}  // namespace EXPORTED
