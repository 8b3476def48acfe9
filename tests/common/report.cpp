#include <app/run.hpp>
#include <sstream>
#include <study/csv.hpp>
#include <study/report.hpp>
#include <study/timing.hpp>

#include "checkpoint.hpp"
#include "temporary_folder.hpp"

using checkpoint::read_file;
using checkpoint::TemporaryFolder;
using checkpoint::write_file;

namespace {

const std::string heading = "study,variant,precision,x,x_name,error,error_name,cost,cost_name\n";
const std::string mine = study::precision(), other = mine == "float" ? "double" : "float";

study::Report one_row(double error) {
    study::Report report{"99_test"};
    report.add(
        {"far, \"very\" far", "a,b", 1e6, "distance / radius", error, "ulp", 2.5, "time / ns"});
    return report;
}

std::string table_of(const study::Report& report) {
    std::FILE* const file = std::tmpfile();
    REQUIRE(file);
    report.print_table(file);
    std::rewind(file);
    std::string text(4096, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), file));
    std::fclose(file);
    return text;
}

}  // namespace

TEST_CASE("a report names its columns and its precision", "[report]") {
    const TemporaryFolder folder;
    app::write_study(one_row(0.25), folder.path());
    CHECK(read_file(folder / "99_test.csv") ==
          heading + "\"far, \"\"very\"\" far\",\"a,b\"," + mine +
              ",1e+06,distance / radius,0.25,ulp,2.5,time / ns\n");
    CHECK(folder.count() == 1);
}

TEST_CASE("a report replaces its own rows and keeps those of the other precision", "[report]") {
    const TemporaryFolder folder;
    // A name that looks like a precision must not be taken for one.
    const std::string theirs = "s,\"," + mine + ",\"," + other + ",1,n,2,e,3,c\n";
    const std::string old = "s,\"," + other + ",\"," + mine + ",1,n,2,e,3,c\n";
    write_file(folder / "99_test.csv", heading + theirs + old);
    app::write_study(one_row(1), folder.path());
    app::write_study(one_row(2), folder.path());
    const std::string text = read_file(folder / "99_test.csv");
    std::istringstream in{text};
    const auto lines = study::read_csv(in);
    REQUIRE(lines.size() == 3);
    CHECK(text.find(theirs) == heading.size());
    CHECK(lines[2][5] == "2");
}

TEST_CASE("a report says when it cannot be written", "[report]") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(app::write_study(one_row(1), folder / "missing"), std::system_error);
}

TEST_CASE("a report prints a dash for an error that was not measured", "[report]") {
    study::Report report{"99_test"};
    report.add({"study", "way", 1, "x", 0.125, "", 2, "time / ns"});
    const std::string text = table_of(report);
    INFO(text);
    CHECK(text.find(" - ") != std::string::npos);
    CHECK(text.find("0.125") == std::string::npos);
}

TEST_CASE("a report times its rows in turns", "[report]") {
    study::Report report{"99_test"};
    std::string order;
    const auto burn = [](int steps) {
        for (int i = 0; i < steps; ++i) study::keep(i);
    };
    report.add(
        {.study = "s", .variant = "one", .x_name = "x", .cost_name = "time / ns"},
        [&] { order += '1', burn(1'000'000); }, 1);
    report.add({.study = "s", .variant = "not timed", .x_name = "x", .cost = 7});
    report.add(
        {.study = "s", .variant = "a tenth", .x_name = "x", .cost_name = "time / ns"},
        [&] { order += '2', burn(1'000'000); }, 10);
    CHECK_THROWS_AS(report.rows(), std::logic_error);
    report.time_in_turns({.rounds = 3});
    CHECK(order == "121212");
    const auto& rows = report.rows();
    REQUIRE(rows.size() == 3);
    CHECK(rows[1].cost == 7);
    // Equal work. The rest is the machine's noise.
    const double ratio = rows[0].cost / rows[2].cost;
    INFO(EXPECTED "about 10, " ACTUAL << ratio);
    CHECK(ratio > 3);
    CHECK(ratio < 30);
}

TEST_CASE("a report prints one table per study", "[report]") {
    const std::string text = table_of(one_row(0.25));
    INFO(text);
    for (const char* const part :
         {"99_test", "far, \"very\" far", mine.c_str(), "a,b", "0.25", "2.5"})
        CHECK(text.find(part) != std::string::npos);
}
