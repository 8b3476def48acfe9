#include <answer.hpp>
#include <rt/ppm.hpp>

namespace answer EXPORTED {

void write_ppm(std::ostream& out, const rt::Image& image) {
    rt::write_ppm(out, image);
}

}  // namespace EXPORTED
