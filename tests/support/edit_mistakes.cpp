// edit_mistakes FILE.md SOLUTION FOLDER: makes the mistakes of one exercise. The files of the
// folder SOLUTION that a mistake changes go to FOLDER/NAME/rt. A file that already has the right
// contents is left alone, so that nothing is compiled again for it.

#include <app/errors.hpp>
#include <companion/model/mistakes.hpp>
#include <companion/system/files.hpp>
#include <cstdio>
#include <fstream>

using namespace companion;

namespace {

void write_if_different(const fs::path& path, const std::string& text) {
    if (fs::exists(path) && read_file(path) == text) return;
    fs::create_directories(path.parent_path());
    std::ofstream out{path, std::ios::binary};
    if (!(out << text).flush()) throw app::Failure(path.string() + " cannot be written");
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 4) throw app::UsageError("usage: edit_mistakes FILE.md SOLUTION FOLDER");
    for (const Mistake& mistake : read_mistakes(argv[1]))
        for (const auto& [file, text] : edited_files(mistake, argv[2]))
            write_if_different(fs::path{argv[3]} / mistake.name / file, text);
    return app::done;
} catch (const std::exception& error) {
    // The message starts with file and line, as a compiler's does.
    std::fprintf(stderr, "%s\n", error.what());
    return app::could_not;
}
