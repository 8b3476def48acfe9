#pragma once
// Measures what accuracy costs: rows with an error and a cost, printed as a table for the terminal
// and written as CSV for plots.

#include <cstdio>
#include <iosfwd>
#include <string>
#include <study/timing.hpp>
#include <vector>

namespace study {

// One measurement. The names say what the numbers mean and give their units:
// "distance / radius", "largest error / ulp", "time / ns".
struct Row {
    std::string study;         // which question the row helps to answer
    std::string variant = {};  // which way of computing was measured
    double x = 0;
    std::string x_name;
    double error = 0;
    std::string error_name = {};  // empty where the error was not measured
    double cost = 0;
    std::string cost_name = {};  // empty where nothing was timed
};

// The measurements of one run of a chapter's program, all in the precision it was built with.
class Report {
  public:
    explicit Report(std::string chapter);

    void add(Row row) { rows_.push_back(std::move(row)); }

    // Adds a row whose cost is the time of `work` in nanoseconds, divided by `parts`. The time is
    // measured only when time_in_turns() is called.
    void add(Row row, Work work, double parts);
    // Times the work of all rows that are still untimed, in turns.
    void time_in_turns(const Turns& turns = {.rounds = 21, .at_least_ms = 0.5});

    // The rows. This function, the table and the file throw std::logic_error if rows are still
    // untimed.
    const std::vector<Row>& rows() const;

    // The name of the report's file, CHAPTER.csv, and its contents: these rows, and the rows that
    // an earlier file has for the other precision. So running the double program and then the float
    // program gives one file with both.
    std::string file() const { return chapter_ + ".csv"; }
    std::string csv(std::istream& earlier) const;

    void print_table(std::FILE* out) const;

  private:
    struct Waiting {
        std::size_t row;
        Work work;
        double parts;
    };

    std::string chapter_;
    std::vector<Row> rows_;
    std::vector<Waiting> waiting_;
};

// "float" or "double": what rt::Real is in this program.
std::string precision();

}  // namespace study
