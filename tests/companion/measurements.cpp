#include <app/errors.hpp>
#include <companion/pages/measurements.hpp>

#include "catch.hpp"
#include "temporary_folder.hpp"

using checkpoint::TemporaryFolder;
using checkpoint::write_file;

namespace {

const std::string heading = "study,variant,precision,x,x_name,error,error_name,cost,cost_name\n";

}  // namespace

TEST_CASE("a study's table is read", "[measurements]") {
    const TemporaryFolder folder;
    write_file(folder / "a.csv",
               heading +
                   "\"s, t\",v,float,1e6,n,inf,ulp,2.5,ns\nu,v,double,0,n,0,ulp,1,ns\n"
                   "\"s, t\",w,double,1,n,0.5,ulp,3,ns\n");
    const auto rows = companion::read_measurements(folder / "a.csv");
    REQUIRE(rows.size() == 3);
    CHECK(rows[0].study == "s, t");
    CHECK(rows[0].precision == "float");
    CHECK(rows[0].x == 1e6);
    CHECK(rows[0].error > 1e300);
    CHECK(rows[0].cost == 2.5);
    CHECK(rows[0].cost_name == "ns");
    const auto studies = companion::by_study(rows);
    REQUIRE(studies.size() == 2);
    CHECK(studies[0].size() == 2);
    CHECK(studies[1][0].study == "u");
}

TEST_CASE("what is not a table is refused, with the reason", "[measurements]") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(companion::read_measurements(folder / "missing.csv"), app::Failure);
    write_file(folder / "short.csv", heading + "a,b\n");
    CHECK_THROWS_AS(companion::read_measurements(folder / "short.csv"), app::Failure);
    write_file(folder / "text.csv", heading + "s,v,double,one,n,0,e,1,c\n");
    CHECK_THROWS_AS(companion::read_measurements(folder / "text.csv"), app::Failure);
    write_file(folder / "empty.csv", heading);
    CHECK(companion::read_measurements(folder / "empty.csv").empty());
}

TEST_CASE("a study's name becomes part of a file's name", "[measurements]") {
    CHECK(companion::slug("Far spheres") == "far-spheres");
    CHECK(companion::slug("  b^2 - 4ac: cancels!  ") == "b-2-4ac-cancels");
    CHECK(companion::slug("../../etc") == "etc");
    CHECK(companion::slug("***") == "study");
}
