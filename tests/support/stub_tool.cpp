// stub_tool CHAPTER...: keeps the stubs of these chapters as they are now, for ./course reset.

#include <app/errors.hpp>
#include <course/stubs.hpp>
#include <cstdio>
#include <rt/image_file.hpp>

int main(int argc, char** argv) {
    return app::run_or_explain("stub_tool", [&] {
        const course::Course course = course::this_course();
        for (int i = 1; i < argc; ++i) {
            const course::Chapter chapter{argv[i]};
            rt::replace_file(course.root / "common/course/stubs" / (chapter.name + ".txt"),
                             course::to_text(course::present_stubs(course, chapter)));
            std::printf("%s: kept\n", argv[i]);
        }
        return app::done;
    });
}
