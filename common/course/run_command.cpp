#include <app/errors.hpp>
#include <course/commands.hpp>

namespace course {

int run(const Course&, const Arguments&) {
    throw app::Failure("run is still to be made");
}

}  // namespace course
