#include <companion/live/server.hpp>
#include <companion/model/stubs.hpp>

#include "catch.hpp"

using namespace companion;

TEST_CASE("what follows the secret in an address is a path and a query", "[live]") {
    const auto read = [](const std::string& target) { return read_target(target, "5ec"); };
    CHECK(read("/5ec/").request->path.empty());
    CHECK(read("/5ec/a/b.js#c").request->path == "a/b.js");
    const Asked asked = read("/5ec/a%20b?of=03.2&more=%26%3d&empty");
    CHECK(asked.request->path == "a b");
    CHECK(asked.request->query ==
          std::map<std::string, std::string>{{"of", "03.2"}, {"more", "&="}, {"empty", ""}});
    for (const char* const bad :
         {"", "*", "5ec/", "//", "//5ec/", "/5ec//a", "/%", "/5ec/%4", "/5ec/%g0", "/5ec/%00",
          "/5ec/a\\b", "/5ec/../a", "/5ec/%2e%2e/a", "/5ec/./a", "/../5ec/a", "/5ec/a?%",
          "/5ec/a\x7f", "http://x/5ec/"}) {
        INFO(bad);
        CHECK(read(bad).refused == 400);
    }
    for (const char* const other : {"/", "/a", "/5e/a", "/5ecc/a", "/5EC/a"}) {
        INFO(other);
        CHECK(read(other).refused == 403);
    }
    CHECK_FALSE(read("/5ec").request);  // relative links would begin one folder higher
}

TEST_CASE("a stub's contract for the core ends where its stars begin", "[live]") {
    CHECK(core_contract("#pragma once\n"
                        "#include <rt/a.hpp>\n"
                        "\n"
                        "namespace rt {\n"
                        "\n"
                        "// Exercise 01.1. All of them.\n"
                        "// In two lines.\n"
                        "// Star: once more,\n"
                        "// and more.\n"
                        "\n"
                        "// The sum.\n"
                        "inline int sum(int a,\n"
                        "               int b) {\n"
                        "    // Here.\n"
                        "    return rt::todo(\"01.1\", a, b);\n"
                        "}\n"
                        "\n"
                        "// One.\n"
                        "// Source: somewhere.\n"
                        "int one();\n"
                        "\n"
                        "}  // namespace rt\n") ==
          "Exercise 01.1. All of them.\nIn two lines.\n"
          "\nThe sum.\ninline int sum(int a,\n               int b)\n"
          "\nOne.\nint one()\n");
    CHECK(core_contract("").empty());
}
