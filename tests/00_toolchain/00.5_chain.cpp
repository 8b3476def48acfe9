#include <rt/chain.hpp>
#include <rt/rng.hpp>

#include "checkpoint.hpp"
#include "own_process.hpp"

using namespace checkpoint;
using rt::Link;

namespace {

// A chain whose links are scattered in memory. Its numbers are of any size and sign, with all their
// digits; some are 0, and some equal the number before.
struct Scattered {
    explicit Scattered(int count) : links(static_cast<std::size_t>(count)) {
        rt::Rng rng{5, static_cast<std::uint64_t>(count)};
        while (values.size() < links.size()) {
            const bool again = rng() % 8 == 0 && !values.empty();
            const int power = static_cast<int>(rng() % 60) - 30;
            const Real any = std::scalbn(rng.uniform(-1, 1), rng() % 4 ? 0 : power);
            values.push_back(again ? values.back() : rng() % 8 == 0 ? Real(0) : any);
        }
        std::vector<std::size_t> places(links.size());
        for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
        for (std::size_t i = places.size(); i > 1; --i) std::swap(places[i - 1], places[rng() % i]);
        for (std::size_t i = places.size(); i-- > 0;) {
            Link& link = links[places[i]];
            link = {values[i], first};
            first = &link;
        }
    }

    // The sum, added one by one from the first to the last.
    Real sum() const {
        Real so_far = 0;
        for (const Real value : values) so_far += value;
        return so_far;
    }

    std::vector<Real> values;
    std::vector<Link> links;
    const Link* first = nullptr;
};

// Three million links, side by side in memory.
std::vector<Link> long_chain() {
    std::vector<Link> links(3'000'000);
    for (std::size_t i = 0; i < links.size(); ++i)
        links[i] = {static_cast<Real>(i % 5), i + 1 < links.size() ? &links[i + 1] : nullptr};
    return links;
}

// Where a link leads if that is wrong; empty if it is right. This compares addresses
// and follows none.
std::string misled(const std::vector<Link>& links, std::size_t i) {
    const bool is_last = i + 1 == links.size();
    const Link* const next = links[i].next;
    if (next == (is_last ? nullptr : &links[i + 1])) return {};
    const std::string where =
        "link " + std::to_string(i) + " of " + std::to_string(links.size()) + " leads ";
    if (is_last)
        return where +
               "on, but it is the last one.\nHint: the last link leads to nullptr; links[i].next = "
               "&links[i + 1] must stop one link earlier";
    if (!next)
        return where +
               "nowhere, not to the next link.\nHint: connect each link. `for (auto link : links)` "
               "goes through copies of the links, and `auto&` goes through the links themselves";
    return where +
           "to another address, not to the next link in the same vector.\nHint: the pointer may "
           "lead into the old chain. It may lead into memory that the vector has left: a full "
           "vector moves all its links elsewhere, so connect the links when the vector is "
           "complete. Or it may lead into another vector: a copy has its own memory, so return the "
           "vector whose links you connected";
}

// Whether the links follow each other in memory with the values of the chain.
void check_gathered(const std::vector<Link>& links, const std::vector<Real>& values) {
    INFO("a chain of " << values.size() << " links");
    REQUIRE(links.size() == values.size());
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (links[i].value != values[i]) {
            INFO("the value of link "
                 << i
                 << ".\nHint: the values stay unchanged, in the order of the chain; an int has no "
                    "digits after the decimal point, and a float has only 7 digits");
            const std::string actual = text(links[i].value), expected = text(values[i]);
            REQUIRE(actual == expected);
        }
        const std::string wrong = misled(links, i);
        REQUIRE(wrong == "");
    }
}

void check_sum(const char* of, const Link* first, Real expected_sum, const char* hint) {
    const Real sum = rt::sum_along(first);
    INFO("the sum of " << of << "\nHint: " << hint);
    const std::string expected = text(expected_sum);
    const std::string actual = sum == expected_sum ? expected : text(sum);
    CHECK(actual == expected);
}

const char* const in_order =
    "add the unchanged values link by link, from the first to the last. The sum must be a Real: "
    "`auto sum = 0` is an int, and a float or a long double is rounded differently";

}  // namespace

TEST_CASE("00.5 the values of a chain are added up", "[00.5]") {
    const char* const hint =
        "the sum starts at 0, `Real sum = 0;`: without a value it holds garbage, and `auto sum = "
        "0` is an int, with no digits after the decimal point. The loop for (const Link* link = "
        "first; "
        "link; link = link->next) visits each link once";
    const Link three{Real(0.75), nullptr}, two{-2, &three}, one{Real(4.5), &two};
    check_sum("0.75", &three, Real(0.75), hint);
    check_sum("-2 and 0.75", &two, Real(-1.25), hint);
    check_sum("4.5, -2 and 0.75", &one, Real(3.25), hint);
    const Link zero{0, &one}, start{8, &zero};
    check_sum("8, 0, 4.5, -2 and 0.75", &start, Real(11.25), hint);
}

TEST_CASE("00.5 an empty chain has the sum 0 and gathers nothing", "[00.5]") {
    INFO("Hint: begin with `Real sum = 0;` and with `std::vector<Link> links;`, which has no link");
    CHECK(rt::sum_along(nullptr) == 0);
    CHECK(rt::gathered(nullptr).size() == 0);
}

TEST_CASE("00.5 the gathered links keep the order of the chain", "[00.5]") {
    for (const int count : {1, 2, 3, 10, 50}) {
        const Scattered chain{count};
        const std::vector<Link> links = rt::gathered(chain.first);
        REQUIRE(links.size() == chain.values.size());
        std::vector<Real> values;
        for (const Link& link : links) values.push_back(link.value);
        INFO("Hint: push_back appends; walk the chain from its first link");
        REQUIRE(values == chain.values);
    }
}

TEST_CASE("00.5 each gathered link leads to the next one", "[00.5]") {
    const Scattered chain{10}, other{12};
    const std::vector<Link> links = rt::gathered(chain.first);
    const std::vector<Link> others = rt::gathered(other.first);
    check_gathered(links, chain.values);
    check_gathered(others, other.values);
}

TEST_CASE("00.5 the sum is the same after gathering", "[00.5]") {
    const Scattered chain{50};
    const std::vector<Link> links = rt::gathered(chain.first);
    check_gathered(links, chain.values);
    check_sum("the gathered chain", links.data(), rt::sum_along(chain.first), in_order);
}

TEST_CASE("00.5 the values are added in the order of the chain", "[00.5]") {
    // Floating point numbers are rounded after every step: another order, another sum.
    const Real huge = 2 / rt::epsilon;
    const Link end{1, nullptr}, down{-huge, &end}, one{1, &down}, up{huge, &one};
    check_sum(
        "the values are a huge number, 1, minus the huge number, and 1: the first 1 is lost by "
        "rounding, and the last 1 stays",
        &up, 1, in_order);
    for (int count = 1; count <= 200; ++count) {
        const Scattered chain{count};
        check_sum((std::to_string(count) + " numbers of any size, to the last digit").c_str(),
                  chain.first, chain.sum(), in_order);
    }
}

TEST_CASE("00.5 chains of any length are gathered", "[00.5]") {
    for (int count = 1; count <= 200; ++count) {
        const Scattered chain{count};
        check_gathered(rt::gathered(chain.first), chain.values);
    }
}

TEST_CASE("00.5 a chain of millions of links is gathered correctly", "[00.5][hard]") {
    // Code that reserves room for many links, and connects them while it fills, passes up
    // to that number.
    rt::gathered(nullptr);
    const std::vector<Link> chain = long_chain();
    {
        // The right answer takes a few hundredths of a second.
        const std::string actual = in_own_process(
            [&] { return std::to_string(rt::gathered(chain.data()).size()) + " links"; }, 5);
        INFO(
            "if the program ended, its stack was full, or it took too long.\nHint: use a loop, not "
            "a call for every link, and push_back: inserting at the front moves all the others");
        REQUIRE(actual == "3000000 links");
    }
    const std::vector<Link> links = rt::gathered(chain.data());
    REQUIRE(links.size() == chain.size());
    std::string wrong;
    for (std::size_t i = 0; i < links.size() && wrong.empty(); ++i) {
        if (links[i].next != &links[i] + 1 || links[i].value != chain[i].value)
            wrong = misled(links, i);
        if (wrong.empty() && links[i].value != chain[i].value)
            wrong = "link " + std::to_string(i) + " has a different value";
    }
    CHECK(wrong == "");
}

TEST_CASE("00.5 the gathered chain outlives the old one", "[00.5]") {
    std::vector<Link> links;
    Scattered chain{20};
    {
        std::vector<Link> made = rt::gathered(chain.first);
        links = std::move(made);
        for (Link& link : chain.links) link = {};  // and now the old chain is gone
    }
    check_gathered(links, chain.values);
    check_sum("the gathered chain", links.data(), chain.sum(), in_order);
}

TEST_CASE("00.5 a chain of millions of links does not fill the stack", "[00.5][hard]") {
    rt::sum_along(nullptr);
    const std::vector<Link> chain = long_chain();
    Real expected_sum = 0;
    for (const Link& link : chain) expected_sum += link.value;
    const std::string actual = in_own_process([&] { return text(rt::sum_along(chain.data())); });
    const std::string expected = text(expected_sum);
    INFO(
        "if the program ended, its stack was full.\nHint: use a loop, not a function that calls "
        "itself for the rest of the chain");
    CHECK(actual == expected);
}
