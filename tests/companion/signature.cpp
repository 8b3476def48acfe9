#include <companion/check/recognition.hpp>
#include <companion/check/signature.hpp>
#include <companion/model/mistakes.hpp>

#include "catch.hpp"

using namespace companion;

namespace {

TestCase failing(const std::string& name, const std::string& expanded,
                 const std::string& messages = "") {
    TestCase test;
    test.name = name;
    test.ended = true;
    test.failures.push_back({"CHECK( a == b )", expanded, "", {{messages, "", ""}}, ""});
    return test;
}

}  // namespace

TEST_CASE("numbers are rounded and names are not", "[signature]") {
    CHECK(with_rounded_numbers("210.0 == 3210 (0xc8a)") == "210 == 3.21e+03 (3.21e+03)");
    CHECK(with_rounded_numbers("0.30000000000000004 != 0.3") == "0.3 != 0.3");
    CHECK(with_rounded_numbers("(-nan, nan)") == "(nan, nan)");
    CHECK(with_rounded_numbers("vec3 v1.x -4.5e-200 1e400 .25") == "vec3 v1.x -4.5e-200 inf 0.25");
}

TEST_CASE("a signature knows test case, expression and values but no rounding", "[signature]") {
    const Signature one = signature_of({failing("01.1 x", "1.0 == 2.0", "yours 0.1")});
    CHECK(one == signature_of({failing("01.1 x", "1.00001 == 2", "yours 0.10000001")}));
    CHECK_FALSE(one == signature_of({failing("01.1 x", "1.0 == 3.0", "yours 0.1")}));
    CHECK_FALSE(one == signature_of({failing("01.1 y", "1.0 == 2.0", "yours 0.1")}));
    CHECK(similarity(one, one) == 1);
    CHECK(similarity(one, {}) == 0);
    CHECK(similarity(one, signature_of({failing("01.1 x", "1 == 3", "yours 0.1")})) == 0.5);
}

TEST_CASE("of the messages the last one with an expected value is in the signature",
          "[signature]") {
    const auto saying = [](const std::vector<Message>& messages) {
        TestCase test = failing("01.1 x", "1 == 2");
        test.failures.front().messages = messages;
        return signature_of({test});
    };
    const Message before{"expected 1", "1", ""}, last{"expected 2", "2", ""}, note{"row 3", "", ""};
    CHECK(saying({before, last, note}) == saying({last}));
    CHECK(saying({note, before}) == saying({before}));
    CHECK_FALSE(saying({before}) == saying({last}));
    CHECK(saying({before, note}).what != saying({note}).what);
    CHECK(saying({{"column 4", "", ""}, note}) == saying({note}));
}

TEST_CASE("of many failures an even sample is kept", "[signature]") {
    std::vector<TestCase> some, more;
    for (int i = 0; i < 2000; ++i) {
        const TestCase test = failing("01.1 x", std::to_string(i % 1000) + " == 1");
        if (i < 500) some.push_back(test);
        more.push_back(test);
    }
    const Signature half = signature_of(some), all = signature_of(more);
    CHECK(all.what.size() < 100);
    CHECK(similarity(all, all) == 1);
    CHECK(similarity(half, all) > 0.5);
    CHECK(similarity(half, all) < 1);
}

TEST_CASE("what is still to be written is no mistake", "[signature]") {
    TestCase test;
    test.name = "01.1 x";
    test.ended = true;
    test.failures.push_back({"", "", "whatever it says", {}, "01.1"});
    CHECK(signature_of({test}).where.empty());
    CHECK(recognize({{"01.1_a", {}}}, "01.1", signature_of({test})).empty());
}

TEST_CASE("a mistake is recognized by its failures, and only within its exercise", "[signature]") {
    const Signature a = signature_of({failing("01.1 x", "1 == 2"), failing("01.1 y", "1 == 2")});
    const Signature b = signature_of({failing("01.1 x", "5 == 6"), failing("01.1 z", "5 == 6")});
    const Signatures known{{"01.1_a", a}, {"01.1_b", b}, {"01.1_b_again", b}, {"01.2_a", a}};
    using Names = std::vector<LookAlikes>;
    CHECK(recognize(known, "01.1", a) == Names{{"01.1_a"}});
    CHECK(recognize(known, "01.1", b) == Names{{"01.1_b", "01.1_b_again"}});
    CHECK(recognize(known, "01.2", a) == Names{{"01.2_a"}});
    CHECK(recognize(known, "01.3", a).empty());
    CHECK(recognize(known, "01.1", {}).empty());
    CHECK(recognize(known, "01.1", signature_of({failing("01.1 q", "7 == 8")})).empty());
    // Both at once.
    CHECK(recognize(known, "01.1",
                    signature_of({failing("01.1 x", "1 == 2"), failing("01.1 y", "1 == 2"),
                                  failing("01.1 x", "5 == 6"), failing("01.1 z", "5 == 6")})) ==
          Names{{"01.1_a"}, {"01.1_b", "01.1_b_again"}});
    // Too far from both.
    CHECK(recognize(known, "01.1",
                    signature_of({failing("01.1 x", "1 == 2"), failing("01.1 y", "1 == 2"),
                                  failing("01.1 q", "7 == 8")}))
              .empty());
}
