#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/commands/commands.hpp>
#include <companion/commands/compared_picture.hpp>
#include <companion/compare/comparison_sheet.hpp>
#include <companion/compare/program_pictures.hpp>
#include <cstdio>
#include <rt/image_file.hpp>

namespace companion {

int compare(const Course& course, const Given& given) try {
    const Chapter chapter = find_chapter(course, *given.named);
    const ComparedPicture picture = compare_picture(course, chapter, given.has("--mine"));
    auto words = picture.found.words();
    // If the answer is right, say only where it differs: "too dark" would call it wrong.
    if (!picture.excused.empty()) {
        words = picture.excused;
        if (const std::string regions = picture.found.regions(); !regions.empty())
            words.push_back("Where: " + regions + '.');
    }
    std::printf("%s\n", picture.yours.words().c_str());
    if (!picture.yours.replaced.empty())
        std::printf("With your code as it is: ./course compare %s --mine\n",
                    chapter.number().c_str());
    std::printf("%s: %s\n", chapter.name.c_str(), words[0].c_str());
    for (std::size_t i = 1; i < words.size(); ++i) std::printf("  %s\n", words[i].c_str());
    app::make_folder(course.out());
    const fs::path path = course.out() / (chapter.name + "_compare.png");
    app::replace_file(path, rt::encode_png(comparison_sheet(picture.found)));
    std::printf("Both pictures and their difference are in %s\n", course.relative(path).c_str());
    return picture.is_right() ? app::done : app::could_not;
} catch (const DrawingFailed& failed) {
    std::fprintf(stderr, "course: %s\n", failed.what());
    const bool to_write = !failed.result.signal && failed.result.exit_code == app::still_to_write;
    return to_write ? app::still_to_write : app::could_not;
}

}  // namespace companion
