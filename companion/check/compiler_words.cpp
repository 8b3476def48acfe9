#include <companion/check/compiler_words.hpp>
#include <regex>

namespace companion {
namespace {

struct Meaning {
    const char* error;  // of g++ or clang++, a regular expression
    const char* words;
};

// Habits from Python. The line of source decides here, so these are tried before the meanings
// below.
struct Habit {
    const char* error;  // as above; both this and the line shown below the error must match
    const char* line;   // a regular expression
    const char* words;
};

constexpr const char* several_results =
    "To give names to several results, write `const auto [x, y] = f();`.";

const Habit habits[]{
    {"", "^(\\s*\\d+ \\| )?[+-](?![+-])",
     "In a text, a `+` before a line marks it as new, and a `-` as one to delete: do not type "
     "them."},
    {"was not declared|undeclared|expected|cannot convert|could not convert|no viable|incompatible",
     "^[\\s\\d|]*(auto )?(\\(\\w+, \\w+\\)|\\[\\w+, \\w+\\]|\\w+, \\w+) = [\\w:.]+\\(",
     several_results},
    {"cannot convert|could not convert|no viable conversion|initializer|uninitialized const",
     "^[\\s\\d|]*(const )?(auto|Real|double|float|int) \\w+, \\w+ = [\\w:.]+\\(", several_results},
    {"", "\\b(lock_guard|scoped_lock|unique_lock)(<[\\w:]*>)?[({]",
     "The lock needs a name, as in `const std::lock_guard lock{mutex};`. Without a name, the mutex "
     "is free again before the next line."},
    {"discards qualifiers|would lose const|invalid constructor|copy constructor must",
     "\\b(\\w+)\\(\\1 ?&? ?\\w*\\)",
     "A copy constructor takes `const Canvas& other`, with the name of your class: a reference, "
     "because passing by value would already need a copy, and const, because the original is not "
     "changed."},
    {"unary .\\*|indirection requires|no match for .operator\\*.*operand type is",
     "\\w\\)? ?\\*\\* ?[\\w(]",
     "C++ has no `**` for powers: multiply, x * x, or call std::pow(x, n)."},
    {"expected", "[\\w)] //+ ?[\\w(]+[;)]",
     "`//` begins a comment. Write `/` to divide; between two values of type int, it drops the "
     "fraction."},
    {"expected|was not declared|undeclared", "\\S+ if .+ else ",
     "A choice between two values is written `condition ? a : b`."},
    {"'(count|words)' was not declared|undeclared identifier '(count|words)'", "words\\[|count ==",
     "main gets the words of the command line: `int main(int count, char** words) {`."},
    {"elif", "", "C++ has no `elif`: write `else if (...)`."},
    {"expected|was not declared|undeclared", "\\bfor \\(?\\w+ in ",
     "C++ counts with `for (int i = 0; i < n; ++i) { ... }`, and goes through a list with "
     "`for (const Color& c : colors) { ... }`."},
    {".(begin|end). was not declared|invalid range expression", "\\bfor \\(.*:",
     "`for (... : list)` goes through a list. To count, write "
     "`for (int i = 0; i < n; ++i)`."},
    {"expected .;.", "\\bfor \\([^;]*,",
     "In `for (int i = 0; i < n; ++i)`, semicolons separate the parts."},
    {"expected|lambda", "return \\[[^\\]]*[,.]",
     "C++ lists values in braces: `return {a, b, c};`."},
    {"expected .;.|expected .,. or .;.", "(=|return) [^=]*[\\w)\\]] [A-Za-z][^=]*;$",
     "Is an operator such as `*` missing between two names, or a semicolon?"},
    {"no match for .operator\\[\\]|does not provide a subscript operator", "",
     "A Vec3 is not a list: its components are a.x, a.y and a.z."},
    {"expected", "\\w\\[[^\\[\\]?:]*:[^\\[\\]:]*\\]",
     "C++ has no slices. For a span, `order.first(k)` are its first k elements, and "
     "`order.subspan(k)` are the rest."},
    {"no matching function", "std::sort\\([\\w.]+, *\\[",
     "std::sort needs a begin and an end: `std::sort(list.begin(), list.end(), ...)`."},
    {"discards qualifiers|no viable overloaded .=", "\\*__",
     "The elements of this list are const, so they cannot be sorted or changed."},
    {"no match for .operator<|invalid operands", "__b < __a|__a < __b",
     "std::min and std::max cannot compare these values: call them for each component."},
    {"no matching function", "get_if<\\w+>\\([^&]",
     "std::get_if needs an address, with &: `std::get_if<Metal>(&material)`."},
    {"discards qualifiers|no viable overloaded .=|read-only|const-qualified|cannot assign",
     "\\bif \\([^=!<>]+ = [^=]", "`=` assigns to the left side; write `==` to compare."},
    {"expected .\\(.|expected", "^[^?/]*\\b(if|while|for|else)\\b[^;?]*:\\s*$",
     "Write the condition in parentheses and the statements in braces: `if (x > 0) { ... }`."},
    {"\\W(None|True|False|self|len|print|def|pass)\\W", "",
     "This is Python. C++ has true and false, `{}` for no value, values.size() for a length, and "
     "std::cout << x to print."},
    {"expected|undeclared|was not declared", "\\b(if|while) \\(?[\\w.]+ is (not )?\\w",
     "C++ has no `is`: `if (!name)` asks whether a std::optional is empty, and `==` compares "
     "values."},
    {"invalid operands", "[\\w)] ?\\^ ?[\\w(]",
     "`^` does not compute powers in C++: multiply, x * x, or call std::pow(x, n)."},
    // Several characters in single quotes. Before them may come literals of one character, but no
    // other single quote: apostrophes within words and in comments are not quotes.
    {"conver|initialize|constant",
     "^([^'/]|/(?!/)|'([^'\\\\]|\\\\.)')*[^'\\w]'([^'\\\\]|\\\\.){2,}'",
     "Write text in double quotes, \"P3\\n\"; single quotes hold one character, 'x'."},
    {"invalid use of void expression|argument type .void. is incomplete|no matching",
     "emplace_back\\(\\w+\\(",
     "This calls the function at once. Give the thread a function that it can call itself: "
     "`[&work, worker] { work(worker); }`."},
    {"of non-class type|is not a structure or union", "\\.(fetch_add|load|store)\\(",
     "A plain number has no such member: declare it as `std::atomic<int>`."},
    {"", "\\.push_back\\( ?\\[",
     "emplace_back makes the thread itself and needs only the function: "
     "`threads.emplace_back([...] { ... });`."},
    {"has no member|no member named", "\\.append\\(", "A vector appends with `push_back(value)`."},
    {"optional", "return -?[\\d.]+;",
     "The function returns a std::optional. For no value, write `return {};`."},
    {"optional", "return nullptr",
     "To return no value, write `return {};` or `return std::nullopt;`. A null pointer is not an "
     "empty std::optional."},
    {"(float|double).*(may change value|changes value|turns floating-point)|implicit conversion.*"
     "(float|double).* to .*int",
     "(^|[^:\\w])abs\\(",
     "`abs` without std:: is for whole numbers and drops the fraction: write `std::abs(x)` for the "
     "absolute value of a Real."},
    {"could not convert|no viable conversion|cannot convert|no matching function for call to .abs",
     "(^|[^:\\w])abs\\(",
     "For numbers, write `std::abs`; plain `abs` may be a different function."},
    {"'(max|min)' was not declared|undeclared identifier .(max|min)\\b|"
     "no arguments to .(max|min). that depend",
     "", "Write std:: in front: `std::max(a, b)`, or `std::max({a, b, c})` for three values."},
    {"was not declared|undeclared", "^[\\s\\d|]*\\w+ = ",
     "If the name is new, the line needs its type, such as `const Real x = ...;`. If the variable "
     "exists already, is its name misspelled, or is it declared in another block?"},
    {"result unused|has no effect|value computed", "^[\\s\\d|]*[\\w.]+ == [^;]*;",
     "`==` compares; to set a value, write `=`."},
    {"expected unqualified-id$", "^[\\s\\d|]*\\{", "Is there a `;` too many before this brace?"},
    {"operand of comma|expression result unused|to itself", "^[\\s\\d|]*[\\w.]+, [\\w.]+ = ",
     "C++ assigns one value at a time. To swap two, write `std::swap(a, b);`."},
    {"'math' was not declared|undeclared identifier 'math'", "",
     "C++ has no `math.`: write std:: in front of its functions, as in `std::sqrt(x)`, and `pi`."},
    {"cannot convert|could not convert|no viable conversion|no matching",
     "\\w\\(\\([^(){}]+, [^(){}]+\\)\\)",
     "A comma does not make a list in C++. Write braces: `f({x, y, z})`."},
    {"left.* operand of comma|expression result unused|no viable conversion|could not "
     "convert|cannot convert",
     "return \\(?[^(){}]+, [^(){}]+\\)?;",
     "A comma does not make a pair in C++, and only the last value counts. Write braces: `return "
     "{a, "
     "b};`."},
    {"deduced conflicting|no matching function",
     "std::(max|min)\\(-?[\\d.]+,|std::(max|min)\\(.*, -?[\\d.]+\\)",
     "Both values must have the same type: `Real(0)` instead of 0."},
    {"(max|min)\\((double|float|int|const double&), (double|float|int), (double|float|int)\\)|"
     "no matching function|called object type|deduced",
     "std::(max|min)\\([^{},()]+,[^{},()]+,[^{},()]+\\)",
     "std::min and std::max take two values, or more than two in braces: `std::max({a, b, c})`."},
};

// The first match counts, so special meanings come before general ones.
const Meaning meanings[]{
    {"out of memory|signal terminated program|unable to execute command",
     "The compiler took too much time or memory and was stopped. Does a file include itself, or "
     "does the code make the compiler compute something without end?"},
    {"operator\\^|operand of .\\^|exponentiation",
     "`^` does not compute powers in C++: multiply, x * x, or call std::pow(x, n)."},
    {"character constant|unclosed|missing terminating",
     "Write text in double quotes, \"P3\\n\"; single quotes hold one character, 'x'."},
    {"comparisons like .X<=Y<=Z|chained comparison",
     "C++ cannot chain comparisons: write `a < b && b < c`."},
    {"(constant|expression) .*(with|of) (boolean expression|type .bool.)",
     "One side is itself a comparison, so it is true or false, not a number. C++ cannot chain "
     "comparisons: write "
     "`a < b && b < c`."},
    {"comparison in operand of .[&|]|[&|].? has lower precedence than",
     "`&` and `|` combine bits, and always compute both sides. Write `&&` for *and*, `||` for "
     "*or*."},
    {"\\(\\(void\\)0,",
     "A comma does not make a pair in C++, and only the last value counts. Write braces: `return "
     "{a, b};`."},
    {"shift count >= width",
     "The number has too few bits for this shift. Make it 64 bits wide before you shift it: "
     "`static_cast<std::uint64_t>(y)`."},
    {"around .\\+. inside .<<|.<<. has lower precedence",
     "`+` comes before `<<`: put the shift in parentheses."},
    {"empty body",
     "A semicolon after `if (...)` or `for (...)` ends the statement there, and what follows is "
     "always executed. Delete it."},
    {"disambiguated as a function declaration",
     "Empty parentheses declare a function here. To make a variable, write braces with its "
     "values: `Name name{value};`."},
    {"unnecessary parentheses in declaration|disambiguated as redundant parentheses",
     "This declares a variable with the name in the parentheses. If that should be its value, give "
     "the variable a name: `Name name{value};`."},
    {"wrong number of template arguments|too (few|many) template arguments",
     "This name takes a different number of types in `<...>`: compare with its declaration."},
    {"std::thread arguments must be invocable",
     "A thread calls its function without arguments, so the lambda has no parameters: "
     "`[&work, worker] { work(worker); }`."},
    {"comparison in operand of .==",
     "`==` compares; to set a value, write `=`. Three values are compared by "
     "`a == b && b == c`."},
    {"operand of comma",
     "A comma between values drops the first one. To swap two values, write `std::swap(a, b);`; to "
     "return two, write `return {a, b};`."},
    {"infinite recursion|all paths through this function will call itself",
     "The function calls itself in every case, so it never ends. There must be a case in which it "
     "returns without calling itself."},
    {"non-static member function must|invalid use of (non-static )?member function|"
     "from type .*::\\)\\(|invalid operands of types .<unresolved overloaded",
     "A function is called with parentheses, even without arguments: `image.width()`."},
    {"forbids declaration of .* with no type|requires a type specifier",
     "The type of the result stands before the function's name, as in `Color gradient(...)`."},
    {"no arguments to .* that depend on a template parameter",
     "No function of this name is known here. Declare it first, or #include its header; a function "
     "of the standard library needs std:: in front."},
    {"clause does not guard|misleading indentation",
     "Indentation does not count in C++. A `;` right after the parentheses ends the `if` or the "
     "loop: delete it. Otherwise, put braces around all statements that belong to the `if` or the "
     "loop."},
    {"unsigned expression.*>= 0.* is always true",
     "An unsigned number, such as a std::size_t, is never negative, so this never becomes false."},
    {"different signedness|integers of different signs",
     "An unsigned number, such as a size, is compared with an int: convert it, as in "
     "`static_cast<int>(list.size())`."},
    {"not a constant expression",
     "This value must be known when the code is compiled, and it is not."},
    {"prevents copy elision", "Write `return name;`: a local value is moved without std::move."},
    {"is not captured|cannot be implicitly captured",
     "A lambda may use only the variables that its brackets list: `[x]` gives it a copy of x, "
     "`[&x]` x itself, and `[&]` every variable itself."},
    {"ambiguous",
     "More than one function fits. If one of them is yours and another is the course's, delete "
     "yours."},
    {"expected unqualified-id before .\\{.", "Is there a `;` too many before this brace?"},
    {"for increment expression has no effect",
     "The last part of the loop's head changes nothing: `i + 1` only computes a value; `i++` and "
     "`i += 2` change i."},
    {"invalid preprocessing directive", "A comment begins with `//`."},
    {"expected .\\(. (before|after)",
     "In C++, write `if (x > 0) { ... }`, with parentheses and braces and without a colon."},
    {"assignment used as truth value|using the result of an assignment as a condition|"
     "could not convert .* = .* to .bool.|"
     "(Vec3|Color). is not contextually convertible to .bool.",
     "`=` assigns to the left side; write `==` to compare."},
    {"statement has no effect|value computed is not used|expression result unused|"
     "ignoring return(ed)? value|unused result|comparison result unused",
     "The result is computed and thrown away. Store it, as in `x = ...` or `x *= ...`, or return "
     "it."},
    {"(float|double).*(may change value|changes (the )?value|turns floating-point)|implicit "
     "conversion.*"
     "(float|double).* to .*int",
     "A number is converted to a type that cannot hold all of its digits. If you want that, "
     "convert it yourself: `int(x)` drops the fraction, and `Real(x)` makes a Real."},
    {"promotion|increases floating-point precision|implicit conversion from .*float.* to .double.",
     "If Real is float, this is computed in double. Give both numbers the type Real: `Real(5)` "
     "instead of 5."},
    {"expected .;. after (struct|class)|expected initializer before",
     "A semicolon is missing: after a struct, write `};`, and end the statement before this line "
     "with `;`."},
    {"Color.*has no member named .[xyz]|no member named .[xyz]. in .*Color",
     "A Color has the members r, g and b."},
    {"(optional).*(has no member)|no member named.*in .*optional",
     "This is a std::optional, which may be empty: test `if (name)` first, and then write "
     "`name->member`."},
    {"unique_ptr.*has no member named|no member named .* in .*unique_ptr",
     "This is a unique_ptr: write `name->member` for a member of what it points to."},
    {"operand of .->. has non-pointer type|member reference type .* is not a pointer",
     "This is not a pointer: write `name.member`."},
    {"of non-class type|is not a structure or union",
     "The value before the dot has no members: should it have another type than a plain number, or "
     "are parentheses missing where it is made?"},
    {"unary .\\*|indirection requires pointer",
     "Only a pointer or a std::optional has a value behind it: without the `*`, this is the "
     "value."},
    {"never closed|expected .\\}. at end of input|extraneous closing brace|"
     "expected declaration before .\\}. token|function definition is not allowed here|"
     "a function-definition is not allowed here",
     "The braces do not match: each { needs its own }. Count them from here upward."},
    {"expected .;.|expected .,. or .;.",
     "A semicolon is missing at the end of this line or of the line before. Or is it after a "
     "//, which begins a comment?"},
    {"incompatible vector types in conditional|vector operands to the vector conditional|"
     "inferred scalar type|vector condition type",
     "Both values in `mask ? a : b` must be packs of the same type. `pack_of(x)` holds x in every "
     "lane, and `PackMask{} + n` the integer n. For vectors there is `pick(mask, a, b)`."},
    {"(__vector|vector of).* to .bool|type .bool. with .*vector of",
     "Comparing packs gives a mask, which is true or false in each lane, but this place needs a "
     "single true or false. `max(a, b)` and `min(a, b)`, without std::, choose lane by lane, and "
     "so does `mask ? a : b`. `bits_of(mask) != 0` asks whether it is true in any lane."},
    {"call to .(sqrt|abs|min|max|copysign|fma)\\(.*rt::Pack",
     "The std:: functions take single numbers. The functions for packs have the same names, "
     "without std:: in front."},
    {"no matching function for call to .(max|min)\\b",
     "std::max and std::min need two values of the same type: write `Real(0)` instead of `0.0`."},
    {"(convert|conversion|initialize|assigning to).*(rt::Pack(Mask)?\\b|__vector|vector of)",
     "One side is a pack and the other is not, or the two packs are of different kinds. In a "
     "function that takes packs and single numbers, write `auto` instead of `Real`. `pack_of(x)` "
     "holds x in every lane, and `PackMask{} + n` the integer n; `p[i]` is the number in lane i."},
    {"invalid operands.*(__vector|vector of)",
     "A mask and a pack of numbers cannot be combined. `&` and `|` combine two masks, and "
     "`mask ? a : b` chooses between two packs."},
    {"result type must be constructible|construct_at",
     "This would copy a value that cannot be copied, such as a unique_ptr: start "
     "with an empty vector, and call `push_back(std::move(value))`."},
    {"push_back.*unique_ptr",
     "The vector holds plain pointers: `.get()` gives the plain pointer that a unique_ptr holds."},
    {"brace-enclosed.*optional|no matching constructor for initialization of .*optional",
     "Braces alone cannot make the value of a std::optional: write the type of the value before "
     "them, such as `return Roots{one, other};`."},
    {"optional.*(no match for .operator|invalid operands|cannot convert|no viable conversion|"
     "could not convert|to non-scalar type)|(no match|invalid operands|cannot convert|"
     "no viable conversion|could not convert|invalid initialization of reference|no known "
     "conversion).*optional",
     "One of the two values is a std::optional, which may be empty. Test it with `if (name)`; "
     "`*name` is "
     "the value in it."},
    {"__comp. cannot be used",
     "Does this call std::min or std::max? They take two values, or more in braces: "
     "`std::max({a, b, c})`."},
    {"explicit qualification in declaration|extra qualification",
     "Within `namespace rt { ... }`, the name is written without rt::."},
    {"no match for call to .*<lambda|call to object of type .\\(lambda",
     "The lambda is called with other arguments than it takes. For std::sort, it takes two "
     "elements, and returns whether the first comes before the second."},
    {"function<.*from .*<lambda|from .*(<lambda|\\(lambda at).*function<",
     "The parameters of the lambda are not those that this place passes to it: compare them with "
     "the declaration."},
    {"no match for call to .*std::function",
     "This function takes other arguments: compare their number and types with its declaration."},
    {"no match for call to|does not provide a call operator|cannot be used as a function",
     "The name before the ( is a value, not a function. Is an operator missing, or does a variable "
     "have the same name as the function?"},
    {"shadows|redeclaration of|redefinition of|conflicting declaration",
     "A variable of this name already exists, and this line declares a second one. To change the "
     "first variable, leave out the type: `name = value;`."},
    {"does not name a type|unknown type name|no type named|a type specifier is required",
     "The compiler expects a type here and does not know this word. Is it misspelled, does it need "
     "rt:: or std:: or an #include, or is this a statement outside every function?"},
    {"was not declared in this scope|undeclared identifier|is not a member of|no member named .* "
     "in "
     "namespace|has not been declared",
     "This name is not known here. Is it misspelled, declared in another block or further down, or "
     "does it need std:: or an #include?"},
    {"rt::\\w+. has no member named .(along|cross|dot|join|length|longest_axis|normalize)\\b|"
     "no member named .(along|cross|dot|join|length|longest_axis|normalize). in .rt::",
     "This is a function of its own: `join(a, b)`, and not `a.join(b)`."},
    {"swap\\(const ",
     "`swap` changes both variables, but they are const: leave out const where they are declared."},
    {"Met\\w*Child.*has no member named .is_leaf|no member named .is_leaf. in .*Met\\w*Child",
     "`find_nearest` is called with a child instead of its node: write `child.node()` in the "
     "call."},
    {"has no member named|no member named",
     "This type has no member of this name: its header shows the members that it has."},
    {"of pointer type|is a pointer; did you mean to use",
     "This is a pointer: write `name->member`, or `(*name).member`."},
    {"use of deleted function|call to deleted|implicitly-deleted",
     "A value of this type, such as a unique_ptr, cannot be copied: move it with std::move, or use "
     "a reference."},
    {"as .this. argument discards qualifiers|not marked const",
     "This value is const, so only member functions with const after their parentheses can be "
     "called: `int width() const { ... }`."},
    {"discards qualifiers|would lose const|drops .const",
     "This value is const, so it cannot be changed here. If you only read it, take it as "
     "`const Color&`, with its own type."},
    {"read-only|const-qualified|cannot assign to variable",
     "This value is const, so it cannot be changed here: change a copy of it."},
    {"no match for .operator|invalid operands",
     "There is no such operator for these two types. Check the type of each side."},
    {"no matching function.*unique_ptr",
     "One of the arguments is a unique_ptr: `*name` gives what it points to."},
    {"too few arguments|too many arguments|no matching (member )?function|no matching constructor",
     "No function of this name takes these arguments: compare their number and types with its "
     "declaration."},
    {"(conversion|convert).*Vec2.* to .*Vec3",
     "This is a Vec2, which has x and y and no z: declare a Vec2."},
    {"(convert|conversion).* to .*unique_ptr",
     "A unique_ptr is needed here: `std::make_unique<...>()` makes one."},
    {"cannot convert|could not convert|no viable conversion|cannot initialize|invalid conversion|"
     "invalid initialization of reference|to non-scalar type",
     "The value has a different type from the one that is needed here."},
    {"narrowing|cannot be narrowed",
     "Within braces, no conversion is allowed to lose digits: convert the value yourself, as in "
     "Real(n) or "
     "static_cast<int>(x)."},
    {"return-statement with no value|should return a value",
     "`return;` ends a function without a result, but this one has one. For no value of a "
     "std::optional, write `return {};`."},
    {"no return statement|non-void function|control reaches end",
     "The function can reach its end without a return statement; it then returns garbage or "
     "crashes."},
    {"stray .*in program|unexpected character|non-ASCII",
     "C++ does not allow this character here. Is it a typographic quote or minus sign, copied from "
     "a text?"},
    {"uninitialized",
     "The variable is used here before it has a value: give it one where you declare it."},
    {"unused variable|unused parameter|set but not used",
     "This variable is never used: did you use another one instead?"},
    {"undefined reference|Undefined symbol",
     "The function is declared and called, but not defined anywhere with exactly these "
     "parameters."},
    {"multiple definition",
     "The function is defined in two files: if it is defined in a header, write `inline` before "
     "it."},
    {"expected primary-expression before .\\{|initializer list cannot be used on",
     "Here the braces need a type before them, such as `Vec3{}` or `Pack{}`."},
    {"expected primary-expression|expected expression|expected unqualified-id|expected .\\).",
     "Something is missing or extra just before this position: an operator, a value or a bracket."},
};

}  // namespace

std::string plain_words(const std::string& error) {
    // What to do is known: see first_error().
    if (error.find("\n  add #include <") != std::string::npos ||
        error.find("\n  write `") != std::string::npos)
        return "";
    // With some language settings, compilers use other quotes.
    const std::string first_line =
        std::regex_replace(error.substr(0, error.find('\n')), std::regex{"\u2018|\u2019"}, "'");
    // The line of source, without its number: both compilers show it below the message.
    std::string line;
    if (const auto end = error.find('\n'); end != std::string::npos)
        line = error.substr(end + 1, error.find('\n', end + 1) - end - 1);
    for (const Habit& habit : habits)
        if (std::regex_search(first_line, std::regex{habit.error}) &&
            (!*habit.line || std::regex_search(line, std::regex{habit.line})))
            return habit.words;
    for (const Meaning& meaning : meanings)
        if (std::regex_search(first_line, std::regex{meaning.error})) return meaning.words;
    return "";
}

}  // namespace companion
