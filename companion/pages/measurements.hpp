#pragma once
#include <filesystem>
#include <string>
#include <study/report.hpp>
#include <vector>

namespace companion {

// A row of a study's table, and the precision of the program that measured it.
struct Measurement : study::Row {
    std::string precision;
};
using Measurements = std::vector<Measurement>;

// All rows of a table that a chapter's program wrote with --study. Throws app::Failure if the file
// is not such a table.
Measurements read_measurements(const std::filesystem::path& table);

// The rows of each study of a table, in the order in which the studies first appear.
std::vector<Measurements> by_study(const Measurements& rows);

// A study's name in the form used in file names: "Far spheres" becomes "far-spheres".
std::string slug(const std::string& study);

}  // namespace companion
