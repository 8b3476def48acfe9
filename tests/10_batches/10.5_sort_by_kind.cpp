#include <rt/rng.hpp>
#include <rt/sort_by_kind.hpp>
#include <vector>

#include "checkpoint.hpp"
#include "fenced.hpp"

using checkpoint::Fenced;

namespace {

using Paths = std::vector<std::uint32_t>;
using Kinds = std::vector<unsigned>;

constexpr std::uint32_t unwritten = 0xdeadbeef;  // no list has this path

template <class Numbers>
std::string text(const Numbers& numbers) {
    std::string all;
    for (std::size_t i = 0; i < numbers.size() && i < 12; ++i)
        all += ' ' + std::to_string(numbers[i]);
    return '{' + all + (numbers.size() > 12 ? " ... }" : " }");
}

// What sort_by_kind makes of a list of paths of these kinds. `beside` is the value before and after
// the masks.
template <std::size_t count>
void check_sort(const Paths& list, const Kinds& kinds, std::uint8_t beside) {
    std::array<std::size_t, count + 1> first_expected{};
    Paths sorted_expected;
    std::vector<std::uint8_t> masks;
    for (const unsigned kind : kinds) masks.push_back(static_cast<std::uint8_t>(1u << kind));
    for (std::size_t kind = 0; kind < count; ++kind) {
        for (std::size_t i = 0; i < kinds.size(); ++i)
            if (kinds[i] == kind) sorted_expected.push_back(list[i]);
        first_expected[kind + 1] = sorted_expected.size();
    }
    Fenced<std::uint32_t> from{list, 123'456'789};
    Fenced<std::uint8_t> marks{masks, beside};
    Fenced<std::uint32_t> to{2 * list.size(), unwritten, unwritten, 3 * list.size() + 64};
    const auto first = rt::sort_by_kind<count>(from.span(), marks.data(), to.data());
    const Paths sorted(to.data(), to.data() + list.size());
    const bool is_right = first == first_expected && sorted == sorted_expected && to.stands();
    if (!is_right) {
        INFO(list.size() << " paths " << text(list) << " of the kinds " << text(kinds));
        for (std::size_t kind = 0; kind <= count; ++kind) {
            INFO("the result's [" << kind << "]: " EXPECTED << first_expected[kind] << ", " ACTUAL
                                  << first[kind]);
            INFO(
                "Hint: element [k] is the number of paths whose kind is less than k; the last "
                "element counts all");
            REQUIRE(first[kind] == first_expected[kind]);
        }
        {
            INFO(
                "Hint: `to` has room for twice as many paths as the list has, and no more: do not "
                "write to the memory before or after it");
            REQUIRE(to.stands());
        }
        for (std::size_t place = 0; place < sorted.size(); ++place) {
            if (sorted[place] == sorted_expected[place]) continue;
            INFO("to[" << place << "]: " EXPECTED "path " << sorted_expected[place] << ", " ACTUAL
                       << sorted[place]
                       << (sorted[place] == unwritten
                               ? ", which means that nothing was written there"
                               : ""));
            INFO(
                "Hint: write the paths list[i], not their indices i or their masks; paths of the "
                "same kind keep their order, and each kind begins where the one before it ends");
            REQUIRE(sorted[place] == sorted_expected[place]);
        }
    }
    CHECK(is_right);
}
template <std::size_t count>
void check_sort(const Paths& list, const Kinds& kinds) {
    check_sort<count>(list, kinds, 0);
    check_sort<count>(list, kinds, 0xff);
}

// So many paths of some of these kinds, in an order without rule, with numbers below `most`.
struct Some {
    Paths list;
    Kinds kinds;
};
Some some_paths(rt::Rng& rng, std::size_t size, unsigned kinds, std::uint32_t most = 4096) {
    Some some;
    for (std::size_t i = 0; i < size; ++i) {
        some.list.push_back(rng() % most);
        some.kinds.push_back(rng() % kinds);
    }
    return some;
}
template <std::size_t count>
void check_some(rt::Rng& rng, std::size_t size, unsigned kinds, std::uint32_t most = 4096) {
    const auto [list, of_kind] = some_paths(rng, size, kinds, most);
    check_sort<count>(list, of_kind);
}

}  // namespace

TEST_CASE("10.5 each kind has its part of the list", "[10.5]") {
    check_sort<3>({0, 1, 2, 3, 4, 5}, {2, 0, 1, 0, 2, 2});
    check_sort<3>({7, 8, 9}, {1, 1, 1});
    check_sort<2>({5, 3}, {1, 0});
}

TEST_CASE("10.5 lists of random kinds are sorted", "[10.5]") {
    rt::Rng rng{105, 1};
    for (std::size_t size = 1; size < 150; ++size) {
        check_some<2>(rng, size, 2);
        check_some<5>(rng, size, 5);
        check_some<8>(rng, size, 8);
        check_some<8>(rng, size, 3);  // five of the kinds do not occur
    }
}

TEST_CASE("10.5 an empty list and a list of one kind are sorted", "[10.5][hard]") {
    check_sort<1>({}, {});
    check_sort<8>({}, {});
    check_sort<1>({2, 1, 0}, {0, 0, 0});
    check_sort<8>({4, 5, 6, 7}, {7, 7, 7, 7});
    check_sort<8>({9}, {0});
    check_sort<8>({1, 0}, {3, 3});
}

TEST_CASE("10.5 a list of 200000 paths with any numbers is sorted", "[10.5][hard]") {
    rt::Rng rng{105, 3};
    check_some<8>(rng, 200'000, 8, 0xffff'ffff);
    check_some<8>(rng, 200'000, 1, 0xffff'ffff);
}
