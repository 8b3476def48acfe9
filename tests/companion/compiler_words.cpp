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
    CHECK(plain_words("cc1plus: out of memory allocating 2147483664 bytes").find("without end") !=
          std::string::npos);
    CHECK(says("CPU time limit exceeded signal terminated program cc1plus", "too much time"));
    CHECK(says("expected '}' at end of input", "{ needs its own }"));
    CHECK(says("function definition is not allowed here", "{ needs its own }"));
    CHECK(says("invalid use of non-static member function 'int rt::Image::width() const'",
               "`image.width()`"));
    CHECK(says("reference to non-static member function must be called", "`image.width()`"));
    CHECK(
        says("invalid use of member function 'int rt::Image::width() const' (did you forget the "
             "'()' ?)",
             "`image.width()`"));
    CHECK(says("C++ requires a type specifier for all declarations", "The type of the result"));
    CHECK(says("use of undeclared identifier 'max'; did you mean 'fmax'?", "`std::max(a, b)`"));
    CHECK(
        says("there are no arguments to 'shade' that depend on a template parameter, so a "
             "declaration of 'shade' must be available [-fpermissive]",
             "Declare it first"));
    CHECK(says("suggest parentheses around comparison in operand of '==' [-Wparentheses]",
               "to set a value, write `=`"));
    CHECK(says("no matching function for call to 'max(float&, double)'", "`Real(0)`"));
    CHECK(says("conversion from 'rt::Vec2' to non-scalar type 'const rt::Vec3' requested",
               "declare a Vec2"));
    CHECK(says("no viable conversion from 'rt::Vec2' to 'const rt::Vec3'", "declare a Vec2"));
    CHECK(
        says("conversion from 'std::optional<rt::Vec3>' to non-scalar type 'const rt::Vec3' "
             "requested",
             "std::optional"));
    CHECK(says("conversion from 'rt::Rows' to non-scalar type 'rt::Tile' requested",
               "a different type"));
    CHECK(says("no matching function for call to 'min'", "`Real(0)`"));
    CHECK(says("no matching function for call to 'max(rt::Pack&, double)'", "without std::"));
    CHECK(says("binding reference of type 'rt::Color&' to 'const rt::Color' discards qualifiers",
               "`const Color&`"));
    CHECK(
        says("binding reference of type 'rt::Color' to value of type 'const rt::Color' drops "
             "'const' qualifier",
             "`const Color&`"));
    CHECK(says("passing 'const C' as 'this' argument discards qualifiers [-fpermissive]",
               "`int width() const { ... }`"));
    CHECK(
        says("'this' argument to member function 'set' has type 'const C', but function is not "
             "marked const",
             "`int width() const { ... }`"));
    // A warning comes without its line of source.
    CHECK(plain_words("a.hpp:1: left operand of comma operator has no effect").find("std::swap") !=
          std::string::npos);
    CHECK(says("ISO C++ forbids declaration of 'gradient' with no type [-fpermissive]",
               "The type of the result"));
    CHECK(
        says("there are no arguments to 'max' that depend on a template parameter, so a "
             "declaration of 'max' must be available",
             "`std::max(a, b)`"));
    CHECK(says("this 'if' clause does not guard... [-Werror=misleading-indentation]", "braces"));
    CHECK(says("misleading indentation; statement is not part of the previous 'if'", "braces"));
    CHECK(says("comparison of unsigned expression in '>= 0' is always true", "never negative"));
    CHECK(
        says("result of comparison of unsigned expression >= 0 is always true", "never negative"));
    CHECK(says("'min' was not declared in this scope", "`std::max(a, b)`"));
    CHECK(says("base operand of '->' has non-pointer type 'std::atomic<int>'",
               "write `name.member`"));
    CHECK(says("return-statement with no value, in function returning 'std::optional<double>'",
               "`return {};`"));
    CHECK(says("non-void function 'f' should return a value", "`return {};`"));
    CHECK(
        says("unnecessary parentheses in declaration of 'm' [-Wparentheses]", "Name name{value}"));
    CHECK(says("request for member 'fetch_add' in 'next', which is of non-class type 'int'",
               "a plain number"));
    CHECK(says("member reference base type 'int' is not a structure or union", "a plain number"));
    CHECK(says("left shift count >= width of type [-Wshift-count-overflow]", "64 bits wide"));
    CHECK(says("shift count >= width of type [-Wshift-count-overflow]", "64 bits wide"));
    CHECK(says("suggest parentheses around '+' inside '<<' [-Wparentheses]", "in parentheses"));
    CHECK(says("operator '<<' has lower precedence than '+'; '+' will be evaluated first",
               "in parentheses"));
    CHECK(
        says("invalid initialization of reference of type 'const rt::TileWork&' {aka 'const "
             "std::function<void(const rt::Tile&, int)>&'} from expression of type "
             "'main(int, char**)::<lambda(const rt::Tile&)>'",
             "parameters of the lambda"));
    CHECK(
        says("no viable conversion from '(lambda at a.cpp:41:42)' to 'const rt::TileWork' (aka "
             "'const function<void (const rt::Tile &, int)>')",
             "parameters of the lambda"));
    CHECK(says("'camera' is not captured", "`[&]`"));
    CHECK(says("'worker' is not captured", "a copy of x"));
    CHECK(
        says("invalid operands of types '<unresolved overloaded function type>' and 'const "
             "rt::Real' {aka 'const double'} to binary 'operator<'",
             "`image.width()`"));
    CHECK(
        says("suggest braces around empty body in an 'if' statement [-Wempty-body]", "Delete it"));
    CHECK(says("if statement has empty body [-Wempty-body]", "Delete it"));
    CHECK(says("suggest parentheses around comparison in operand of '&' [-Wparentheses]", "`&&`"));
    CHECK(says("& has lower precedence than >; > will be evaluated first [-Wparentheses]", "`&&`"));
    CHECK(
        says("no match for call to '(const rt::TileWork {aka const std::function<void(const "
             "rt::Tile&, int)>}) (<brace-enclosed initializer list>)'",
             "takes other arguments"));
    CHECK(says("wrong number of template arguments (3, should be 1)", "a different number"));
    CHECK(
        says("static assertion failed: std::thread arguments must be invocable after conversion "
             "to rvalues",
             "without arguments"));
    CHECK(says("empty parentheses were disambiguated as a function declaration [-Wvexing-parse]",
               "write braces"));
    CHECK(
        says("could not convert '((void)0, ((height * (worker + 1)) / workers))' from 'int' to "
             "'rt::Rows'",
             "`return {a, b};`"));
    CHECK(says("expected ')' before 'is'\n   29 |     if (beyond is None) return 1;",
               "`if (!name)`"));
    CHECK(
        says("assignment of member 'rt::Hit::front' in read-only object\n"
             "   34 |     if (hit.front = true) eta = 1 / index;",
             "write `==`"));
    CHECK(says("variable 'camera' cannot be implicitly captured in a lambda", "`[&]`"));
    CHECK(says("ambiguous overload for 'operator-' (operand types are 'rt::Vec3' and 'rt::Vec3')",
               "delete yours"));
    CHECK(says("use of overloaded operator '-' is ambiguous", "delete yours"));
    CHECK(says("expected unqualified-id before '{' token", "`;` too many"));
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
    CHECK(says("no match for call to '(rt::Vec3) (double)'", "not a function"));
    CHECK(says("type 'rt::Vec3' does not provide a call operator", "not a function"));
    CHECK(says("declaration of 'double t' shadows a parameter", "leave out the type"));
    CHECK(says("redefinition of 't'", "leave out the type"));
    CHECK(says("'Vec' does not name a type", "expects a type"));
    CHECK(says("unknown type name 'Vec'", "expects a type"));
    CHECK(says("'lenght' was not declared in this scope; did you mean 'length'?", "misspelled"));
    CHECK(says("use of undeclared identifier 'lenght'", "misspelled"));
    CHECK(says("use of deleted function 'std::unique_ptr<T>::unique_ptr(const T&)'", "std::move"));
    CHECK(says("assignment of read-only variable 'x'", "const"));
    CHECK(says("no match for 'operator+' (operand types are 'rt::Vec3' and 'int')", "two types"));
    CHECK(
        says("suggest parentheses around comparison in operand of '^' [-Wparentheses]", "powers"));
    CHECK(says("infinite recursion detected [-Winfinite-recursion]", "in every case"));
    CHECK(says("all paths through this function will call itself", "in every case"));
    CHECK(says("invalid preprocessing directive #edge", "`//`"));
    CHECK(says("expected '(' before 'd'", "without a colon"));
    CHECK(says("expected '(' after 'if'", "without a colon"));
    CHECK(says("could not convert '((* & right) = rt::Vec3())' from 'rt::Vec3' to 'bool'",
               "write `==` to compare"));
    CHECK(says("value of type 'rt::Vec3' is not contextually convertible to 'bool'",
               "write `==` to compare"));
    CHECK(says("for increment expression has no effect [-Wunused-value]", "i += 2"));
    CHECK(says("comparison of constant '3' with boolean expression is always true",
               "chain comparisons"));
    CHECK(says("result of comparison of constant 3 with expression of type 'bool' is always true",
               "chain comparisons"));
    CHECK(says("conversion from 'double' to 'int' may change value [-Wfloat-conversion]",
               "cannot hold all"));
    CHECK(says("conversion from 'double' to 'rt::Real' {aka 'float'} changes the value of '6.7e-1'",
               "`Real(x)`"));
    CHECK(says("no return statement in function returning non-void [-Wreturn-type]", "return"));
    CHECK(says("'class std::unique_ptr<rt::TreeNode>' has no member named 'box'", "unique_ptr: "));
    CHECK(says("'const struct rt::MetChild' has no member named 'is_leaf'", "child.node()"));
    CHECK(says("no member named 'is_leaf' in 'rt::MetChild'", "child.node()"));
    CHECK(says("no matching function for call to 'swap(const double&, const double&)'",
               "leave out const"));
    CHECK(says("no member named 'box' in 'std::unique_ptr<rt::TreeNode>'", "unique_ptr: "));
    CHECK(says("'haze' is not a constant expression", "when the code is compiled"));
    CHECK(says("'struct rt::Box' has no member named 'join'", "`join(a, b)`"));
    CHECK(says("no member named 'join' in 'rt::Box'", "`join(a, b)`"));
    CHECK(says("base operand of '->' has non-pointer type 'rt::TreeNode'", "`name.member`"));
    CHECK(says("member reference type 'TreeNode' is not a pointer; did you mean to use '.'?",
               "`name.member`"));
    CHECK(
        says("request for member 'box' in 'node->', which is of non-class type "
             "'std::unique_ptr<rt::TreeNode>()'",
             "parentheses missing"));
    CHECK(
        says("cannot convert 'rt::TreeNode::is_leaf' from type 'bool (rt::TreeNode::)() const' to "
             "type 'bool'",
             "parentheses"));
    CHECK(says("invalid type argument of unary '*' (have 'rt::Real' {aka 'double'})",
               "without the `*`"));
    CHECK(says("indirection requires pointer operand ('rt::Real' (aka 'double') invalid)",
               "without the `*`"));
    CHECK(
        says("no matching function for call to 'find_nearest(const "
             "std::unique_ptr<rt::TreeNode>&, rt::SearchOf<rt::SceneSphere>&)'",
             "`*name`"));
    CHECK(says("could not convert 'node' from 'rt::TreeNode' to 'std::unique_ptr<rt::TreeNode>'",
               "make_unique"));
    CHECK(
        says("comparison of integer expressions of different signedness: 'int' and 'long unsigned "
             "int' [-Wsign-compare]",
             "unsigned"));
    CHECK(says("comparison of integers of different signs: 'int' and 'size_type'", "unsigned"));
    CHECK(says("moving a local object in a return statement prevents copy elision", "return name"));
    CHECK(says("no match for call to '(rt::f()::<lambda(int)>) (int&, int&)'", "two elements"));
    CHECK(plain_words("a.hpp:1:2: error: a thing that nobody has seen") == "");
}

TEST_CASE("errors with packs are told in plain words", "[compiler_words]") {
    const std::string choices = "packs of the same type", one_answer = "a single true or false";
    CHECK(
        says("incompatible vector types in conditional expression: 'rt::PackMask' {aka "
             "'__vector(2) long int'}, 'rt::Pack' {aka '__vector(2) double'} and 'rt::PackMask' "
             "{aka '__vector(2) long int'}",
             choices));
    CHECK(
        says("vector operands to the vector conditional must be the same type ('rt::Pack' "
             "(vector of 2 'rt::Real' values) and 'rt::PackMask' (vector of 2 "
             "'rt::PackInteger' values))}",
             choices));
    CHECK(
        says("inferred scalar type 'rt::Vec3Pack' is not an integer or floating-point type of "
             "the same size as 'long int'",
             "pick("));
    CHECK(
        says("vector condition type 'rt::PackMask' (vector of 2 'rt::PackInteger' values) and "
             "result type '__attribute__((__vector_size__(2 * sizeof(int)))) int' (vector of 2 "
             "'int' values) do not have elements of the same size",
             choices));
    CHECK(says("could not convert 'm' from 'rt::PackMask' {aka '__vector(2) long int'} to 'bool'",
               one_answer));
    CHECK(
        says("value of type 'rt::PackMask' (vector of 2 'rt::PackInteger' values) is not "
             "contextually convertible to 'bool'",
             one_answer));
    CHECK(says("cannot convert '__vector(2) long int' to 'bool' in initialization", one_answer));
    CHECK(
        says("cannot initialize a variable of type 'bool' with an rvalue of type "
             "'__attribute__((__vector_size__(2 * sizeof(long long)))) long long' (vector of 2 "
             "'long long' values)",
             one_answer));
    CHECK(says("no matching function for call to 'sqrt(rt::Pack&)'", "without std::"));
    CHECK(says("cannot convert 'bool' to 'rt::PackMask' {aka '__vector(2) long int'} in return",
               "pack_of(x)"));
    CHECK(says("cannot convert 'int' to 'rt::Pack' {aka '__vector(2) double'} in initialization",
               "pack_of(x)"));
    CHECK(
        says("assigning to 'rt::Real' (aka 'double') from incompatible type 'rt::Pack' (vector "
             "of 2 'rt::Real' values)",
             "p[i]"));
    CHECK(
        says("conversion of scalar 'rt::PackInteger' {aka 'long int'} to vector 'rt::Pack' {aka "
             "'__vector(2) double'} involves truncation",
             "pack_of(x)"));
    CHECK(
        says("invalid operands to binary & (have 'rt::Pack' {aka '__vector(2) double'} and "
             "'rt::PackMask' {aka '__vector(2) long int'})",
             "two masks"));
    CHECK(
        says("invalid operands to binary expression ('rt::Pack' (vector of 2 'rt::Real' values) "
             "and 'rt::PackMask' (vector of 2 'rt::PackInteger' values))",
             "two masks"));
    CHECK(says("expected primary-expression before '{' token", "need a type"));
    CHECK(says("initializer list cannot be used on the right hand side of operator ':'",
               "need a type"));
}

// The line of source decides.
TEST_CASE("what people write who know Python is told in plain words", "[compiler_words]") {
    const auto says_of = [](const std::string& line, const std::string& error,
                            const std::string& part) {
        INFO(line);
        CHECK(
            plain_words("a.hpp:1:2: error: " + error + "\n    1 |     " + line + "\n").find(part) !=
            std::string::npos);
    };
    says_of("return x ** 2;", "invalid type argument of unary '*' (have 'int')", "powers");
    says_of("return x ** 2;", "indirection requires pointer operand ('int' invalid)", "powers");
    for (const char* const line :
         {"x, y = f(3);", "(x, y) = f();", "[x, y] = rt::f();", "auto (x, y) = f();"}) {
        says_of(line, "'x' was not declared in this scope", "`const auto [x, y] = f();`");
        says_of(line, "use of undeclared identifier 'x'", "`const auto [x, y] = f();`");
    }
    for (const char* const line : {"x, y = f(3);", "Real x, y = f();", "const auto x, y = f();"})
        says_of(line, "cannot convert 'Roots' to 'double' in initialization", "const auto [x, y]");
    says_of("const auto [x, y] = f();", "'f' was not declared in this scope", "not known here");
    says_of("Real x, y = f(2);", "'f' was not declared in this scope", "not known here");
    for (const char* const type : {"lock_guard(m);", "lock_guard<std::mutex>(m);"})
        says_of(std::string{"std::"} + type, "no matching function for call to 'lock_guard()'",
                "The lock needs a name");
    says_of("std::atomic<int> next; next.fetch_add(1);",
            "request for member 'fetch_add' in 'next', which is of non-class type 'int'",
            "std::atomic<int>");
    says_of("return x ^ 2;", "invalid operands of types 'double' and 'int' to binary 'operator^'",
            "powers");
    says_of("return x ^ 2;", "invalid operands to binary expression ('double' and 'int')",
            "powers");
    says_of("int b = a // 2;", "expected ';' at end of declaration", "comment");
    says_of("low, high = high, low;", "left operand of comma operator has no effect", "std::swap");
    says_of("box.low, box.high = box.high, box.low;",
            "left operand of comma operator has no effect", "std::swap");
    says_of("low, high = high, low;",
            "explicitly assigning value of variable of type 'rt::Real' (aka 'double') to itself",
            "std::swap");
    says_of("a == b;", "statement has no effect [-Wunused-value]", "write `=`");
    says_of("a == b;", "equality comparison result unused [-Wunused-comparison]", "write `=`");
    says_of("{ return x; }", "expected unqualified-id", "`;` too many");
    says_of("return std::max(0.0, x);", "no matching function for call to 'max(double, rt::Real)'",
            "same type");
    says_of("return b;", "expected ',' or ';' before 'return'", "comment");
    says_of("Real y = 1 / x if b else x;", "expected ',' or ';' before 'if'", "condition ? a : b");
    says_of("best = min(best, cost);", "'min' was not declared in this scope", "std:: in front");
    says_of("Real angle = 2 * math.pi;", "'math' was not declared in this scope", "`pi`");
    says_of("v = basis.to_world((x, y, 1));", "cannot convert 'int' to 'rt::Vec3'",
            "`f({x, y, z})`");
    says_of("build_node(order[:k], first);", "expected primary-expression before ':' token",
            "no slices");
    says_of("std::sort(order, [&](int a, int b) {", "no matching function for call to 'sort(...)'",
            "list.begin()");
    says_of("*__first = _GLIBCXX_MOVE(__val);",
            "passing 'const rt::Box' as 'this' argument discards qualifiers", "const");
    says_of("if (__b < __a)",
            "no match for 'operator<' (operand types are 'const rt::Vec3' and 'const rt::Vec3')",
            "each component");
    says_of("if (std::get_if<Metal>(material)) return;",
            "no matching function for call to 'get_if<rt::Metal>(...)'", "address");
    says_of("if (k = 0) {", "assignment of read-only variable 'k'", "write `==`");
    says_of("elif (x < 0) return 2;", "'elif' was not declared in this scope", "else if");
    says_of("if x > 0:", "expected '(' before 'x'", "braces");
    says_of("if (x > 0):", "expected primary-expression before ':' token", "braces");
    says_of("return None;", "use of undeclared identifier 'None'; did you mean 'clone'?", "Python");
    says_of("return length2(a);", "'length2' was not declared in this scope", "misspelled");
    says_of("return abs(h) < 1;",
            "conversion from 'rt::Real' {aka 'double'} to 'int' may change value", "std::abs(x)");
    says_of("return abs(h);", "could not convert 'h' from 'double' to 'rt::Vec3'", "std::abs");
    says_of("root = x * 2;", "'root' was not declared in this scope", "needs its type");
    says_of("return (x, x, x);", "could not convert '((void)0, x)' from 'double' to 'rt::Vec3'",
            "return {a, b}");
    says_of("return {x, x, y};", "could not convert 'y' from 'double' to 'rt::Vec3'",
            "different type");
    says_of("return std::max(0, x);", "no matching function for call to 'max(int, double&)'",
            "Real(0)");
    says_of("return std::max(a, b, c);", "no matching function for call to 'max'", "{a, b, c}");
    says_of("return r.low;", "'class std::optional<R>' has no member named 'low'", "name->member");
    says_of("return nullptr;", "could not convert 'nullptr' to 'std::optional<R>'", "return {};");
    says_of("threads.emplace_back(work(worker));", "invalid use of void expression",
            "calls the function");
    says_of("threads.append(t);", "'class std::vector<std::thread>' has no member named 'append'",
            "push_back");
    says_of("return c.x;", "'struct rt::Color' has no member named 'x'", "r, g and b");
    says_of("x * y;", "statement has no effect [-Wunused-value]", "thrown away");
    says_of("x * y;",
            "ignoring returned value of type 'rt::Color', declared with attribute 'nodiscard'",
            "thrown away");
    says_of("x * y;", "ignoring return value of function declared with 'nodiscard' attribute",
            "thrown away");
    says_of("return 0 < x < 1;",
            "comparisons like 'X<=Y<=Z' do not have their mathematical meaning", "cannot chain");
    says_of("if (x = 1)", "suggest parentheses around assignment used as truth value",
            "to compare");
    says_of("file << 'P3\\n';", "multi-character character constant [-Wmultichar]",
            "double quotes");
    says_of("const char* s = 'P3';", "invalid conversion from 'int' to 'const char*'",
            "double quotes");
    says_of("const char* s = 'P3' + '\\n';", "invalid conversion from 'int' to 'const char*'",
            "double quotes");
    says_of("const char* s = ' ' + 'P3';", "invalid conversion from 'int' to 'const char*'",
            "double quotes");
    says_of("char c = word + ' ' + 'x' + ' ';", "cannot convert 'std::string' to 'char'",
            "different type");
    says_of("Vec3 d = cross(a, b) * 2;  // a's and b's", "cannot convert 'double' to 'rt::Vec3'",
            "different type");
    says_of("return dot(a);  // not 'a' and 'b', but 'P3'", "could not convert 'a' to 'double'",
            "different type");
    says_of("out << c.x << '\\n' << c.y << '\\n';", "'struct rt::Color' has no member named 'x'",
            "r, g and b");
    says_of("out << 'a' << c.x << 'P3';", "'struct rt::Color' has no member named 'x'",
            "r, g and b");
    says_of("file << '\\n' + x;", "no match for 'operator+' (operand types are 'A' and 'B')",
            "two types");
    says_of("Canvas(Canvas& other)",
            "binding reference of type 'rt::Canvas<int>&' to 'const rt::Canvas<int>' discards "
            "qualifiers",
            "const Canvas&");
    says_of("Canvas(Canvas& other)",
            "candidate constructor not viable: 1st argument ('const rt::Canvas<int>') would lose "
            "const qualifier",
            "const Canvas&");
    says_of("Canvas(Canvas other)",
            "invalid constructor; you probably meant 'rt::Canvas<Pixel> (const "
            "rt::Canvas<Pixel>&)'",
            "const Canvas&");
    says_of("Canvas(Canvas other)", "copy constructor must pass its first argument by reference",
            "const Canvas&");
    says_of("width(canvas) = 2;", "passing 'const Canvas' as 'this' argument discards qualifiers",
            "is const");
    says_of("int operator+(S a, S b) {", "expected initializer before 'operator'",
            "after a struct");
    says_of("for (i in spheres) {", "'i' was not declared in this scope", "goes through a list");
    says_of("for row in range(2) {", "expected '(' before 'row'", "goes through a list");
    says_of("for (int row : tile) {", "'begin' was not declared in this scope", "To count");
    says_of("for (int row : tile) {", "invalid range expression of type 'const rt::Tile'",
            "To count");
    says_of("for (int i = 0, i < n, ++i) {", "expected ';' before '<' token", "semicolons");
    says_of("return [a.x + b.x, a.y];", "expected ',' before '.' token", "in braces");
    says_of("Real d = b * b - 4 * a c;", "expected ',' or ';' before 'c'", "operator");
    says_of("return a.x * b.x a.y;", "expected ';' before 'a'", "operator");
    says_of("int height = 180;", "expected ',' or ';' before 'int'", "A semicolon is missing");
    says_of("return {a[0] + b[0]};", "no match for 'operator[]' (operand types are 'A' and 'int')",
            "a.x, a.y and a.z");
    says_of("if (right = Vec3{}) return basis;",
            "passing 'const rt::Vec3' as 'this' argument discards qualifiers", "write `==`");
    says_of("if (d < 0) return -1;", "could not convert '-1' from 'int' to 'std::optional<Roots>'",
            "`return {};`");
    says_of("if (count == 4) eye = {};", "'count' was not declared in this scope", "char** words");
    says_of("if (__comp(__b, __a))", "'__comp' cannot be used as a function",
            "`std::max({a, b, c})`");
    says_of("Color rt::gradient() {",
            "explicit qualification in declaration of 'rt::Color rt::gradient()'", "without rt::");
    says_of("const Real x = (c + o) / w - 0.5;",
            "implicit conversion from 'rt::Real' {aka 'float'} to 'double' to match other operand",
            "in double");
}

TEST_CASE("the + and - of a diff are not code", "[compiler_words]") {
    const auto says_of = [](const std::string& line) {
        return plain_words("a.hpp:1:1: error: expected unqualified-id before '+' token\n" + line)
                   .find("do not type them") != std::string::npos;
    };
    for (const char* const line :
         {"    1 | +double f();", "+    double x = 1;", "  112 | -    use(c);"})
        CHECK(says_of(line));
    for (const char* const line : {"    1 |     + x;", "    1 |     -x;", "  112 | ++i;"})
        CHECK_FALSE(says_of(line));
}
