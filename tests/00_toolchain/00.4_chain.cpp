#include <rt/chain.hpp>
#include <rt/rng.hpp>

#include "checkpoint.hpp"
#include "watched.hpp"

using namespace checkpoint;
using rt::Link;

namespace {

// A chain through scattered places: link number i has the value i + 1.
struct Scattered {
    explicit Scattered(int count) : links(static_cast<std::size_t>(count)) {
        std::vector<std::size_t> places(links.size());
        for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
        rt::Rng rng{5, 5};
        for (std::size_t i = places.size(); i > 1; --i) std::swap(places[i - 1], places[rng() % i]);
        for (std::size_t i = places.size(); i-- > 0;) {
            Link& link = links[places[i]];
            link = {static_cast<Real>(i + 1), first};
            first = &link;
        }
    }
    std::vector<Link> links;
    const Link* first = nullptr;
};

// Where a link leads, compared with where it should; nothing where it is right. It compares
// addresses and follows none.
std::string misled(const std::vector<Link>& links, std::size_t i) {
    const bool is_last = i + 1 == links.size();
    const Link* const next = links[i].next;
    if (next == (is_last ? nullptr : &links[i + 1])) return {};
    const std::string where =
        "link " + std::to_string(i) + " of " + std::to_string(links.size()) + " leads ";
    if (is_last)
        return where +
               "on, and is the last one.\nHint: the last link leads to nullptr; links[i].next = "
               "&links[i + 1] has to stop one link before";
    if (!next)
        return where +
               "nowhere, and not to the link behind it.\nHint: is each link connected? `for (auto "
               "link : links)` goes through copies of them, `auto&` through the links themselves";
    return where +
           "to another place, and not to the link behind it in the same vector.\nHint: not into "
           "the "
           "old chain; not into room that the vector has left since: when it is full it moves all "
           "its links elsewhere, so connect them when all are there; and not into another vector: "
           "a copy lies elsewhere, so return the one that you connected";
}

// Whether the links follow each other in memory with the values 1, 2, 3, ...
void check_gathered(const std::vector<Link>& links, int count) {
    INFO("a chain of " << count << " links");
    REQUIRE(links.size() == static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < links.size(); ++i) {
        INFO("link " << i << ".\nHint: the values must come in the order of the chain");
        REQUIRE(links[i].value == static_cast<Real>(i + 1));
        const std::string wrong = misled(links, i);
        INFO(wrong);
        const bool leads_on = wrong.empty();
        REQUIRE(leads_on);
    }
}

}  // namespace

TEST_CASE("00.4 the values of a chain are added up", "[00.4]") {
    INFO(
        "Hint: the sum starts at 0, `Real sum = 0;`: a variable without a value holds rubbish. And "
        "for (const Link* link = first; link; link = link->next) visits each link once");
    CHECK(rt::sum_along(Scattered{1}.first) == 1);
    const Scattered five{5};
    CHECK(rt::sum_along(five.first) == 15);
    CHECK(rt::sum_along(Scattered{100}.first) == 5050);
}

TEST_CASE("00.4 an empty chain has the sum 0 and gathers nothing", "[00.4]") {
    INFO("Hint: `Real sum = 0;` and `std::vector<Link> links;`, and no link to begin with");
    CHECK(rt::sum_along(nullptr) == 0);
    CHECK(rt::gathered(nullptr).empty());
}

TEST_CASE("00.4 the gathered links come in the order of the chain", "[00.4]") {
    for (const int count : {1, 2, 3, 10}) {
        const Scattered chain{count};
        const std::vector<Link> links = rt::gathered(chain.first);
        REQUIRE(links.size() == static_cast<std::size_t>(count));
        for (std::size_t i = 0; i < links.size(); ++i) {
            INFO("link " << i << " of " << count
                         << ".\nHint: walk from `first` along next, and push_back each value");
            CHECK(links[i].value == static_cast<Real>(i + 1));
        }
    }
}

TEST_CASE("00.4 each gathered link leads to the one behind it", "[00.4]") {
    const Scattered chain{10};
    check_gathered(rt::gathered(chain.first), 10);
}

TEST_CASE("00.4 the sum is the same after gathering", "[00.4]") {
    const Scattered chain{50};
    const std::vector<Link> links = rt::gathered(chain.first);
    check_gathered(links, 50);
    CHECK(rt::sum_along(links.data()) == rt::sum_along(chain.first));
}

TEST_CASE("00.4 the values are added in the order of the chain", "[00.4][hard]") {
    // Floating point numbers are rounded after every step: another order, another sum.
    const Real huge = 2 / rt::epsilon;
    const Link end{1, nullptr}, down{-huge, &end}, one{1, &down}, up{huge, &one};
    INFO(
        "a huge number, 1, minus the huge number, 1: the first 1 is rounded away, the last one "
        "stays.\nHint: add link by link from the first to the last; and is the sum a Real? `auto "
        "sum "
        "= 0` is an int, and a float or a double has other digits than a Real");
    CHECK(rt::sum_along(&up) == 1);
    const Link last{huge, nullptr}, first{1, &last};
    const Link front{-huge, &first};
    CHECK(rt::sum_along(&front) == (Real(1) - huge) + huge);
}

TEST_CASE("00.4 chains of any length are gathered", "[00.4][hard]") {
    for (int count = 1; count <= 200; ++count) {
        const Scattered chain{count};
        check_gathered(rt::gathered(chain.first), count);
    }
}

TEST_CASE("00.4 a chain of a million links leads from each link to the next", "[00.4][hard]") {
    // Whoever reserves room for a few links and connects while it fills passes up to there.
    rt::gathered(nullptr);
    const Scattered chain{1'000'000};
    {
        const bool lives = survives([&] {
            alarm(4);  // the right answer takes some hundredths of a second
            return !rt::gathered(chain.first).empty();
        });
        INFO(
            "the program ended, gathered none, or took too long.\nHint: a loop, no call for every "
            "link, and push_back: what is inserted at the front moves all that is there");
        REQUIRE(lives);
    }
    const std::vector<Link> links = rt::gathered(chain.first);
    REQUIRE(links.size() == 1'000'000);
    std::string wrong;
    for (std::size_t i = 0; i < links.size() && wrong.empty(); ++i) wrong = misled(links, i);
    INFO(wrong);
    const bool all_lead_on = wrong.empty();
    CHECK(all_lead_on);
}

TEST_CASE("00.4 the gathered chain outlives the old one", "[00.4][hard]") {
    std::vector<Link> links;
    {
        Scattered chain{20};
        std::vector<Link> made = rt::gathered(chain.first);
        links = std::move(made);
        for (Link& link : chain.links) link = {};  // and here it goes
    }
    check_gathered(links, 20);
    CHECK(rt::sum_along(links.data()) == 210);
}

TEST_CASE("00.4 a chain of a million links does not fill the stack", "[00.4][hard]") {
    rt::sum_along(nullptr);
    std::vector<Link> links(1'000'000);
    for (std::size_t i = 0; i < links.size(); ++i)
        links[i] = {1, i + 1 < links.size() ? &links[i + 1] : nullptr};
    const bool fine = survives([&] { return rt::sum_along(links.data()) == 1'000'000; });
    INFO("Hint: a loop, not a function that calls itself for the rest of the chain");
    CHECK(fine);
}
