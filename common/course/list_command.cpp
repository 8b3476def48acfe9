#include <app/errors.hpp>
#include <course/commands.hpp>

namespace course {

int list(const Course&, const Arguments&) {
    throw app::Failure("list is still to be made");
}

}  // namespace course
