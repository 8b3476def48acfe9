// stub_tool CHAPTER...: keeps the stubs of these chapters as they are now, for ./course reset.

#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/model/stubs.hpp>
#include <cstdio>

int main(int argc, char** argv) {
    return app::run_or_explain("stub_tool", [&] {
        const companion::Course course = companion::this_course();
        for (int i = 1; i < argc; ++i) {
            const companion::Chapter chapter{argv[i]};
            app::replace_file(course.root / "companion/shipped_stubs" / (chapter.name + ".txt"),
                              companion::to_text(companion::present_stubs(course, chapter)));
            std::printf("%s: kept\n", argv[i]);
        }
        return app::done;
    });
}
