#include <companion/check/dropped_fraction.hpp>
#include <companion/model/course.hpp>
#include <companion/system/files.hpp>

#include "catch.hpp"

using namespace companion;

namespace {

// The quotient of which the words speak.
std::string found(const std::string& line) {
    const std::string said = dropped_fraction("int row, width;\nint height = 180;\n" + line + '\n');
    if (said.empty()) return "";
    CHECK(said.rfind("3: `", 0) == 0);
    return said.substr(4, said.find('`', 4) - 4);
}

}  // namespace

TEST_CASE("a quotient of whole numbers that drops its fraction is found", "[dropped_fraction]") {
    CHECK(found("double x = column + 1/2;") == "1 / 2");
    CHECK(found("return 1 / 2 * (n.x + 1);") == "1 / 2");
    CHECK(found("f(a, (4 / 3) * pi)") == "4 / 3");
    CHECK(found("double up = 1 - 2 * row / height;") == "2 * row / height");
    CHECK(found("const Real up = 1 - 2 * (row / height);") == "row / height");
    for (const char* const line :
         {"double x = 1.0 / 2;", "double x = 1 / 2.0;", "double x = 1 / 2.;", "x = 4 / 2;",
          "x = y * 1 / 2;", "x = f(1) / 2;", "x = a[1] / 2;", "// 1 / 2", "\"1 / 2\"",
          "double up = 1 - 2 * (row + 0.5) / height;", "double up = 0.5 * row / height;",
          "double up = 1.0 * row / height;", "double x = row / camera.width;",
          "double x = row / width();", "Real x = Real(row % width), y = Real(row / width);",
          "int middle = row / height;", "double x = radius / height;"})
        CHECK(found(line) == "");
}

TEST_CASE("no answer of ours drops a fraction that is wanted", "[dropped_fraction]") {
    const Course course = this_course();
    int files = 0;
    for (const char* const folder : {"solutions", "tests/plain"})
        for (const fs::path& file : source_files(course.root / folder)) {
            INFO(file);
            CHECK(dropped_fraction(read_file(file)) == "");
            ++files;
        }
    CHECK(files > 100);
}
