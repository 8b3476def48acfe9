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

// All rows of a table that a chapter's program wrote with --study. Throws app::Failure if the
// file is not such a table.
std::vector<Measurement> read_measurements(const std::filesystem::path& table);

// The rows of each study of a table, in the order in which the studies first appear.
std::vector<std::vector<Measurement>> by_study(const std::vector<Measurement>& rows);

// A study's name as a part of a file's name: "Far spheres" is "far-spheres".
std::string slug(const std::string& study);

}  // namespace companion
