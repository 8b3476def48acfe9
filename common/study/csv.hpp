#pragma once
// Tables as comma-separated values, as RFC 4180 defines them.

#include <istream>
#include <string>
#include <vector>

namespace study {

// A field in the form in which it is written to a file: in quotes if it holds commas, quotes or
// line breaks.
std::string csv_field(const std::string& text);

// The fields of all lines, including the heading. A field in quotes may hold anything.
std::vector<std::vector<std::string>> read_csv(std::istream& in);

}  // namespace study
