#include <companion/check/compiler_words.hpp>

#include "catch.hpp"

using companion::plain_words;

namespace {

bool says(const std::string& error, const std::string& part) {
    return plain_words("a.hpp:1:2: error: " + error).find(part) != std::string::npos;
}

}  // namespace

// What g++ 12 and clang++ 14 said of the same slips.
TEST_CASE("the usual errors of compilers are told in plain words", "[compiler_words]") {
    CHECK(says("expected '}' at end of input", "{ needs its own }"));
    CHECK(says("function definition is not allowed here", "{ needs its own }"));
    CHECK(says("expected ';' before 'return'", "semicolon"));
    CHECK(says("expected ';' after return statement", "semicolon"));
    CHECK(
        says("cannot convert 'const std::optional<double>' to 'const rt::Real' {aka 'const "
             "double'} in initialization",
             "`*name`"));
    CHECK(says("no viable conversion from 'const std::optional<Real>' to 'const rt::Real'",
               "`*name`"));
    CHECK(says("no match for 'operator*' (operand types are 'std::optional<double>' and 'double')",
               "`*name`"));
    CHECK(says("no match for call to '(rt::Vec3) (double)'", "no function"));
    CHECK(says("type 'rt::Vec3' does not provide a call operator", "no function"));
    CHECK(says("declaration of 'double t' shadows a parameter", "leave out the type"));
    CHECK(says("redefinition of 't'", "leave out the type"));
    CHECK(says("'Vec' does not name a type", "expects a type"));
    CHECK(says("unknown type name 'Vec'", "expects a type"));
    CHECK(says("'lenght' was not declared in this scope; did you mean 'length'?", "misspelled"));
    CHECK(says("use of undeclared identifier 'lenght'", "misspelled"));
    CHECK(says("use of deleted function 'std::unique_ptr<T>::unique_ptr(const T&)'", "std::move"));
    CHECK(says("assignment of read-only variable 'x'", "const"));
    CHECK(says("no match for 'operator+' (operand types are 'rt::Vec3' and 'int')", "two types"));
    CHECK(says("no return statement in function returning non-void [-Wreturn-type]", "return"));
    CHECK(plain_words("a.hpp:1:2: error: a thing that nobody has seen") == "");
}
