#include <companion/follow/record.hpp>
#include <companion/system/files.hpp>
#include <companion/system/scratch_folder.hpp>

namespace companion {

Recorded record(const Followed& followed, Run run) {
    const ScratchFolder scratch{"course-trail"};
    const std::filesystem::path file = scratch.path() / "trail.txt";
    run.command.insert(run.command.begin(),
                       {"env",
                        "COURSE_FOLLOW=" + std::to_string(followed.column) + ' ' +
                            std::to_string(followed.row) + ' ' + std::to_string(followed.sample),
                        "COURSE_TRAIL=" + file.string()});
    const Result result = run_process(run);
    return {std::filesystem::exists(file) ? read_trail(read_file(file)) : Trail{}, result};
}

}  // namespace companion
