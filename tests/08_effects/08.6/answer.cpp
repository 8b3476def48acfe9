#include <answer.hpp>
#include <rt/choose_renderer.hpp>

namespace answer EXPORTED {

std::size_t narrowest(const rt::Effects& needed, std::span<const rt::Effects> renderers) {
    return rt::narrowest(needed, renderers);
}

}  // namespace EXPORTED
