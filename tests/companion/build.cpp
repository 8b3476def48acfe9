#include <companion/build/diagnostics.hpp>
#include <companion/build/remake.hpp>
#include <companion/check/compiler_words.hpp>
#include <companion/system/files.hpp>

#include "catch.hpp"
#include "temporary_folder.hpp"

using namespace companion;
using checkpoint::TemporaryFolder, checkpoint::write_file;

namespace {

const Course here{"/c", "/c/build"};
const std::vector<fs::path> mine{"exercises/01_x/rt/a.hpp"};

}  // namespace

TEST_CASE("the first error is that of a compiler, with its source", "[build]") {
    CHECK(first_error(here, "[1/2] Building\nall is well\n").empty());
    CHECK(first_error(here,
                      "FAILED: x\n/c/tests/t.cpp:3:5: error: no\n    3 | source\n      | ^\n") ==
          "tests/t.cpp:3:5: error: no\n    3 | source\n      | ^");
    CHECK(first_error(here, "../tests/t.cpp:3:5: fatal error: no\n") ==
          "tests/t.cpp:3:5: fatal error: no");
    CHECK(first_error(here, "t.cpp:(.text+0x1): undefined reference to `f'\n") ==
          "the linker says: undefined reference to `f'");
    CHECK(first_error(here, "Undefined symbols for architecture arm64:\n") ==
          "the linker says: Undefined symbols for architecture arm64:");
    // The compiler's last line says only that the linker failed.
    CHECK(
        first_error(here,
                    "t.cpp:(.text+0x1): undefined reference to `f'\ncollect2: error: ld returned 1 "
                    "exit status\n") == "the linker says: undefined reference to `f'");
    const std::string killed = "g++: fatal error: Killed signal terminated program cc1plus";
    CHECK(first_error(here, killed + '\n') == killed);
    const std::string full = "cc1plus: out of memory allocating 2147483664 bytes";
    CHECK(first_error(here, full + '\n') == full);
}

TEST_CASE("an error in the learner's file goes before others", "[build]") {
    const std::string elsewhere = "/usr/include/v.h:9:1: error: elsewhere\n    9 | v\n";
    const std::string there = "/c/exercises/01_x/rt/a.hpp:3:5: error: mine\n    3 | a\n";
    CHECK(first_error(here, elsewhere + there) ==
          "/usr/include/v.h:9:1: error: elsewhere\n    9 | v");
    CHECK(first_error(here, elsewhere + there, mine) ==
          "exercises/01_x/rt/a.hpp:3:5: error: mine\n    3 | a");
    // Otherwise an error that comes from code in there.
    const std::string from = "/c/exercises/01_x/rt/a.hpp:7:2:   required from here\n";
    CHECK(first_error(here, "/c/t.hpp:1:1: error: other\n" + from + elsewhere, mine) ==
          "/usr/include/v.h:9:1: error: elsewhere\n    9 | v\n"
          "  which came from exercises/01_x/rt/a.hpp:7");
    // clang++ tells in notes how it came there.
    CHECK(first_error(here,
                      "In file included from /c/exercises/01_x/rt/a.hpp:1:\n" + elsewhere +
                          "/usr/include/w.h:3:2: note: in instantiation of function 'g<C>'\n  g\n"
                          "/c/exercises/01_x/rt/a.hpp:7:2: note: in instantiation of function "
                          "'sort<C>' requested here\n  std::sort(c);\n",
                      mine) ==
          "/usr/include/v.h:9:1: error: elsewhere\n    9 | v\n"
          "  which came from exercises/01_x/rt/a.hpp:7");
    // Source and files in which a header is included may have the same words.
    CHECK(
        first_error(here,
                    "In file included from /c/tests/t.cpp:1,\n                 from /c/u.cpp:2:\n" +
                        there.substr(0, there.find('\n')) +
                        "\n    3 | int a; // far from /c/exercises/01_x/rt/a.hpp:9: error: b\n",
                    mine) ==
        "exercises/01_x/rt/a.hpp:3:5: error: mine\n"
        "    3 | int a; // far from exercises/01_x/rt/a.hpp:9: error: b");
    // A brace that is never closed: what follows makes no sense, and the last note says so.
    CHECK(first_error(here,
                      elsewhere + "/c/tests/t.cpp:99:1: error: expected '}' at end of input\n" +
                          "/c/exercises/01_x/rt/a.hpp:4:14: note: to match this '{'\n",
                      mine) ==
          "exercises/01_x/rt/a.hpp:4:14: error: the brace { here is never closed");
}

TEST_CASE("a copy constructor that takes no const is named, and not what calls it", "[build]") {
    const std::string mine_at = "/c/exercises/01_x/rt/a.hpp:31:20", source = "   31 |  C(C& other)";
    // g++
    CHECK(
        first_error(here,
                    "/c/tests/answer.cpp:32:26: error: binding reference of type 'C&' to 'const C' "
                    "discards qualifiers\n   32 |  return C{other};\n      | ^\n" +
                        mine_at + ": note:   initializing argument 1 of 'C(C&)'\n" + source + '\n',
                    mine) ==
        "exercises/01_x/rt/a.hpp:31:20: error: binding reference of type 'C&' to 'const C' "
        "discards "
        "qualifiers\n" +
            source);
    // clang++
    CHECK(
        first_error(here,
                    "/c/tests/answer.cpp:32:26: error: no matching constructor for 'C'\n    return "
                    "C{other};\n    ^\n" +
                        mine_at +
                        ": note: candidate constructor not viable: 1st argument ('const C') would "
                        "lose const qualifier\n" +
                        source + '\n',
                    mine) ==
        "exercises/01_x/rt/a.hpp:31:20: error: candidate constructor not viable: 1st argument "
        "('const C') would lose const qualifier\n" +
            source);
    // Another error with a note is left as it is.
    CHECK(first_error(here,
                      "/c/tests/answer.cpp:3:2: error: cannot convert 'C' to 'int'\n" + mine_at +
                          ": note:   initializing argument 1 of 'f(int)'\n" + source + '\n',
                      mine) == "tests/answer.cpp:3:2: error: cannot convert 'C' to 'int'");
}

TEST_CASE("a struct that lacks its semicolon is named by the line of its brace", "[build]") {
    const TemporaryFolder folder;
    const Course course{folder.path(), folder.path() / "build"};
    const auto told = [&](const std::string& text, int line) {
        write_file(folder.path() / "exercises/01_x/rt/a.hpp", text);
        return first_error(
            course,
            (folder.path() / "exercises/01_x/rt/a.hpp").generic_string() + ':' +
                std::to_string(line) +
                ":5: error: expected initializer before 'operator'\n    8 | Vec op\n",
            mine);
    };
    const std::string words = "the } in line 3 ends a struct: write }; there";
    const auto has_words = [&](const std::string& text) {
        return text.find(words) != std::string::npos;
    };
    CHECK(has_words(told("struct Vec {\n    double x{};\n}\n\n// {\nVec operator+(Vec a);\n", 6)));
    CHECK(has_words(told("struct Vec\n{\n}\nVec operator+(Vec a);\n", 4)));
    CHECK_FALSE(has_words(told("struct Vec {\n    double x;\n};\nVec operator+(Vec a);\n", 4)));
    CHECK_FALSE(has_words(told("int f() {\n    return 1;\n}\nVec operator+(Vec a);\n", 4)));
}

TEST_CASE("a loop that ends before its statements is told where its variable is used", "[build]") {
    const Course course = this_course();
    const std::string file = "exercises/01_x/rt/a.hpp";
    const auto told = [&](const std::string& warning, const std::string& loop,
                          const std::string& name) {
        return first_error(course,
                           file + ":22:5: warning: " + warning + "\n   22 |     " + loop +
                               "\n      |     ^~~\n" + file + ":24:16: error: '" + name +
                               "' was not declared in this scope\n   24 |  sum += i;\n",
                           {file})
                   .find("the `for` in line 22 ends before") != std::string::npos;
    };
    const std::string gcc = "this 'for' clause does not guard... [-Wmisleading-indentation]";
    CHECK(told(gcc, "for (int i = 0; i < n; ++i);", "i"));
    CHECK(told(gcc, "for (const auto& i : all)", "i"));
    CHECK(told("for loop has empty body [-Wempty-body]", "for (int i = 0; i < n; ++i);", "i"));
    CHECK_FALSE(told(gcc, "for (int i = 0; i < n; ++i);", "length"));
    CHECK_FALSE(told("unused variable 'i'", "for (int i = 0; i < n; ++i);", "i"));
}

TEST_CASE("the missing include of a name that is not known is told", "[build]") {
    const Course course = this_course();
    const fs::path file = "solutions/03_sphere/rt/hit_sphere.hpp";
    const auto told = [&](const std::string& what, const std::string& line,
                          const std::string& notes = {}) {
        const std::string error = first_error(
            course, file.string() + ":3:5: error: " + what + "\n    3 | " + line + '\n' + notes,
            {file});
        const auto at = error.find("\n  ", error.find("3 | "));
        CHECK(plain_words(error).empty() == (at != std::string::npos));
        return at == std::string::npos ? "" : error.substr(at + 3);
    };
    const std::string length = "add #include <rt/length.hpp>, which declares length";
    const std::string call = "return length(a);";
    CHECK(told("'length' was not declared in this scope; did you mean 'tenth'?", call) == length);
    CHECK(told("use of undeclared identifier 'length'", call) == length);
    CHECK(told("there are no arguments to 'length' that depend on a template parameter", call) ==
          length);
    CHECK(told("no member named 'length' in namespace 'rt'", call) == length);
    CHECK(told("'Camera' does not name a type", "Camera camera;") ==
          "add #include <rt/camera.hpp>, which declares Camera");
    // A variable, and a function that is in another namespace.
    CHECK(told("'length' was not declared in this scope", "length = 2;").empty());
    CHECK(told("'nearest' was not declared in this scope", "nearest(x);").empty());
    CHECK(told("'tan' was not declared in this scope", "tan(x);").empty());
    // It is not in a header, in a later chapter's, in the file itself, or in one that is included.
    for (const char* const name : {"lenght", "refract", "hit_sphere", "dot"}) {
        INFO(name);
        CHECK(told("'" + std::string{name} + "' was not declared in this scope",
                   std::string{name} + "(a);")
                  .empty());
    }
    // The standard library's is meant, and not that of <rt/pack.hpp>.
    const fs::path later = "solutions/07_bvh/rt/hit_box.hpp";
    CHECK(first_error(course,
                      later.string() + ":3:5: error: 'max' was not declared\n    3 | max(a, b)\n",
                      {later})
              .find("add #include") == std::string::npos);
    CHECK(told("'vector' is not a member of 'std'", "std::vector<int> v;",
               "a.hpp:1:1: note: 'std::vector' is defined in header '<vector>'; this is\n") ==
          "add #include <vector>, which declares std::vector");
}

TEST_CASE("a formula's name is told to be a member of a parameter", "[build]") {
    const Course course = this_course();
    const auto told = [&](const std::string& file, const std::string& name,
                          const std::string& line) {
        return first_error(
            course,
            file + ":3:5: error: '" + name +
                "' was not declared in this scope; did you mean 'wcwidth'?\n    3 | " + line + '\n',
            {file});
    };
    const std::string pixel = "solutions/02_camera/rt/pixel.hpp",
                      ppm = "solutions/03_sphere/rt/ppm.hpp", start = ":3:5: error: '";
    for (const std::string name : {"width", "height"}) {
        CHECK(told(pixel, name, "x / " + name + ';') ==
              pixel + start + name + "' was not declared in this scope\n    3 | x / " + name +
                  ";\n  write `camera." + name + '`');
        CHECK(told(ppm, name, "out << " + name + ';').find("\n  write `image." + name + "()`") !=
              std::string::npos);
    }
    // A variable without its type, a misspelled name, and a parameter of a constructor.
    for (const char* const name : {"width", "widht", "fill"})
        CHECK(told(ppm, name, std::string{name} + " = 3;").find("write `") == std::string::npos);
    CHECK(told(ppm, "fill", "x + fill;").find("write `") == std::string::npos);
}

TEST_CASE("a tracer that includes a header is told of its namespace", "[build]") {
    const TemporaryFolder root;
    const fs::path whole = this_course().root;
    for (const char* const file :
         {"course.json", "common/rt/vec3_type.hpp", "chapters/01_vectors/rt/vec3.hpp"})
        write_file(root / file, read_file(whole / file));
    write_file(root / "solutions/01_vectors/rt/dot.hpp", "#include <rt/vec3.hpp>\n");
    const auto told = [&](const std::string& text, const std::string& what) {
        const std::string file = "exercises/tracer/tracer.cpp";
        write_file(root.path() / file, text);
        const std::string error =
            first_error({root.path(), root.path() / "build"},
                        file + ":3:5: error: " + what + "\n    3 | it\n", {file});
        CHECK(plain_words(error).empty());
        return error.substr(error.find("it\n") + 5);
    };
    const std::string unknown = "'Vec3' does not name a type",
                      add = "add #include <rt/vec3_type.hpp>, which declares Vec3",
                      name = "write `using namespace rt;` below the #includes, or `rt::Vec3`";
    CHECK(told("int x;\n", unknown) == add);
    CHECK(told("#include <rt/vec3.hpp>\n", unknown) == name);
    CHECK(told("#include <rt/dot.hpp>\n", "unknown type name 'Vec3'; did you mean 'rt::Vec3'?") ==
          name);
    CHECK(told("#include <rt/real.hpp>\nusing namespace rt;\n", unknown) == add);
    CHECK(told("#include <rt/real.hpp>\n", "'Vec3' is not a member of 'rt'") == add);
}

TEST_CASE("of the warnings the one that explains a crash goes first", "[build]") {
    const std::string file = "/c/exercises/01_x/rt/a.hpp";
    const std::string unused = file + ":3:5: warning: unused variable 'x' [-Wunused-variable]\n";
    const std::string no_return = file + ":8:1: warning: no return statement [-Wreturn-type]\n";
    CHECK(first_warning(here, unused + no_return, mine) ==
          "exercises/01_x/rt/a.hpp:8: no return statement");
    CHECK(first_warning(here, unused, mine) == "exercises/01_x/rt/a.hpp:3: unused variable 'x'");
    CHECK(first_warning(here, "/c/tests/t.cpp:1:1: warning: what [-Wall]\n", mine).empty());
    CHECK(first_warning(here, "../exercises/01_x/rt/a.hpp:1:1: warning: what\n", mine) ==
          "exercises/01_x/rt/a.hpp:1: what");
}

TEST_CASE("a warning of a variable without a value leads to its declaration", "[build]") {
    const std::string used =
        "In function 'f',\n    inlined from 'void test()' at /c/tests/t.cpp:78:20:\n"
        "/c/tests/t.cpp:78:20: warning: 'sum' is used uninitialized [-Wuninitialized]\n";
    const std::string declared =
        "/c/exercises/01_x/rt/a.hpp: In function 'f':\n"
        "/c/exercises/01_x/rt/a.hpp:12:10: note: 'sum' was declared here\n";
    CHECK(first_warning(here, used + declared, mine) ==
          "exercises/01_x/rt/a.hpp:12: 'sum' is used uninitialized");
    const std::string other = "/c/tests/t.cpp:9:1: warning: unused [-Wunused]\n";
    CHECK(first_warning(here, other + declared, mine).empty());
    CHECK(first_warning(here, used + other + declared, mine).empty());
}

TEST_CASE("a fraction that is dropped and a color that is thrown away are warned of", "[build]") {
    const Course course = this_course();
    const TemporaryFolder folder;
    const fs::path file = folder / "rt/hit_sphere.hpp";
    const auto warning = [&](const std::string& line, const std::string& becomes) {
        std::string code =
            companion::read_file(course.root / "solutions/03_sphere/rt/hit_sphere.hpp");
        const auto at = code.find(line);
        REQUIRE(at != std::string::npos);
        write_file(file, "#include <rt/color.hpp>\n" + code.replace(at, line.size(), becomes));
        const BuildResult built =
            Remake{course, "yours.03.2"}(folder.path(), folder / "answer/libanswer.so");
        INFO(built.output);
        CHECK(built.ok);
        return plain_words(first_warning(course, built.output, {file}));
    };
    const std::string line = "    const Real c = dot(f, f) - r_squared;\n";
    CHECK(warning("const Real c =", "const int c =").find("fraction") != std::string::npos);
    for (const char* const product : {"Color{} * Color{};", "Real(2) * Color{};", "a * d;"})
        CHECK(warning(line, line + product + '\n').find("thrown away") != std::string::npos);
    CHECK(warning(line, line).empty());
}
