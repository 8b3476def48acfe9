#include <companion/check/compiler_words.hpp>
#include <regex>

namespace companion {
namespace {

struct Meaning {
    const char* error;  // of g++ or clang++, a regular expression
    const char* words;
};

// The first that fits counts: the special ones come before the general ones.
const Meaning meanings[]{
    {"never closed|expected .\\}. at end of input|extraneous closing brace|"
     "expected declaration before .\\}. token|function definition is not allowed here|"
     "a function-definition is not allowed here",
     "The braces do not match: each { needs its own }. Count them from here upwards."},
    {"expected .;.|expected .,. or .;.",
     "A semicolon is missing, at the end of this line or of the one before."},
    {"incompatible vector types in conditional|vector operands to the vector conditional|"
     "inferred scalar type|vector condition type",
     "Both choices of `mask ? a : b` must be packs of the same type. `pack_of(x)` is x in all "
     "lanes, `PackMask{} + n` a whole number. For vectors there is `pick(mask, a, b)`."},
    {"(__vector|vector of).* to .bool|type .bool. with .*vector of",
     "A mask is true or false in each lane, but here one answer is needed. `bits_of(mask) != 0` "
     "asks whether it is true in any lane, and `mask ? a : b` chooses in each."},
    {"call to .(sqrt|abs|min|max|copysign|fma)\\(.*rt::Pack",
     "The functions of std:: take single numbers. Those for packs have the same names without "
     "std:: in front."},
    {"(convert|conversion|initialize|assigning to).*(rt::Pack(Mask)?\\b|__vector|vector of)",
     "One of them is a pack, and the other is not, or it is another kind of pack. `pack_of(x)` is "
     "x in all lanes, `PackMask{} + n` a whole number; `p[i]` is the number in lane i."},
    {"invalid operands.*(__vector|vector of)",
     "A mask and a pack of numbers do not go together. `&` and `|` join two masks, and "
     "`mask ? a : b` chooses between two packs."},
    {"result type must be constructible|construct_at",
     "Something that cannot be copied, such as a unique_ptr, would be copied here: leave the "
     "vector empty, and `push_back(std::move(it))`."},
    {"push_back.*unique_ptr",
     "The vector holds plain addresses: `.get()` gives that of what a unique_ptr owns."},
    {"brace-enclosed.*optional|no matching constructor for initialization of .*optional",
     "Braces alone do not become the value of a std::optional: write its type before them, such as "
     "`return Roots{one, other};`."},
    {"optional.*(no match for .operator|invalid operands|cannot convert|no viable conversion|"
     "could not convert)|(no match for .operator|invalid operands|cannot convert|"
     "no viable conversion|could not convert|invalid initialization of reference|no known "
     "conversion).*optional",
     "One of them is a std::optional, which may be empty. Test it with `if (name)`; `*name` is the "
     "value in it."},
    {"no match for call to|does not provide a call operator|cannot be used as a function",
     "What stands before the ( is a value, no function. Is an operator missing, or does a variable "
     "have the name of the function?"},
    {"shadows|redeclaration of|redefinition of|conflicting declaration",
     "There is a variable of this name already, and this line makes a second one. To change the "
     "first one, leave out the type: `name = value;`."},
    {"does not name a type|unknown type name|no type named|a type specifier is required",
     "The compiler expects a type here and does not know this word. Is it misspelled, does it need "
     "rt:: or std:: or an #include, or does a statement stand outside of every function?"},
    {"was not declared in this scope|undeclared identifier|is not a member of|no member named .* "
     "in "
     "namespace|has not been declared",
     "Nothing of this name is known here. Is it misspelled, declared in another block or further "
     "down, or does it need std:: or an #include?"},
    {"has no member named|no member named",
     "This type has no member of this name: look at its header for those that it has."},
    {"of pointer type|is a pointer; did you mean to use",
     "It is a pointer: `name->member`, or `(*name).member`."},
    {"use of deleted function|call to deleted|implicitly-deleted",
     "This type cannot be copied, such as a unique_ptr: move it with std::move, or take a "
     "reference."},
    {"read-only|const-qualified|cannot assign to variable|discards qualifiers|not marked const",
     "It is const: it cannot be changed here."},
    {"no match for .operator|invalid operands",
     "There is no such operator for these two types. Look at what type each side has."},
    {"too few arguments|too many arguments|no matching function|no matching constructor",
     "No function of this name takes these arguments: compare their number and types with its "
     "declaration."},
    {"cannot convert|could not convert|no viable conversion|cannot initialize|invalid conversion|"
     "invalid initialization of reference",
     "The value has another type than the one that is needed here."},
    {"narrowing|cannot be narrowed",
     "In braces a number may not lose digits: convert it, such as Real(n) or static_cast<int>(x)."},
    {"no return statement|non-void function|control reaches end",
     "The function can end without a return, and then it returns rubbish or crashes."},
    {"stray .*in program|unexpected character|non-ASCII",
     "This is no character of C++, such as a typographic quote or minus sign from a text."},
    {"uninitialized",
     "The variable has no value yet where it is used here: give it one where you declare it."},
    {"unused variable|unused parameter|set but not used",
     "It is never used: was another variable used in its place?"},
    {"undefined reference|Undefined symbol",
     "The function is declared and called, but nowhere defined with these very parameters."},
    {"multiple definition", "The function is defined in two files: in a header it needs `inline`."},
    {"expected primary-expression before .\\{|initializer list cannot be used on",
     "Braces need their type before them here, such as `Vec3{}` or `Pack{}`."},
    {"expected primary-expression|expected expression|expected unqualified-id|expected .\\).",
     "Something is missing or too much just before this place: an operator, a value, a bracket."},
};

}  // namespace

std::string plain_words(const std::string& error) {
    // In some languages of the system quotes are others than these.
    const std::string first_line =
        std::regex_replace(error.substr(0, error.find('\n')), std::regex{"\u2018|\u2019"}, "'");
    for (const Meaning& meaning : meanings)
        if (std::regex_search(first_line, std::regex{meaning.error})) return meaning.words;
    return "";
}

}  // namespace companion
