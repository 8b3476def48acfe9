#include <app/errors.hpp>
#include <companion/build/side_build.hpp>
#include <companion/system/process.hpp>
#include <fstream>

namespace companion {

std::string cached(const Course& course, const std::string& variable) {
    std::ifstream in{course.build / "CMakeCache.txt"};
    for (std::string line; std::getline(in, line);)
        if (line.rfind(variable + ':', 0) == 0) return line.substr(line.find('=') + 1);
    return {};
}

Course side_build(const Course& course, const std::string& name,
                  const std::vector<std::string>& arguments) {
    const Course side{course.root, course.build / name};
    std::vector<std::string> command{
        "cmake", "-S", course.root.string(), "-B", side.build.string(), "-DCOURSE_ALL_TESTS=OFF"};
    if (!fs::exists(side.build / "CMakeCache.txt")) {
        const std::string generator = cached(course, "CMAKE_GENERATOR");
        if (!generator.empty()) command.insert(command.end(), {"-G", generator});
        const std::string compiler = cached(course, "CMAKE_CXX_COMPILER");
        if (!compiler.empty()) command.push_back("-DCMAKE_CXX_COMPILER=" + compiler);
    }
    if (fs::exists(course.build / "_deps"))  // what was fetched is not fetched again
        command.push_back("-DFETCHCONTENT_BASE_DIR=" + (course.build / "_deps").generic_string());
    const std::string native = cached(course, "RT_NATIVE");
    if (!native.empty()) command.push_back("-DRT_NATIVE=" + native);
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Result result = run_process({.command = command});
    if (!result.ok())
        throw app::Failure("CMake could not configure " + side.build.string() + ": " +
                           result.output.substr(0, result.output.find('\n')));
    return side;
}

}  // namespace companion
