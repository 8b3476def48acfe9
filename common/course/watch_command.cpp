#include <app/errors.hpp>
#include <course/commands.hpp>

namespace course {

int watch(const Course&, const Arguments&) {
    throw app::Failure("watch is still to be made");
}

}  // namespace course
