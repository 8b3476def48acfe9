#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/commands/commands.hpp>
#include <companion/model/exercise.hpp>
#include <companion/model/kept.hpp>
#include <companion/model/stubs.hpp>
#include <companion/system/files.hpp>
#include <cstdio>

namespace companion {
int reset(const Course& course, const Given& given) {
    const Exercise exercise = find_exercise(course, *given.named);
    std::vector<fs::path> changed;
    for (const fs::path& file : exercise.files)
        if (fs::exists(fs::symlink_status(course.root / file)) &&
            !why_no_file(course.root / file).empty())
            throw app::Failure(trouble_with_files(course, exercise));
    for (const fs::path& file : exercise.files) {
        if (shipped_stub(course, file).empty())
            throw app::Failure("the shipped stub of " + file.string() +
                               " is not known anymore; git checkout -- " + file.string() +
                               " restores what you last committed");
        if (!fs::exists(course.root / file) ||
            read_text(course.root / file) != shipped_stub(course, file))
            changed.push_back(file);
    }
    if (changed.empty()) {
        std::printf("%s is unchanged: it is as it was shipped.\n", exercise.id.c_str());
        return app::done;
    }
    fs::path folder;
    for (const fs::path& file : changed) {
        const fs::path path = course.root / file;
        if (fs::exists(path)) {
            if (folder.empty()) folder = new_kept_folder(course, exercise.id);
            fs::copy_file(path, folder / path.filename());
            std::printf("kept   %s\n", course.relative(folder / path.filename()).c_str());
        }
        fs::create_directories(path.parent_path());
        app::replace_file(path, shipped_stub(course, file));
        std::printf("reset  %s\n", file.string().c_str());
    }
    return app::done;
}

}  // namespace companion
