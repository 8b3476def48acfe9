#pragma once
#include <companion/model/course.hpp>
#include <companion/pages/captions.hpp>
#include <string>
#include <vector>

namespace companion {

// Whose code is measured: the solution's, into out/study, or the learner's, into out/study-mine.
enum class Whose { solution, mine };

// The programs that measure a chapter, in both precisions.
std::vector<std::string> study_programs(const Chapter& chapter, Whose whose);

// Runs the studies of a chapter in both precisions and writes NN_topic.csv. With show_tables, what
// the programs print is shown. Throws app::Failure if a program fails.
void measure(const Course& course, const Chapter& chapter, bool show_tables,
             Whose whose = Whose::solution);

// What docs/studies/captions.json says.
Captions captions_of(const Course& course);

// Draws the plots of a table into a folder.
void draw_plots(const fs::path& table, const fs::path& folder, const Captions& captions);

// Draws docs/plots, the plots in the texts, anew from the tables in docs/studies.
void draw_plots_of_texts(const Course& course);

// A plot, as a path from out/, the study that it shows, and what it says, in words.
struct Plot {
    std::string file, study, says;
};

// The plots of a chapter: those that were drawn here, in the order of its table; or those of
// docs/plots if the chapter was never measured here.
std::vector<Plot> plots(const Course& course, const Chapter& chapter);

// Where the tables and plots are.
fs::path study_folder(const Course& course, Whose whose = Whose::solution);

}  // namespace companion
