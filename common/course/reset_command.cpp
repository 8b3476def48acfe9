#include <app/errors.hpp>
#include <course/commands.hpp>

namespace course {

int reset(const Course&, const Arguments&) {
    throw app::Failure("reset is still to be made");
}

}  // namespace course
