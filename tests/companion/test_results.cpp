#include <companion/check/test_results.hpp>

#include "catch.hpp"

using companion::read_report;

namespace {

// As Catch2 2 writes it; version 3 has one more element around the test cases, and durations.
const std::string test_case = R"(
    <TestCase name="01.1 a &lt; b" tags="[01.1]" filename="x.cpp" line="8">
      <Info>
        expected 2, but yours gives 3.
Hint: look &quot;here&quot;
      </Info>
      <Expression success="false" type="CHECK" filename="x.cpp" line="14">
        <Original>
          computed ==
              vector&lt;int>{2}
        </Original>
        <Expanded>
          3 == 2
        </Expanded>
      </Expression>
      <OverallResult success="false" durationInSeconds="0.1"/>
    </TestCase>
    <TestCase name="01.1 second" tags="[01.1]">
      <OverallResult success="true">
        <StdOut>
here I am
        </StdOut>
      </OverallResult>
    </TestCase>)";

}  // namespace

TEST_CASE("a report of Catch2 2 and of Catch2 3 is read", "[test_results]") {
    for (const std::string& xml :
         {"<?xml version=\"1.0\"?>\n<Catch name=\"p\">\n<Group name=\"p\">" + test_case +
              "<OverallResults successes=\"0\"/></Group></Catch>",
          "<?xml version=\"1.0\"?>\n<Catch2TestRun name=\"p\" rng-seed=\"1\">" + test_case +
              "<OverallResultsCases successes=\"1\"/></Catch2TestRun>"}) {
        const auto tests = read_report(xml);
        REQUIRE(tests.size() == 2);
        CHECK(tests[0].name == "01.1 a < b");
        CHECK_FALSE(tests[0].passed);
        CHECK(tests[0].ended);
        REQUIRE(tests[0].failures.size() == 1);
        CHECK(tests[0].failures[0].expression == "CHECK( computed == vector<int>{2} )");
        CHECK(tests[0].failures[0].expanded == "3 == 2");
        CHECK(tests[0].failures[0].messages ==
              std::vector<std::string>{"expected 2, but yours gives 3.\nHint: look \"here\""});
        CHECK(tests[1].passed);
        CHECK(tests[1].output == "here I am");
    }
}

TEST_CASE("an exercise that is missing is found in its exception", "[test_results]") {
    const auto tests = read_report(R"(<TestCase name="01.4 x">
      <Exception filename="x.cpp" line="1">
        exercise 01.1 is still to be written: exercises/01_vectors/rt/dot.hpp:10, explained in
      </Exception><OverallResult success="false"/></TestCase>)");
    REQUIRE(tests.size() == 1);
    CHECK(missing_exercise(tests[0]) == "01.1");
    CHECK(companion::missing_exercise({}) == "");
}

TEST_CASE("a report that ends anywhere is read as far as it goes", "[test_results]") {
    const std::string whole = "<Catch name=\"p\">" + test_case + "</Catch>";
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        const auto tests = read_report(whole.substr(0, length));
        REQUIRE(tests.size() <= 2);
    }
    const auto cut = read_report(whole.substr(0, whole.find("<OverallResult")));
    REQUIRE(cut.size() == 1);
    CHECK_FALSE(cut[0].ended);
    CHECK(cut[0].failures.size() == 1);
}

TEST_CASE("a crash is told with the test case in which it came", "[test_results]") {
    const auto tests = read_report(
        "<TestCase name=\"01.1 x\"><FatalErrorCondition filename=\"x\" line=\"1\">\n SIGSEGV - "
        "Segmentation violation signal\n</FatalErrorCondition><OverallResult success=\"false\"/>"
        "</TestCase>");
    REQUIRE(tests.size() == 1);
    CHECK(tests[0].crash == "SIGSEGV - Segmentation violation signal");
    CHECK_FALSE(tests[0].passed);
}
