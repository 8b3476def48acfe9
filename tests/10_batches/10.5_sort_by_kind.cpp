#include <rt/rng.hpp>
#include <rt/sort_by_kind.hpp>
#include <vector>

#include "checkpoint.hpp"

namespace {

template <std::size_t count>
void check_sort(const std::vector<std::uint8_t>& kinds) {
    std::vector<std::uint32_t> sorted(kinds.size(), 0xdeadbeef);
    const std::vector<std::uint8_t> before = kinds;
    const auto first = rt::sort_by_kind<count>(kinds, sorted);
    INFO(kinds.size() << " numbers of " << count << " kinds");
    std::size_t place = 0;
    for (std::size_t kind = 0; kind < count; ++kind) {
        {
            INFO("Hint: [k] is how many numbers have a kind less than k");
            INFO("the first of kind " << kind);
            REQUIRE(first[kind] == place);
        }
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            if (kinds[i] != kind) continue;
            INFO("Hint: the numbers of a kind stay in their order");
            INFO("place " << place << ", of kind " << kind);
            REQUIRE(sorted[place] == i);
            ++place;
        }
    }
    INFO("Hint: the last of the results is the length of the list");
    REQUIRE(first[count] == kinds.size());
    REQUIRE(kinds == before);
}

std::vector<std::uint8_t> some_kinds(rt::Rng& rng, std::size_t size, unsigned most) {
    std::vector<std::uint8_t> kinds(size);
    for (std::uint8_t& kind : kinds) kind = static_cast<std::uint8_t>(rng() % most);
    return kinds;
}

}  // namespace

TEST_CASE("10.5 each kind has its part of the list", "[10.5]") {
    check_sort<3>({2, 0, 1, 0, 2, 2});
    check_sort<3>({1, 1, 1});
    check_sort<2>({0, 1});
}

TEST_CASE("10.5 random kinds", "[10.5]") {
    rt::Rng rng{105, 1};
    for (int round = 0; round < 400; ++round) {
        const std::size_t size = rng() % 300;
        check_sort<2>(some_kinds(rng, size, 2));
        check_sort<5>(some_kinds(rng, size, 5));
        check_sort<9>(some_kinds(rng, size, 3));  // of six kinds there are none
        check_sort<256>(some_kinds(rng, size, 256));
    }
}

TEST_CASE("10.5 no number at all and one kind alone", "[10.5][hard]") {
    check_sort<1>({});
    check_sort<8>({});
    check_sort<1>({0, 0, 0});
    check_sort<8>({7, 7, 7, 7});
    check_sort<8>({0});
    rt::Rng rng{105, 2};
    check_sort<8>(some_kinds(rng, 200'000, 8));
}
