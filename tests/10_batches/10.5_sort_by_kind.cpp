#include <rt/rng.hpp>
#include <rt/sort_by_kind.hpp>
#include <vector>

#include "checkpoint.hpp"
#include "fenced.hpp"
#include "processor_time.hpp"

using checkpoint::Fenced;

namespace {

using Kinds = std::vector<std::uint8_t>;

template <class Numbers>
std::string text(const Numbers& numbers) {
    std::string all;
    for (std::size_t i = 0; i < numbers.size() && i < 12; ++i)
        all += ' ' + std::to_string(numbers[i]);
    return '{' + all + (numbers.size() > 12 ? " ... }" : " }");
}

// What sort_by_kind makes of a list of kinds. `beside` is the value before and after the list.
template <std::size_t count>
void check_sort(const Kinds& kinds, std::uint8_t beside) {
    std::array<std::size_t, count + 1> first_expected{};
    std::vector<std::uint32_t> sorted_expected;
    for (std::size_t kind = 0; kind < count; ++kind) {
        for (std::size_t i = 0; i < kinds.size(); ++i)
            if (kinds[i] == kind) sorted_expected.push_back(static_cast<std::uint32_t>(i));
        first_expected[kind + 1] = sorted_expected.size();
    }
    Fenced<std::uint8_t> from{kinds, beside};
    Fenced<std::uint32_t> to{kinds.size(), 0xdeadbeef, 0xdeadbeef};
    const auto first = rt::sort_by_kind<count>(from.span(), to.span());
    const std::vector<std::uint32_t> sorted(to.data(), to.data() + to.size());
    const bool is_right = first == first_expected && sorted == sorted_expected && to.stands();
    if (!is_right) {
        INFO(kinds.size() << " numbers of " << count << " kinds " << text(kinds));
        for (std::size_t kind = 0; kind <= count; ++kind) {
            INFO("the result's [" << kind << "]: expected " << first_expected[kind]
                                  << ", but yours gives " << first[kind]);
            INFO(
                "Hint: element [k] is the count of numbers whose kind is less than k; the last "
                "element counts all");
            REQUIRE(first[kind] == first_expected[kind]);
        }
        {
            INFO(
                "Hint: `sorted` is as long as `kinds`; write nothing outside of it. Does each kind "
                "begin at its own index, and does this index grow by one?");
            REQUIRE(to.stands());
        }
        for (std::size_t place = 0; place < sorted.size(); ++place) {
            if (sorted[place] == sorted_expected[place]) continue;
            INFO("sorted[" << place << "]: expected " << sorted_expected[place] << ", of kind "
                           << int(kinds[sorted_expected[place]]) << ", but yours gives "
                           << sorted[place]
                           << (sorted[place] == 0xdeadbeef
                                   ? ", which means that nothing was written there"
                                   : ""));
            INFO(
                "Hint: write the numbers i, not their kinds; numbers of the same kind keep their "
                "order");
            REQUIRE(sorted[place] == sorted_expected[place]);
        }
    }
    CHECK(is_right);
}
template <std::size_t count>
void check_sort(const Kinds& kinds) {
    check_sort<count>(kinds, 0);
    check_sort<count>(kinds, static_cast<std::uint8_t>(count - 1));
}

Kinds some_kinds(rt::Rng& rng, std::size_t size, unsigned most) {
    Kinds kinds(size);
    for (std::uint8_t& kind : kinds) kind = static_cast<std::uint8_t>(rng() % most);
    return kinds;
}

}  // namespace

TEST_CASE("10.5 each kind has its part of the list", "[10.5]") {
    check_sort<3>({2, 0, 1, 0, 2, 2});
    check_sort<3>({1, 1, 1});
    check_sort<2>({0, 1});
}

TEST_CASE("10.5 lists of random kinds are sorted", "[10.5]") {
    rt::Rng rng{105, 1};
    for (std::size_t size = 1; size < 150; ++size) {
        check_sort<2>(some_kinds(rng, size, 2));
        check_sort<5>(some_kinds(rng, size, 5));
        check_sort<8>(some_kinds(rng, size, 8));
        check_sort<9>(some_kinds(rng, size, 3));  // six of the kinds do not occur
    }
}

TEST_CASE("10.5 an empty list and a list of one kind are sorted", "[10.5][hard]") {
    check_sort<1>({});
    check_sort<8>({});
    check_sort<1>({0, 0, 0});
    check_sort<8>({7, 7, 7, 7});
    check_sort<8>({0});
    check_sort<8>({3, 3});
}

TEST_CASE("10.5 a list of 256 kinds is sorted", "[10.5][hard]") {
    rt::Rng rng{105, 2};
    check_sort<256>({255});
    for (const std::size_t size : {1, 10, 1000, 5000}) check_sort<256>(some_kinds(rng, size, 256));
}

TEST_CASE("10.5 a list of 200000 paths is sorted correctly in less than a second", "[10.5][hard]") {
    rt::Rng rng{105, 3};
    const Kinds kinds = some_kinds(rng, 200'000, 8);
    std::vector<std::uint32_t> sorted(kinds.size());
    const double begin = checkpoint::processor_seconds();
    rt::sort_by_kind<8>(kinds, sorted);
    const double seconds = checkpoint::processor_seconds() - begin;
    {
        INFO("200000 numbers: expected a few thousandths of a second, but yours takes " << seconds
                                                                                        << " s");
        INFO(
            "Hint: the time must be in proportion to the list's length: go through the list twice, "
            "without an inner loop");
        REQUIRE(seconds < 1);
    }
    check_sort<8>(kinds);
    check_sort<8>(Kinds(kinds.size(), 6));
}
