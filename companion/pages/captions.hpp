#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace companion {

// What a plot says in words, and which quantities it shows.
struct Caption {
    // What the measurements show, as a sentence. Empty if nobody has looked at them: then the plot
    // has the study's name for a title.
    std::string claim = {};
    // "cost" if the error tells nothing, "error over cost" if x does not matter. Empty: see
    // plot_svg.
    std::string shows = {};
    // The names of quantities as a person would say them, by their names in the tables.
    std::map<std::string, std::string> axes = {};
};

// The captions of all studies.
struct Captions {
    std::map<std::string, std::string> axes = {};
    std::map<std::string, std::map<std::string, Caption>> studies = {};  // by table and study

    // The caption of a study. Without its claim if the measurements are not those of docs/studies.
    Caption of(const std::filesystem::path& table, const std::string& study) const;

    bool with_claims = true;
};

// Reads docs/studies/captions.json. Throws app::UsageError if it is not as its first line says.
Captions read_captions(const std::filesystem::path& file);

// The name of a quantity in words: as the caption says it; otherwise "time / ns" is "time, in ns".
std::string in_words(const Caption& caption, const std::string& name);

}  // namespace companion
